// Speed: the length of dX/du over the metric channels, its square and its minima.
//
// Each channel's derivative is a quadratic, expanded about the nearer end of the segment, as in segment.hpp: in half 0
// it is one in v = u, for v in [0, 1/2]; in half 1 in v = u - 1, for v in [-1/2, 0]. Units: a power of two, so that
// squares neither overflow nor vanish.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tcb/spline/double_pair.hpp"
#include "tcb/spline/scalar.hpp"
#include "tcb/spline/segment.hpp"

namespace tcb::spline {

/// k0 + v (k1 + v k2): one channel's derivative about one end.
template <class S>
struct Quadratic {
  S k0, k1, k2;
  S operator()(const S& v) const { return k0 + v * (k1 + v * k2); }
  S slope(const S& v) const { return k1 + S(2) * (v * k2); }
};

/// A polynomial of fourth degree: its coefficients, from the constant up.
template <class T>
using Quartic = std::array<T, 5>;

/// Adds the square of x at middle + width z, in powers of z.
template <class T>
void add_square(Quartic<T>& sum, const Quadratic<T>& x, const T& middle, const T& width) {
  const T a = x(middle);
  const T b = width * x.slope(middle);
  const T c = width * width * x.k2;
  sum[0] = sum[0] + a * a;
  sum[1] = sum[1] + T(2) * a * b;
  sum[2] = sum[2] + (b * b + T(2) * a * c);
  sum[3] = sum[3] + T(2) * b * c;
  sum[4] = sum[4] + c * c;
}

template <class S>
class Speed {
 public:
  Speed() = default;
  Speed(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) { assign(segment, metric); }

  /// Assigns another segment. `metric` lists the channels of the speed; empty: all.
  void assign(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) {
    const std::size_t size = metric.empty() ? segment.size() : metric.size();
    for (auto& half : channels_) half.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      const Cubic<S>& x = segment[metric.empty() ? i : metric[i]];
      channels_[0][i] = {x.out, S(2) * x.c, S(3) * x.d};
      channels_[1][i] = {x.in, S(2) * x.e, S(3) * x.d};
    }
    rescale();
  }

  /// Whether no coefficient of the segment is infinite or NaN.
  bool is_finite() const { return finite_; }

  /// The unit of all speeds and lengths, a power of two; 0 if the segment is constant. Requires: is_finite().
  const S& unit() const { return unit_; }

  /// Whether the speed is constant.
  bool is_constant() const {
    return std::ranges::all_of(channels_[0], [](const auto& x) { return x.k1 == S(0) && x.k2 == S(0); });
  }

  S operator()(std::size_t half, const S& v) const {
    S sum(0);
    for (const auto& x : channels_[half]) sum += x(v) * x(v);
    return square_root(sum);
  }

  /// The speeds at N places.
  template <std::size_t N>
  std::array<S, N> operator()(std::size_t half, const std::array<S, N>& v) const {
    std::array<S, N> sums{};
    for (const auto& [k0, k1, k2] : channels_[half]) {
      for (std::size_t i = 0; i < N; ++i) {
        const S slope = k0 + v[i] * (k1 + v[i] * k2);
        sums[i] += slope * slope;
      }
    }
    for (S& sum : sums) sum = square_root(sum);
    return sums;
  }

  /// The square of the speed at middle + width z, in powers of z.
  Quartic<S> square_about(std::size_t half, const S& middle, const S& width) const {
    Quartic<S> sum{};
    for (const auto& x : channels_[half]) add_square(sum, x, middle, width);
    return sum;
  }

  /// As square_about(), for two places, computed as a pair.
  auto squares_about(const std::array<std::size_t, 2>& halves, const std::array<S, 2>& middle,
                     const std::array<S, 2>& width) const {
    auto middles = pair_of(middle[0], middle[1]), widths = pair_of(width[0], width[1]);
    using T = decltype(middles);
    Quartic<T> sum;
    sum.fill(T(0.0));
    for (std::size_t i = 0; i < channels_[0].size(); ++i) {
      const auto& x = channels_[halves[0]][i];
      const auto& y = channels_[halves[1]][i];
      add_square(sum, {pair_of(x.k0, y.k0), pair_of(x.k1, y.k1), pair_of(x.k2, y.k2)}, middles, widths);
    }
    return sum;
  }

  /// speed * d speed/dv, which has the sign of the derivative of the speed.
  S growth(std::size_t half, const S& v) const {
    S sum(0);
    for (const auto& x : channels_[half]) sum += x(v) * x.slope(v);
    return sum;
  }

  /// The coefficients of growth(), a cubic in v, from the constant up.
  std::array<S, 4> growth_coefficients(std::size_t half) const {
    std::array<S, 4> sum{};
    for (const auto& [k0, k1, k2] : channels_[half]) {
      sum[0] += k0 * k1;
      sum[1] += k1 * k1 + S(2) * k0 * k2;
      sum[2] += S(3) * k1 * k2;
      sum[3] += S(2) * k2 * k2;
    }
    return sum;
  }

 private:
  void rescale() {
    using std::abs;
    S largest(0), nothing(0);
    for (const auto& half : channels_) {
      for (const auto& [k0, k1, k2] : half) {
        largest = std::max({largest, S(abs(k0)), S(abs(k1)), S(abs(k2))});
        nothing += S(0) * k0 + S(0) * k1 + S(0) * k2;  // NaN if one of them is infinite
      }
    }
    unit_ = S(0);
    finite_ = nothing == S(0);
    if (largest == S(0) || !finite_) return;
    unit_ = power_of_two_below(largest);
    const S scale = S(1) / unit_;
    for (auto& half : channels_) {
      for (auto& [k0, k1, k2] : half) {
        k0 *= scale;
        k1 *= scale;
        k2 *= scale;
      }
    }
  }

  std::array<std::vector<Quadratic<S>>, 2> channels_;
  S unit_{0};
  bool finite_ = true;
};

/// The zero of growth() in [low, high], where it rises from below 0 to above.
template <class S>
S slowest_place(const Speed<S>& speed, std::size_t half, S low, S high) {
  using std::abs;
  const auto [g0, g1, g2, g3] = speed.growth_coefficients(half);
  S v = low + (high - low) * S(0.5);
  for (int step = 0; step < 2 * std::numeric_limits<S>::digits; ++step) {
    const S growth = speed.growth(half, v);
    if (growth == S(0)) break;
    (growth < S(0) ? low : high) = v;
    const S newton = v - growth / (g1 + v * (S(2) * g2 + v * (S(3) * g3)));
    const S next = low < newton && newton < high ? newton : low + (high - low) * S(0.5);
    const bool settled = abs(next - v) <= std::numeric_limits<S>::epsilon() * abs(v);
    v = next;
    if (settled || v <= low || v >= high) break;
  }
  return v;
}

/// The places in (begin, end) at which the speed has a minimum: at most two, in order.
template <class S>
std::vector<S> slowest_places(const Speed<S>& speed, std::size_t half, const S& begin, const S& end) {
  // growth() is monotone between the zeros of its derivative, which is a quadratic.
  const auto [g0, g1, g2, g3] = speed.growth_coefficients(half);
  std::vector<S> fence{begin};
  const S p = g2 / S(3);
  const S discriminant = p * p - g1 * g3 / S(3);
  if (g3 != S(0) && discriminant > S(0)) {
    const S root = square_root(discriminant);
    for (const S& v : {(-p - root) / g3, (root - p) / g3}) {
      if (v > begin && v < end) fence.push_back(v);
    }
  }
  fence.push_back(end);
  std::vector<S> places;
  for (std::size_t i = 0; i + 1 < fence.size(); ++i) {
    if (!(speed.growth(half, fence[i]) < S(0) && speed.growth(half, fence[i + 1]) > S(0))) continue;
    const S v = slowest_place(speed, half, fence[i], fence[i + 1]);
    if (v > begin && v < end) places.push_back(v);
  }
  return places;
}

}  // namespace tcb::spline
