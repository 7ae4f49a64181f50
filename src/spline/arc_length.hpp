// Arc length: how long a segment is, and where on it a given length is reached.
//
// The speed is the root of a quartic in u, smooth but for cusps. Each interval is integrated by a
// Gauss-Legendre rule and halved until the two halves agree with the whole.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "spline/quadrature.hpp"
#include "spline/segment.hpp"

namespace tcb::spline {

/// The speed |dX/du| of one segment over the metric channels.
template <class S>
class Speed {
 public:
  /// `metric` lists the channels that count; empty: all.
  Speed(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) {
    if (metric.empty()) {
      cubics_.assign(segment.begin(), segment.end());
    } else {
      for (const std::size_t channel : metric) cubics_.push_back(segment[channel]);
    }
    rescale();
  }

  /// In units of scale().
  S operator()(const S& u) const {
    using std::sqrt;
    S sum(0);
    for (const Cubic<S>& x : cubics_) {
      const S slope = first_derivative(x, Local<S>{u, u - S(1)});
      sum += slope * slope;
    }
    return sqrt(sum);
  }

  /// The segment is run through at constant speed.
  bool is_constant() const {
    return std::ranges::all_of(cubics_, [](const Cubic<S>& x) { return x.c == S(0) && x.d == S(0); });
  }

  /// A power of two near the largest slope, so that squares neither overflow nor vanish; 0 for a hold.
  S scale() const { return scale_; }

 private:
  void rescale() {
    using std::frexp, std::ldexp, std::abs;
    S largest(0);
    for (const Cubic<S>& x : cubics_) {
      for (const S& value : {x.out, x.c, x.in, x.e, x.d}) largest = std::max(largest, S(abs(value)));
    }
    if (largest == S(0)) return;
    int exponent = 0;
    (void)frexp(largest, &exponent);
    scale_ = ldexp(S(1), exponent);
    for (Cubic<S>& x : cubics_) {
      for (S* value : {&x.out, &x.c, &x.in, &x.e, &x.d}) *value = ldexp(*value, -exponent);
    }
  }

  std::vector<Cubic<S>> cubics_;
  S scale_{0};
};

/// One Gauss-Legendre sum over [a, b].
template <class S>
S gauss_length(const Speed<S>& speed, const S& a, const S& b) {
  const auto& rule = gauss_rule<S, 16>();
  S sum(0);
  for (std::size_t i = 0; i < rule.node.size(); ++i) sum += rule.weight[i] * speed(a + (b - a) * rule.node[i]);
  return sum * (b - a);
}

/// The length over [a, b] in units of speed.scale(), where `whole` is gauss_length over it.
/// Promises: the error stays below 1e-13 of `total`; `depth` halvings at most, by when [a, b] is
/// so short that what is left of a cusp cannot matter.
template <class S>
S refined_length(const Speed<S>& speed, const S& a, const S& b, const S& whole, const S& total, int depth = 50) {
  using std::abs;
  const S middle = (a + b) * S(0.5);
  const S left = gauss_length(speed, a, middle);
  const S right = gauss_length(speed, middle, b);
  if (depth == 0 || abs(left + right - whole) <= S(1e-14) * total) return left + right;
  return refined_length(speed, a, middle, left, total, depth - 1) +
         refined_length(speed, middle, b, right, total, depth - 1);
}

/// The length over [a, b] in units of speed.scale().
template <class S>
S scaled_length(const Speed<S>& speed, const S& a, const S& b) {
  if (speed.scale() == S(0) || a == b) return S(0);
  if (speed.is_constant()) return speed(S(0)) * (b - a);
  const S whole = gauss_length(speed, a, b);
  return refined_length(speed, a, b, whole, whole);
}

/// The length over [0, u]. Promises: relative error 1e-12.
template <class S>
S length(const Speed<S>& speed, const S& u = S(1)) {
  return scaled_length(speed, S(0), u) * speed.scale();
}

/// The smallest u at which the length from 0 reaches s, for a segment of the given total length.
/// Requires: 0 <= s <= total. Promises: right to 1e-12 of the total; at most 100 steps.
template <class S>
S parameter_at(const Speed<S>& speed, const S& s, const S& total) {
  using std::abs;
  if (s <= S(0)) return S(0);
  if (s >= total) return S(1);
  if (speed.is_constant()) return s / total;
  const S target = s / speed.scale();
  const S enough = total / speed.scale() * S(1e-15);
  S low(0), high(1), u = s / total, from(0), reached(0);
  for (int step = 0; step < 100; ++step) {
    reached += u >= from ? scaled_length(speed, from, u) : -scaled_length(speed, u, from);
    from = u;
    const S missing = target - reached;
    if (abs(missing) <= enough) break;
    (missing > S(0) ? low : high) = u;
    const S newton = u + missing / speed(u);
    u = low < newton && newton < high ? newton : (low + high) * S(0.5);
    if (u <= low || u >= high) break;
  }
  return u;
}

}  // namespace tcb::spline
