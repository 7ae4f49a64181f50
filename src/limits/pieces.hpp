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

/// What is measured: a derivative by time of a channel or of several.
struct Measure {
  enum class Kind { largest, smallest, size };  ///< size: the root of the sum of squares
  std::string name;
  Kind kind = Kind::size;
  int derivative = 0;  ///< 0: the position
  std::vector<std::size_t> channels;

  bool is_size() const { return kind == Kind::size; }
};

/// A part of a segment on which all channels are polynomials of the part of its time that has passed, from 0 to 1.
template <class S>
struct Piece {
  std::size_t number;                      ///< of the part of the ease
  S begin, size;                           ///< fractions of the duration of the segment
  S duration;                              ///< of the piece
  std::vector<Polynomial<S>> cubics = {};  ///< one per channel
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
    Piece<S> piece{number, begin + first * size, width, width * duration};
    const Polynomial<S> u = composed(parameter, {first, last - first});
    const bool is_whole = u == Polynomial<S>{S(0), S(1)};
    for (const spline::Cubic<S>& x : segments[segment]) {
      const Polynomial<S> cubic{x.p0, x.out, x.c + x.c_low, x.d};
      piece.cubics.push_back(is_whole ? cubic : composed(cubic, u));
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// A measure as a polynomial: the square of a size, the negative of a number whose smallest value counts.
template <class S>
struct Measured {
  Polynomial<S> value;
  S scale{0};  ///< the sum of the sizes of its terms, which bounds its rounding; 0: it is 0 without any
};

/// The derivative of a channel, and the sum of the sizes of its terms.
template <class S>
std::pair<Polynomial<S>, S> rate_of(const Piece<S>& piece, std::size_t channel, int order) {
  const auto size = [](const S& x) { return x < S(0) ? -x : x; };
  Polynomial<S> x = piece.cubics[channel];
  S rate(1), cleared(0), sizes(0);
  for (int i = 0; i < order; ++i) rate = rate / piece.duration;
  // Coefficients that are far smaller than others have the rounding of these, 2^-90 of them.
  for (std::size_t i = 1; i < x.size(); ++i) cleared = cleared + size(x[i]) * S(static_cast<int>(i * i * i));
  for (int i = 0; i < order; ++i) x = derivative(x);
  for (S& coefficient : x) {
    coefficient = coefficient * rate;
    sizes = sizes + size(coefficient);
  }
  if constexpr (std::is_same_v<S, double>) {
    if (!x.is_zero()) sizes += 0x1p-50 * cleared * rate;
  }
  return {x, sizes};
}

template <class S>
Measured<S> measured(const Piece<S>& piece, const Measure& measure) {
  Measured<S> result;
  for (const std::size_t channel : measure.channels) {
    auto [x, sizes] = rate_of(piece, channel, measure.derivative);
    if (measure.is_size()) {
      result.value = sum(result.value, product(x, x));
      result.scale = result.scale + sizes * sizes;
      continue;
    }
    for (S& coefficient : x) coefficient = measure.kind == Measure::Kind::smallest ? -coefficient : coefficient;
    return {x, sizes};
  }
  return result;
}

}  // namespace tcb::limits
