// Pieces: the parts of segments in which all channels are polynomials, and what is measured on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/bounded.hpp"
#include "exact/rounding.hpp"
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
  /// A limit in the form of an Extreme.
  Rational as_measured(const Rational& bound) const {
    if (is_size()) return bound * bound;
    return kind == Kind::smallest ? -bound : bound;
  }
  bool is_of_direction() const { return kind == Kind::curvature || kind == Kind::angular_speed; }
};

/// The part of an ease, of which that of other warps is the middle one.
enum class Part { first, middle, last };

/// A part of a segment on which all channels are polynomials of the part of its time that has passed, from 0 to 1.
/// Refers to the cubics of the segment.
template <class S>
struct Piece {
  std::span<const spline::Cubic<S>> cubics;
  Part part;
  S begin, size;            ///< fractions of the duration of the segment
  S duration;               ///< of the piece
  Polynomial<S> parameter;  ///< the local parameter of the segment

  bool is_whole() const { return parameter.size() == 2 && parameter[0] == S(0) && parameter[1] == S(1); }
};

inline bool is_above_zero(const Rational& x) { return x > 0; }
inline bool is_above_zero(const Bounded& x) { return x.value.hi > 0 && x.least() > 0; }

/// The pieces of a segment between two fractions of its duration. For Warp see tcb/spline/ease.hpp, whose letters these
/// are: the parts of an ease end at A = kf and B = 1 - ke, k = 1 + (A - B)/2.
template <class S>
std::vector<Piece<S>> pieces_of(const spline::Segments<S>& segments, std::size_t segment, const S& from, const S& to) {
  const S zero(0), one(1), two(2), three(3);
  std::vector<Piece<S>> pieces;
  const S elapsed = segments.times[segment + 1] - segments.times[segment], duration = elapsed == zero ? one : elapsed;
  const auto add = [&](Part part, const S& begin, const S& size, const Polynomial<S>& parameter) {
    const S first = begin < from ? (from - begin) / size : zero;
    const S last = to < one && to < begin + size ? (to - begin) / size : one;
    if (!is_above_zero(size) || !(first < last)) return;
    const bool is_cut = first != zero || last != one;
    const S width = is_cut ? (last - first) * size : size;
    pieces.push_back({segments[segment], part, is_cut ? begin + first * size : begin, width, width * duration,
                      is_cut ? composed(parameter, {first, last}) : parameter});
  };
  const spline::Warp<S> warp = segments.warp(segment);
  if (warp.is_identity()) {
    add(Part::middle, zero, one, {zero, one});
  } else if (warp.is_cubic()) {
    const S start = warp.first_derivative(zero, {}), end = warp.first_derivative(one, {});
    add(Part::middle, zero, one, {zero, start / three, one - end / three, one});
  } else {
    const S first = warp.end_of_first_part(), last = warp.start_of_last_part();
    const S k = one + (first - last) / two, f = first / k, e = (one - last) / k;
    add(Part::first, zero, f, {zero, zero, first});
    add(Part::middle, f, one - f - e, {first, last});
    add(Part::last, one - e, e, {last, one, one});
  }
  return pieces;
}

/// The coefficients of a channel over the local parameter, or of its first derivative by that.
template <class S>
Polynomial<S> controls_of(const spline::Cubic<S>& x, int order) {
  if (order > 0) return {x.out, x.out + x.c, x.in};
  return {x.p0, x.p0 + x.out / S(3), x.p1 - x.in / S(3), x.p1};
}

// Numbers of a piece are computed as multiples of powers of two, so that none is beyond the range of doubles.

inline constexpr int no_exponent = std::numeric_limits<int>::min();

/// The exponent of a number, x = m 2^exponent with m in [1/2, 1); no_exponent for 0.
inline int exponent_of(const Rational& x) { return x == 0 ? no_exponent : binary_exponent(x); }
inline int exponent_of(const Bounded& x) {
  int exponent = no_exponent;
  if (x.value.hi != 0) (void)std::frexp(x.value.hi, &exponent);
  return exponent;
}

/// x 2^-exponent. Rationals need no scale.
template <class To>
To scaled(const Rational& x, int exponent) {
  if constexpr (std::is_same_v<To, Rational>) {
    return x;
  } else {
    const Rational number = x / power_of_two(exponent);
    const bool is_tiny = number != 0 && binary_exponent(number) < -890;
    return is_tiny ? Bounded(0.0, 0x1p-889) : scalar_of<Bounded>(number);
  }
}
template <class To>
To scaled(const Bounded& x, int exponent) {
  const bool may_lose_bits = x.value.hi != 0 && std::ilogb(x.value.hi) - exponent < -900;
  return {ldexp(x.value, -exponent), std::ldexp(x.error, -exponent) + (may_lose_bits ? 0x1p-1000 : 0)};
}

template <class S>
Polynomial<S> dot(const std::vector<Polynomial<S>>& a, const std::vector<Polynomial<S>>& b) {
  Polynomial<S> result{S(0)};
  for (std::size_t i = 0; i < a.size(); ++i) result = sum(result, product(a[i], b[i]));
  return result;
}

/// A quotient of polynomials.
template <class S>
struct Quotient {
  Polynomial<S> over, base;
  int power;  ///< of the base

  S at(const S& place) const {
    const S value = value_at(over, place);
    return power == 0 ? value : value / power_of(value_at(base, place), power);
  }
};

/// A measure over a piece or a part of it: the square of a size, the negative of a number whose smallest value counts.
/// It is 2^exponent (over + |turning|^2) / |velocity|^(2 power). Squares of polynomials that are nearly 0 at the same
/// place would lose digits, as the vectors do not.
template <class S>
struct Form {
  Polynomial<S> over{S(0)};
  std::vector<Polynomial<S>> turning = {}, velocity = {};
  int power = 0;
  int exponent = 0;
  bool is_square = true;  ///< no value is below 0

  /// Without the power of two.
  Quotient<S> quotient() const {
    return {turning.empty() ? over : sum(over, dot(turning, turning)), dot(velocity, velocity), power};
  }
  /// Nothing changes.
  bool is_constant_zero() const { return turning.empty() && is_zero(over); }
};

template <class S>
S largest_of(const std::vector<Polynomial<S>>& all) {
  S largest(0);
  for (const Polynomial<S>& x : all) largest = std::max({largest, std::ranges::max(x), S(-std::ranges::min(x))});
  return largest;
}

/// Makes the numbers of a form short that are products of numbers of 448 bits, to within what those are known.
inline void shorten(Form<Rational>& form) {
  const auto shorten_all = [](std::vector<Polynomial<Rational>>& all) {
    if (largest_of(all) == 0) return;
    const Rational unit = power_of_two(binary_exponent(largest_of(all)) - 420);
    for (Polynomial<Rational>& x : all) {
      for (Rational& number : x) number = floor(number / unit) * unit;
    }
  };
  std::vector<Polynomial<Rational>> over{form.over};
  for (auto* const all : {&over, &form.turning, &form.velocity}) shorten_all(*all);
  form.over = over.front();
}

/// How the direction of v changes, where a is the derivative of v: |v ^ a| as the minors of these, or of many channels
/// its square. `are_rounded`: numbers have 448 bits, and what is below their rounding is 0.
template <class S>
Form<S> turning_of(const std::vector<Polynomial<S>>& v, const std::vector<Polynomial<S>>& a, bool are_rounded) {
  constexpr std::size_t few = 4;
  Form<S> form;
  if (v.size() > few) {
    const Polynomial<S> across = dot(v, a);
    form.over = sum(product(dot(v, v), dot(a, a)), product(across, across), S(-1));
  } else {
    for (std::size_t i = 0; i < v.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        form.turning.push_back(sum(product(v[i], a[j]), product(v[j], a[i]), S(-1)));
      }
    }
  }
  bool changes = !is_zero(form.over) || !std::ranges::all_of(form.turning, is_zero<S>);
  if constexpr (std::is_same_v<S, Rational>) {
    static const Rational noise = power_of_two(-380);
    const Rational least = noise * largest_of(v) * largest_of(a);
    if (are_rounded) changes = largest_of(form.turning) > least || largest_of<S>({form.over}) > least * least;
  }
  return changes ? form : Form<S>();
}

/// A measure over a piece. `To`: in which it is computed. `is_rounded`: exact numbers have 448 bits.
template <class To, class From>
Form<To> form_of(const Piece<From>& piece, const Measure& measure, bool is_rounded = false) {
  const bool is_curvature = measure.kind == Measure::Kind::curvature, is_of_direction = measure.is_of_direction();
  const int order = is_curvature ? 1 : measure.derivative, first = is_of_direction && !is_curvature ? 0 : order;
  std::vector<Polynomial<From>> controls;
  int unit = no_exponent;
  bool rests = true;  // at both ends, so that the path is straight
  for (const std::size_t channel : measure.channels) {
    const spline::Cubic<From>& x = piece.cubics[channel];
    controls.push_back(controls_of(x, first));
    for (const From& control : controls.back()) unit = std::max(unit, exponent_of(control));
    rests = rests && x.out == From(0) && x.in == From(0);
  }
  if (unit == no_exponent || (is_curvature && rests)) return {};
  if constexpr (std::is_same_v<To, Rational>) unit = 0;
  std::vector<Polynomial<To>> x;
  for (const Polynomial<From>& control : controls) {
    x.emplace_back(control.size());
    std::ranges::transform(control, x.back().begin(), [unit](const From& c) { return scaled<To>(c, unit); });
  }
  const bool is_whole = piece.is_whole();
  Polynomial<To> parameter(piece.parameter.size());
  std::ranges::transform(piece.parameter, parameter.begin(), [](const From& c) { return scaled<To>(c, 0); });
  const auto over_piece = [&](const Polynomial<To>& of) { return is_whole ? of : composed(of, parameter); };
  const int time_unit = std::is_same_v<To, Rational> ? 0 : exponent_of(piece.duration);
  const To duration = scaled<To>(piece.duration, time_unit);
  if (is_of_direction) {
    std::vector<Polynomial<To>> rates;
    for (const Polynomial<To>& v : x) rates.push_back(derivative(v));
    Form<To> form = turning_of(x, rates, is_rounded);
    if (form.is_constant_zero()) return form;
    const Polynomial<To> turn = is_curvature ? Polynomial<To>{To(1)} : times(derivative(parameter), To(2) / duration);
    for (Polynomial<To>& minor : form.turning) minor = product(over_piece(minor), turn);
    form.over = product(over_piece(form.over), product(turn, turn));
    for (const Polynomial<To>& v : x) form.velocity.push_back(over_piece(v));
    form.power = is_curvature ? 3 : 2;
    form.exponent = -2 * (is_curvature ? unit : time_unit);
    return form;
  }
  Form<To> form;
  for (Polynomial<To>& rate : x) {
    rate = over_piece(rate);
    if (order > 0 && !is_whole) rate = product(rate, derivative(parameter));
    for (int i = 1; i < order; ++i) rate = derivative(rate);
  }
  const int power = measure.is_size() ? 2 : 1;
  form.is_square = measure.is_size();
  form.over = measure.is_size() ? dot(x, x) : times(x[0], To(measure.kind == Measure::Kind::smallest ? -1 : 1));
  if (order > 0) form.over = times(form.over, To(1) / power_of(duration, order * power));
  form.exponent = power * (unit - order * time_unit);
  return form;
}

}  // namespace tcb::limits
