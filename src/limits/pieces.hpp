// Pieces: the parts of segments in which all channels are polynomials, and what is measured on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
  bool is_signed = false;       ///< it is of one channel, and may have limits on both sides
  bool is_of_rotation = false;  ///< its channels are numbers of a rotation, or the angle of its turn

  bool is_size() const { return kind != Kind::largest && kind != Kind::smallest; }
  bool is_of_direction() const { return kind == Kind::curvature || kind == Kind::angular_speed; }
};

/// A part of a segment on which all channels are polynomials of the part of its time that has passed, from 0 to 1.
template <class S>
struct Piece {
  std::size_t number;                      ///< of the part of the ease
  S begin, size;                           ///< fractions of the duration of the segment
  S duration;                              ///< of the piece
  Polynomial<S> parameter;                 ///< the local parameter of the segment
  std::vector<Polynomial<S>> cubics = {};  ///< one per channel, over the local parameter
  std::vector<bool> rests = {};            ///< of each channel: both its tangents are 0

  bool is_whole() const { return parameter == Polynomial<S>{S(0), S(1)}; }
};

/// The local parameter over a part of the duration of a segment, as a polynomial of the fraction of this part.
template <class S>
struct WarpPart {
  std::size_t number;
  S begin, size;
  Polynomial<S> parameter;
};

/// For Warp see tcb/spline/ease.hpp, whose letters these are: the parts end at A = kf and B = 1 - ke, k = 1 + (A -
/// B)/2. Doubles always have a middle part, as they cannot tell whether there is one.
template <class S>
std::vector<WarpPart<S>> parts_of(const spline::Warp<S>& warp) {
  const S zero(0), one(1), two(2);
  if (warp.is_identity()) return {{0, zero, one, {zero, one}}};
  if (warp.is_cubic()) {
    const S a = warp.first_derivative(zero), b = warp.first_derivative(one);
    return {{0, zero, one, {zero, a, S(3) - two * a - b, a + b - two}}};
  }
  const S first = warp.end_of_first_part(), last = warp.start_of_last_part();
  const S k = one + (first - last) / two, f = first / k, e = (one - last) / k;
  S middle = one - f - e;
  if constexpr (std::is_same_v<S, double>) middle = std::max(middle, 0x1p-44);
  std::vector<WarpPart<S>> parts;
  if (zero < f) parts.push_back({0, zero, f, {zero, zero, first}});
  if (zero < middle) parts.push_back({1, f, middle, {first, two * k * middle}});
  if (zero < e) parts.push_back({2, one - e, e, {last, two * (one - last), last - one}});
  return parts;
}

/// The pieces of a segment between two fractions of its duration.
template <class S>
std::vector<Piece<S>> pieces_of(const spline::Segments<S>& segments, std::size_t segment, const S& duration,
                                const S& from, const S& to) {
  std::vector<Piece<S>> pieces;
  for (const auto& [number, begin, size, parameter] : parts_of(segments.warp(segment))) {
    const S first = begin < from ? (from - begin) / size : S(0);
    const S last = to < S(1) && to < begin + size ? (to - begin) / size : S(1);
    if (!(first < last)) continue;
    const S width = (last - first) * size;
    Piece<S> piece{number, begin + first * size, width, width * duration, composed(parameter, {first, last - first})};
    for (const spline::Cubic<S>& x : segments[segment]) {
      piece.cubics.push_back({x.p0, x.out, x.c + x.c_low, x.d});
      piece.rests.push_back(x.out == S(0) && x.in == S(0));
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// A measure over a piece: the square of a size, the negative of a number whose smallest value counts. It is `over`, or
/// divided by the power `power` of `base`.
template <class S>
struct Measured {
  Polynomial<S> over;
  S scale{0};                ///< the sum of the sizes of its terms, which bounds its rounding; 0: it is 0 without any
  Polynomial<S> base{S(1)};  ///< at least 0, which is where a curve rests
  S base_scale{0};
  int power = 0;

  S at(const S& place) const {
    S value = value_at(over, place);
    if (power == 0) return value;
    const S below = value_at(base, place);
    for (int i = 0; i < power; ++i) value = value / below;
    return value;
  }
};

template <class S>
S size_of(const S& x) {
  return x < S(0) ? -x : x;
}
/// The sum of the sizes of the coefficients.
template <class S>
S size_of(const Polynomial<S>& x) {
  S sum(0);
  for (const S& coefficient : x) sum = sum + size_of(coefficient);
  return sum;
}

/// The derivative of a channel, and the sum of the sizes of its terms.
template <class S>
std::pair<Polynomial<S>, S> rate_of(const Piece<S>& piece, std::size_t channel, int order) {
  Polynomial<S> x = piece.is_whole() ? piece.cubics[channel] : composed(piece.cubics[channel], piece.parameter);
  S rate(1), cleared(0);
  for (int i = 0; i < order; ++i) rate = rate / piece.duration;
  // Coefficients that are far smaller than others have the rounding of these, 2^-90 of them.
  for (std::size_t i = 1; i < x.size(); ++i) cleared = cleared + size_of(x[i]) * S(static_cast<int>(i * i * i));
  for (int i = 0; i < order; ++i) x = derivative(x);
  for (S& coefficient : x) coefficient = coefficient * rate;
  S sizes = size_of(x);
  if constexpr (std::is_same_v<S, double>) {
    if (!x.is_zero()) sizes += 0x1p-50 * cleared * rate;
  }
  return {x, sizes};
}

/// How fast the direction of v changes, where a is its derivative: the square is |v ^ a|^2 / |v|^4, and per length of a
/// curve with the velocity v |v ^ a|^2 / |v|^6. `convert`: from polynomials of the piece to those of the result; the
/// first ones show where nothing changes: of irrational numbers with 2,400 bits, terms of v ^ a below 2^-2000 of those
/// that cancel in them are 0.
template <class To, class S, class Convert>
Measured<To> measured_direction(const Piece<S>& piece, const Measure& measure, const Convert& convert) {
  const bool is_curvature = measure.kind == Measure::Kind::curvature;
  const auto rests = [&](std::size_t channel) { return piece.rests[channel]; };
  if (is_curvature && std::ranges::all_of(measure.channels, rests)) return {};  // it is straight
  std::vector<Polynomial<S>> v, a;
  S unit(1);  // of doubles, whose powers do not overflow
  for (const std::size_t channel : measure.channels) {
    v.push_back(is_curvature ? derivative(piece.cubics[channel]) : piece.cubics[channel]);
  }
  if constexpr (std::is_same_v<S, double>) {
    double largest = 0;
    for (const Polynomial<double>& x : v) largest = std::max(largest, size_of(x));
    if (largest > 0 && std::isfinite(largest)) unit = std::ldexp(1.0, -std::ilogb(largest));
  }
  const Polynomial<To> parameter = convert(piece.parameter);
  const auto over_piece = [&](const Polynomial<To>& x) { return piece.is_whole() ? x : composed(x, parameter); };
  Measured<To> result{{To(0)}, To(0), {To(0)}, To(0), is_curvature ? 3 : 2};
  std::vector<S> v_size, a_size;
  bool changes = false;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (S& coefficient : v[i]) coefficient = coefficient * unit;
    a.push_back(derivative(v[i]));
    const Polynomial<To> x = convert(v[i]);
    result.base = sum(result.base, product(x, x));
    for (std::size_t j = 0; j < i; ++j) {
      auto minor = sum(product(v[i], a[j]), product(v[j], a[i]), S(-1)).without_last();  // which is 0
      if constexpr (std::is_same_v<S, Rational>) {
        static const Rational noise = Rational(0x1p-1000) * Rational(0x1p-1000);
        const Rational least = noise * (size_of(v[i]) * size_of(a[j]) + size_of(v[j]) * size_of(a[i]));
        for (Rational& coefficient : minor) coefficient = size_of(coefficient) < least ? Rational(0) : coefficient;
      }
      const Polynomial<To> y = convert(minor);
      result.over = sum(result.over, product(y, y));
      changes = changes || !minor.is_zero();
    }
    if constexpr (std::is_same_v<S, double>) {
      v_size.push_back(size_of(v[i]));
      a_size.push_back(size_of(a[i]));
      if (a_size[i] > 0) a_size[i] += 0x1p-50 * v_size[i];  // as for rate_of()
      result.base_scale += v_size[i] * v_size[i];
      for (std::size_t j = 0; j < i; ++j) {
        const double size = v_size[i] * a_size[j] + v_size[j] * a_size[i];
        result.scale += size * size;
        changes = changes || size > 0;
      }
    }
  }
  if (!changes) return {};
  if constexpr (std::is_same_v<S, double>) {  // by which terms may grow
    const double reach = std::max(1.0, size_of(parameter));
    for (std::size_t i = 1; i < result.over.size(); ++i) result.scale *= reach;
    for (std::size_t i = 1; i < result.base.size(); ++i) result.base_scale *= reach;
  }
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
    auto [x, sizes] = rate_of(piece, channel, measure.derivative);
    if (measure.is_size()) {
      result.over = sum(result.over, product(x, x));
      result.scale = result.scale + sizes * sizes;
      continue;
    }
    for (S& coefficient : x) coefficient = measure.kind == Measure::Kind::smallest ? -coefficient : coefficient;
    return {x, sizes};
  }
  return result;
}

}  // namespace tcb::limits
