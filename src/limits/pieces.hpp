// Pieces: the parts of segments in which all channels are polynomials, and what is measured on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "limits/polynomial.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb::limits {

/// What is measured: a derivative by time of a channel or of several, or how fast their direction changes.
struct Measure {
  enum class Kind {
    largest,
    smallest,
    size,           ///< the root of the sum of squares
    curvature,      ///< the change of the direction of the velocity, per length
    angular_speed,  ///< twice the change of the direction of four channels, a quaternion, per time
  };
  std::string name;
  Kind kind = Kind::size;
  int derivative = 0;  ///< of the power of the time by which it becomes smaller where that is longer
  std::vector<std::size_t> channels;
  bool is_signed = false;              ///< it is of one channel, and may have limits on both sides
  bool is_of_rotation = false;         ///< its channels are numbers of a rotation, or the angle of its turn
  std::optional<Rational> limit = {};  ///< of its maximum in the form of an Extreme, which is to be decided

  bool is_size() const { return kind != Kind::largest && kind != Kind::smallest; }
  /// A limit in the form of an Extreme.
  Rational as_measured(const Rational& bound) const {
    if (is_size()) return bound * bound;
    return kind == Kind::smallest ? -bound : bound;
  }
  bool is_of_direction() const { return kind == Kind::curvature || kind == Kind::angular_speed; }
};

/// A part of a segment on which all channels are polynomials of the part of its time that has passed, from 0 to 1.
template <class S>
struct Piece {
  S begin, size;                           ///< fractions of the duration of the segment
  S duration;                              ///< of the piece
  Polynomial<S> parameter;                 ///< the local parameter of the segment
  std::vector<Polynomial<S>> cubics = {};  ///< one per channel, over the local parameter
  std::vector<bool> rests = {};            ///< of each channel: both its tangents are 0

  bool is_whole() const { return parameter.size() == 2 && parameter[0] == S(0) && parameter[1] == S(1); }
};

/// The local parameter over a part of the duration of a segment, as a polynomial of the fraction of this part.
template <class S>
struct WarpPart {
  S begin, size;
  Polynomial<S> parameter;
};

/// For Warp see tcb/spline/ease.hpp, whose letters these are: the parts end at A = kf and B = 1 - ke, k = 1 + (A -
/// B)/2. Doubles always have a middle part, as they cannot tell whether there is one.
template <class S>
std::vector<WarpPart<S>> parts_of(const spline::Warp<S>& warp) {
  const S zero(0), one(1), two(2);
  if (warp.is_identity()) return {{zero, one, {zero, one}}};
  if (warp.is_cubic()) {
    const S a = warp.first_derivative(zero), b = warp.first_derivative(one);
    return {{zero, one, {zero, a, S(3) - two * a - b, a + b - two}}};
  }
  const S first = warp.end_of_first_part(), last = warp.start_of_last_part();
  const S k = one + (first - last) / two, f = first / k, e = (one - last) / k;
  S middle = one - f - e;
  if constexpr (std::is_same_v<S, double>) middle = std::max(middle, 0x1p-44);
  std::vector<WarpPart<S>> parts;
  if (zero < f) parts.push_back({zero, f, {zero, zero, first}});
  if (zero < middle) parts.push_back({f, middle, {first, two * k * middle}});
  if (zero < e) parts.push_back({one - e, e, {last, two * (one - last), last - one}});
  return parts;
}

/// Whether a number is 0, and known to be so.
template <class S>
bool is_exactly_zero(const S& number) {
  return number == S(0);
}

/// The pieces of a segment between two fractions of its duration.
template <class S>
std::vector<Piece<S>> pieces_of(const spline::Segments<S>& segments, std::size_t segment, const S& duration,
                                const S& from, const S& to) {
  std::vector<Piece<S>> pieces;
  for (const auto& [begin, size, parameter] : parts_of(segments.warp(segment))) {
    const S first = begin < from ? (from - begin) / size : S(0);
    const S last = to < S(1) && to < begin + size ? (to - begin) / size : S(1);
    if (!(first < last)) continue;
    const S width = (last - first) * size;
    const bool is_cut = first != S(0) || last != S(1);
    Piece<S> piece{begin + first * size, width, width * duration,
                   is_cut ? composed(parameter, {first, last - first}) : parameter};
    for (const spline::Cubic<S>& x : segments[segment]) {
      piece.cubics.push_back({x.p0, x.out, x.c + x.c_low, x.d});
      piece.rests.push_back(is_exactly_zero(x.out) && is_exactly_zero(x.in));
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// A measure over a piece: the square of a size, the negative of a number whose smallest value counts. It is `over`, or
/// divided by the power `power` of `base`.
template <class S>
struct Measured {
  Polynomial<S> over{S(0)};
  Polynomial<S> base{S(1)};  ///< at least 0, which is where a curve rests
  int power = 0;
  double scale = 0, base_scale = 0;  ///< of doubles: the sums of the sizes of terms, which bound their rounding

  S at(const S& place) const {
    const S value = value_at(over, place);
    return power == 0 ? value : value / power_of(value_at(base, place), power);
  }
};

/// The sum of the sizes of the coefficients.
template <class S>
S size_of(const Polynomial<S>& x) {
  S sum(0);
  for (const S& coefficient : x) sum = sum + (coefficient < S(0) ? -coefficient : coefficient);
  return sum;
}

/// How often a derivative has the power u^i: i (i - 1) and so on.
inline int derived(std::size_t i, int order) {
  int times = 1;
  for (int k = 0; k < order; ++k) times *= static_cast<int>(i) - k;
  return times;
}

/// The derivative of a channel.
template <class S>
Polynomial<S> rate_of(const Piece<S>& piece, std::size_t channel, int order) {
  S rate(1);
  for (int i = 0; i < order; ++i) rate = rate / piece.duration;
  const auto rate_of = [&](const Polynomial<S>& x) {
    const auto lost = static_cast<std::size_t>(order);
    if (x.size() <= lost) return Polynomial<S>{S(0)};
    Polynomial<S> result(x.size() - lost);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = S(derived(i + lost, order)) * x[i + lost] * rate;
    return result;
  };
  return rate_of(piece.is_whole() ? piece.cubics[channel] : composed(piece.cubics[channel], piece.parameter));
}

/// The sum of the sizes of the terms of a derivative by rate_of(). Coefficients that are far smaller than others have
/// the rounding of these, 2^-90 of them.
inline double scale_of(const Polynomial<double>& rate, const Piece<double>& piece, std::size_t channel, int order) {
  if (is_zero(rate)) return 0;
  const auto sum_of = [&](const Polynomial<double>& terms) {
    double sum = 0;
    for (std::size_t i = order == 0 ? 0 : 1; i < terms.size(); ++i) {
      sum += std::abs(terms[i]) * (derived(i, order) + 0x1p-50 * static_cast<double>(i * i * i));
    }
    for (int i = 0; i < order; ++i) sum /= piece.duration;
    return sum;
  };
  if (piece.is_whole()) return sum_of(piece.cubics[channel]);
  const auto sizes = [](Polynomial<double> x) {
    for (double& coefficient : x) coefficient = std::abs(coefficient);
    return x;
  };
  return sum_of(composed(sizes(piece.cubics[channel]), sizes(piece.parameter)));
}

/// The factor by which doubles are near 1, so that their powers do not overflow.
template <class S>
S unit_of(const std::vector<Polynomial<S>>& numbers) {
  if constexpr (std::is_same_v<S, double>) {
    double largest = 0;
    for (const Polynomial<double>& x : numbers) largest = std::max(largest, size_of(x));
    if (largest > 0 && std::isfinite(largest)) return 1 / spline::power_of_two_below(largest);
  }
  return S(1);
}

/// v a' - v' a, where a is the derivative of v, and a' that of v'. Of irrational numbers with 2,400 bits, terms below
/// 2^-2000 of those that cancel in them are 0.
template <class S>
Polynomial<S> minor_of(const Polynomial<S>& v, const Polynomial<S>& a, const Polynomial<S>& other_v,
                       const Polynomial<S>& other_a) {
  Polynomial<S> minor = sum(product(v, other_a), product(other_v, a), S(-1));
  minor.pop_back();  // which is 0
  if constexpr (std::is_same_v<S, Rational>) {
    static const Rational noise = Rational(0x1p-1000) * Rational(0x1p-1000);
    const Rational least = noise * (size_of(v) * size_of(other_a) + size_of(other_v) * size_of(a));
    for (Rational& coefficient : minor) coefficient = abs(coefficient) < least ? Rational(0) : coefficient;
  }
  return minor;
}

/// How fast the direction of v changes, where a is its derivative: the square is |v ^ a|^2 / |v|^4, and per length of a
/// curve with the velocity v |v ^ a|^2 / |v|^6. `convert`: from polynomials of the piece to those of the result; the
/// first ones show where nothing changes.
template <class To, class S, class Convert>
Measured<To> measured_direction(const Piece<S>& piece, const Measure& measure, const Convert& convert) {
  const bool is_curvature = measure.kind == Measure::Kind::curvature;
  const auto rests = [&](std::size_t channel) { return piece.rests[channel]; };
  if (is_curvature && std::ranges::all_of(measure.channels, rests)) return {};  // it is straight
  std::vector<Polynomial<S>> v, a;
  for (const std::size_t channel : measure.channels) {
    v.push_back(is_curvature ? derivative(piece.cubics[channel]) : piece.cubics[channel]);
  }
  const S unit = unit_of(v);
  const Polynomial<To> parameter = convert(piece.parameter);
  const auto over_piece = [&](const Polynomial<To>& x) { return piece.is_whole() ? x : composed(x, parameter); };
  Measured<To> result{{To(0)}, {To(0)}, is_curvature ? 3 : 2};
  bool changes = false;
  int moving = 0;  // channels
  double change_scale = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (S& coefficient : v[i]) coefficient = coefficient * unit;
    a.push_back(derivative(v[i]));
    const Polynomial<To> x = convert(v[i]);
    result.base = sum(result.base, product(x, x));
    for (std::size_t j = 0; j < i; ++j) {
      const Polynomial<S> minor = minor_of(v[i], a[i], v[j], a[j]);
      const Polynomial<To> y = convert(minor);
      result.over = sum(result.over, product(y, y));
      changes = changes || !is_zero(minor);
    }
    if constexpr (std::is_same_v<S, double>) {
      const double v_size = size_of(v[i]), a_size = size_of(a[i]);
      moving += v_size > 0 ? 1 : 0;
      result.base_scale += v_size * v_size;
      if (a_size > 0) change_scale += power_of(a_size + 0x1p-50 * v_size, 2);  // as for scale_of()
    }
  }
  if constexpr (std::is_same_v<S, double>) {
    changes = moving > 1 && change_scale > 0;  // then |v ^ a| may be up to |v| |a|, and its terms twice that
    const double reach = std::max(1.0, size_of(parameter));  // by which terms may grow
    result.scale = 2 * result.base_scale * change_scale * power_of(reach, static_cast<int>(result.over.size()) - 1);
    result.base_scale *= power_of(reach, static_cast<int>(result.base.size()) - 1);
  }
  if (!changes) return {};
  result.over = over_piece(result.over);
  result.base = over_piece(result.base);
  Polynomial<To> factor = convert(Polynomial<S>{unit});
  if (!is_curvature) {
    Polynomial<S> turn = derivative(piece.parameter);
    for (S& coefficient : turn) coefficient = coefficient * S(2) / piece.duration;
    factor = convert(turn);
  }
  result.over = product(result.over, product(factor, factor));
  if constexpr (std::is_same_v<S, double>) {
    result.scale *= size_of(factor) * size_of(factor);
    if (result.scale < 1e-290) result.scale = std::numeric_limits<double>::infinity();  // doubles do not bound it
  }
  return result;
}

template <class S>
Measured<S> measured(const Piece<S>& piece, const Measure& measure) {
  if (measure.is_of_direction()) {
    return measured_direction<S>(piece, measure, [](const Polynomial<S>& x) { return x; });
  }
  Measured<S> result;
  for (const std::size_t channel : measure.channels) {
    const Polynomial<S> x = rate_of(piece, channel, measure.derivative);
    double scale = 0;
    if constexpr (std::is_same_v<S, double>) scale = scale_of(x, piece, channel, measure.derivative);
    if (measure.is_size()) {
      result.over = sum(result.over, product(x, x));
      result.scale += scale * scale;
    } else {
      result.over = sum(result.over, x, S(measure.kind == Measure::Kind::smallest ? -1 : 1));
      result.scale = scale;
    }
  }
  return result;
}

}  // namespace tcb::limits
