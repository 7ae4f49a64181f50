// Pieces: the parts of segments in which all channels are polynomials, and what is measured on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "limits/polynomial.hpp"
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
};

/// A part of a segment on which all channels are polynomials of the part of its time that has passed, from 0 to 1.
template <class S>
struct Piece {
  std::size_t number;                      ///< of the part of the ease
  S begin, size;                           ///< fractions of the duration of the segment
  S duration;                              ///< of the piece
  Polynomial<S> parameter;                 ///< the local parameter of the segment
  std::vector<Polynomial<S>> cubics = {};  ///< one per channel, over the local parameter

  /// A polynomial over the local parameter as one over the piece.
  Polynomial<S> over_piece(const Polynomial<S>& x) const {
    return parameter == Polynomial<S>{S(0), S(1)} ? x : composed(x, parameter);
  }
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
    for (const spline::Cubic<S>& x : segments[segment]) piece.cubics.push_back({x.p0, x.out, x.c + x.c_low, x.d});
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// A measure over a piece, as a quotient of polynomials: the square of a size, the negative of a number whose smallest
/// value counts.
template <class S>
struct Measured {
  Polynomial<S> over;
  S scale{0};                 ///< the sum of the sizes of its terms, which bounds its rounding; 0: it is 0 without any
  Polynomial<S> under{S(1)};  ///< at least 0, which is where a curve rests
  S under_scale{0};           ///< 0: it has no rounding
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
  Polynomial<S> x = piece.over_piece(piece.cubics[channel]);
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

/// How fast the direction of v changes, with a the derivative of v: |v ^ a|^2 / |v|^4; per length instead of per local
/// parameter |v ^ a|^2 / |v|^6. Doubles are powers of `unit`, so that they do not overflow.
template <class S>
Measured<S> change_of_direction(const std::vector<Polynomial<S>>& v, bool per_length, const S& unit) {
  std::vector<Polynomial<S>> a;
  std::vector<S> v_size, a_size;
  Measured<S> result;
  Polynomial<S> square;  // |v|^2
  S square_size(0);
  for (std::size_t i = 0; i < v.size(); ++i) {
    a.push_back(derivative(v[i]));
    v_size.push_back(size_of(v[i]));
    a_size.push_back(size_of(a[i]));
    if constexpr (std::is_same_v<S, double>) {  // as for rate_of()
      if (a_size[i] > 0) a_size[i] += 0x1p-50 * v_size[i];
    }
    square = sum(square, product(v[i], v[i]));
    square_size = square_size + v_size[i] * v_size[i];
    for (std::size_t j = 0; j < i; ++j) {
      const auto minor = sum(product(v[i], a[j]), product(v[j], a[i]), S(-1)).without_last();  // which is 0
      const S size = v_size[i] * a_size[j] + v_size[j] * a_size[i];
      result.over = sum(result.over, product(minor, minor));
      result.scale = result.scale + size * size;
    }
  }
  if (result.scale == S(0) || (!std::is_same_v<S, double> && result.over.is_zero())) return {};
  result.under = product(square, square);
  result.under_scale = square_size * square_size;
  if (!per_length) return result;
  result.under = product(result.under, square);
  result.under_scale = result.under_scale * square_size;
  for (S& coefficient : result.over) coefficient = coefficient * unit * unit;
  result.scale = result.scale * unit * unit;
  return result;
}

template <class S>
Measured<S> measured_direction(const Piece<S>& piece, const Measure& measure) {
  const bool is_curvature = measure.kind == Measure::Kind::curvature;
  std::vector<Polynomial<S>> v;
  S largest(0), unit(1), reach(1);
  for (const std::size_t channel : measure.channels) {
    v.push_back(is_curvature ? derivative(piece.cubics[channel]) : piece.cubics[channel]);
    for (const S& coefficient : v.back()) largest = std::max(largest, size_of(coefficient));
  }
  if constexpr (std::is_same_v<S, double>) {
    if (largest > 0 && std::isfinite(largest)) unit = std::ldexp(1.0, -std::ilogb(largest));
    for (Polynomial<double>& x : v) {
      for (double& coefficient : x) coefficient *= unit;
    }
    reach = std::max(1.0, size_of(piece.parameter));  // by which terms may grow
  }
  Measured<S> result = change_of_direction(v, is_curvature, unit);
  for (std::size_t i = 1; i < result.over.size(); ++i) result.scale = result.scale * reach;
  for (std::size_t i = 1; i < result.under.size(); ++i) result.under_scale = result.under_scale * reach;
  result.over = piece.over_piece(result.over);
  result.under = piece.over_piece(result.under);
  if (is_curvature) return result;
  Polynomial<S> rate = derivative(piece.parameter);
  for (S& coefficient : rate) coefficient = coefficient * S(2) / piece.duration;
  result.over = product(result.over, product(rate, rate));
  result.scale = result.scale * size_of(rate) * size_of(rate);
  return result;
}

template <class S>
Measured<S> measured(const Piece<S>& piece, const Measure& measure) {
  if (measure.kind == Measure::Kind::curvature || measure.kind == Measure::Kind::angular_speed) {
    return measured_direction(piece, measure);
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
