// Ease: a warp of the local parameter, so that a segment starts and stops slowly, or the speed of keys has no jumps.
//
// With ease:
//   s = f + e; if s > 1, both are divided by s; k = 1/(2 - f - e)
//   warped(u) = (k/f) u^2 for u < f,  k (2u - f) for u < 1 - e,  1 - (k/e)(1 - u)^2 beyond
// with f the ease_out of the segment's first key and e the ease_in of its last.
// Source: the behaviour of 3D Studio, 3ds Max and programs compatible with them.
//
// With monotone timing: the cubic with warped(0) = 0, warped(1) = 1, and slopes a and b there,
//   warped(u) = u (a + u (3 - 2a - b + u (a + b - 2)))
// which increases where a and b are in [0, 3].
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "tcb/spline/key.hpp"
#include "tcb/spline/scalar.hpp"
#include "tcb/spline/segment.hpp"

namespace tcb::spline {

/// The parts of a segment with ease: it speeds up, keeps its rate, and slows down. The second derivative jumps between
/// them.
enum class EasePart : std::uint8_t { first, middle, last };

/// The warp of one segment: that of ease, with f + e at most 1, or a cubic, or the identity.
template <class S>
class Warp {
 public:
  using W = working_t<S>;

  Warp() = default;
  /// That of ease; the identity where both are 0. Requires: ease_out and ease_in in [0, 1].
  Warp(const S& ease_out, const S& ease_in) : first_(ease_out), last_(ease_in) {
    if (first_ == W(0) && last_ == W(0)) return;
    kind_ = Kind::ease;
    const W sum = first_ + last_;
    if (sum > W(1)) {
      first_ = first_ / sum;
      last_ = last_ / sum;
    }
    k_ = W(1) / (W(2) - first_ - last_);
  }
  /// The cubic with these slopes at its ends; the identity where both are 1. Requires: both in [0, 3].
  static Warp cubic(const W& first_slope, const W& last_slope) {
    Warp warp;
    warp.first_ = first_slope;
    warp.last_ = last_slope;
    warp.k_ = first_slope + last_slope - W(2);
    warp.kind_ = first_slope == W(1) && last_slope == W(1) ? Kind::identity : Kind::cubic;
    return warp;
  }

  bool is_identity() const { return kind_ == Kind::identity; }
  bool is_cubic() const { return kind_ == Kind::cubic; }
  bool has_ease() const { return kind_ == Kind::ease; }

  /// The local parameter after the fraction u of the segment's duration. `left` is 1 - u.
  LocalParameter<S> at(const W& u, const W& left) const {
    if (has_ease()) return at(u, left, u < first_ ? EasePart::first : left > last_ ? EasePart::middle : EasePart::last);
    return at(u, left, EasePart::middle);
  }
  /// That in a part of the ease, which decides nothing for other warps.
  LocalParameter<S> at(const W& u, const W& left, EasePart part) const {
    if (is_identity()) return u < left ? from_start<S>(u) : from_end<S>(left);
    if (is_cubic()) return u < left ? from_start<S>(cubic_at(u, first_)) : from_end<S>(cubic_at(left, last_));
    if (part == EasePart::first) return from_start<S>(k_ / first_ * u * u);
    if (part == EasePart::middle) return from_start<S>(k_ * (u + u - first_));
    return from_end<S>(last_ == W(0) ? W(0) : k_ / last_ * left * left);
  }

  /// The part of the ease after a time of the segment's duration; `left`: the rest of it. Between two parts the one on
  /// this side, also where doubles are as near as the rounding errors of double-doubles. Without ease the middle.
  EasePart part(const W& passed, const W& left, const W& duration, Side side) const {
    if (!has_ease()) return EasePart::middle;
    const auto is_within = [&](const W& time, const W& of_part, Side at_its_end) {
      const W beyond = time - of_part * duration;
      [[maybe_unused]] W near(0);
      if constexpr (std::is_same_v<S, double>) near = W(0x1p-98) * duration;
      const bool with_end = side == at_its_end || of_part == W(1);
      return of_part > W(0) && (with_end ? beyond <= near : beyond < -near);
    };
    if (is_within(passed, first_, Side::left)) return EasePart::first;
    return is_within(left, last_, Side::right) ? EasePart::last : EasePart::middle;
  }
  EasePart part(const S& u, Side side = Side::right) const {
    return has_ease() ? part(W(u), W(1) - W(u), W(1), side) : EasePart::middle;
  }
  /// The part at a local parameter.
  EasePart part(const LocalParameter<S>& place, Side side) const {
    if (!has_ease()) return EasePart::middle;
    const S first = high_part<S>(k_ * first_), last = high_part<S>(-(k_ * last_));
    const bool with_first = side == Side::left || first_ == W(1), with_last = side == Side::right || last_ == W(1);
    if (first_ > W(0) && (place.u < first || (with_first && place.u == first))) return EasePart::first;
    if (last_ > W(0) && (place.w > last || (with_last && place.w == last))) return EasePart::last;
    return EasePart::middle;
  }

  /// The inverse of at(): the fraction of the duration at a local parameter.
  W inverse(const LocalParameter<S>& place) const {
    const bool near_start = place.near_start();
    const W u = near_start ? W(place.u) : W(1) + W(place.w);
    if (is_identity()) return u;
    const W left = near_start ? W(1) - W(place.u) : W(-place.w);
    if (is_cubic()) {
      return near_start ? root(u, first_) : W(1) - root(left, last_);
    }
    if (u < k_ * first_) return square_root(u * first_ / k_);
    if (left > k_ * last_) return W(0.5) * (u / k_ + first_);
    return W(1) - square_root(left * last_ / k_);
  }

  /// The local parameters between which a warp of ease is linear. That of a cubic has one part.
  S end_of_first_part() const { return is_cubic() ? S(1) : high_part<S>(k_ * first_); }
  S start_of_last_part() const { return is_cubic() ? S(1) : high_part<S>(W(1) - k_ * last_); }

  /// The derivatives of the warp after the fraction u of the duration, in a part of the ease.
  S first_derivative(const S& u, EasePart part) const {
    if (is_identity()) return S(1);
    const S f = high_part<S>(first_), e = high_part<S>(last_), k = high_part<S>(k_);
    const S left = S(1) - u;
    if (is_cubic()) return left * (f + u * (S(6) - S(3) * f)) + e * u * (S(3) * u - S(2));
    if (part == EasePart::first) return S(2) * k / f * u;
    return part == EasePart::middle || e == S(0) ? S(2) * k : S(2) * k / e * left;
  }
  S first_derivative(const S& u) const { return first_derivative(u, part(u)); }
  S second_derivative(const S& u, EasePart part) const {
    if (is_identity()) return S(0);
    const S f = high_part<S>(first_), e = high_part<S>(last_), k = high_part<S>(k_);
    const S left = S(1) - u;
    if (is_cubic()) return left * (S(6) - S(4) * f - S(2) * e) + u * (S(2) * f + S(4) * e - S(6));
    if (part == EasePart::first) return S(2) * k / f;
    return part == EasePart::middle || e == S(0) ? S(0) : S(-2) * k / e;
  }
  S second_derivative(const S& u) const { return second_derivative(u, part(u)); }
  S third_derivative() const { return is_cubic() ? S(6) * high_part<S>(k_) : S(0); }

 private:
  enum class Kind : std::uint8_t { identity, ease, cubic };

  /// The cubic at a distance from the end where its slope is `slope`: how far it is from its value there.
  W cubic_at(const W& distance, const W& slope) const {
    return distance * (slope + distance * (W(1) - slope - k_ + distance * k_));
  }

  /// The distance at which the cubic has a value, by Newton's method, or by halves where that leaves the bracket.
  W root(const W& value, const W& slope) const {
    constexpr int most_steps = 2000;  // of halves, for a slope of 0 and any number of digits in use
    W low(0), high(1), x = value;
    for (int step = 0; step < most_steps; ++step) {
      const W off = cubic_at(x, slope) - value;
      if (off == W(0)) break;
      (off < W(0) ? low : high) = x;
      const W rate = slope + x * (W(2) * (W(1) - slope - k_) + W(3) * x * k_);
      W next = rate > W(0) ? x - off / rate : low;
      if (!(next > low && next < high)) next = W(0.5) * (low + high);
      if (next == x || !(next > low && next < high)) break;
      x = next;
    }
    return x;
  }

  W first_{0};  ///< with ease, f; of a cubic, the first slope
  W last_{0};   ///< with ease, e; of a cubic, the last slope
  W k_{0.5};    ///< of a cubic, the coefficient of u^3
  Kind kind_ = Kind::identity;
};

/// The map from time to the local parameter of one segment: the elapsed fraction of the duration, warped, rounded once.
template <class S>
class TimeMap {
 public:
  /// Requires: start <= end.
  TimeMap(const Time<S>& start, const Time<S>& end, const Warp<S>& warp = {})
      : start_(start), end_(end), warp_(warp), duration_(elapsed<S>(start, end)), plain_(warp.is_identity()) {}

  /// Requires: start <= t <= end.
  LocalParameter<S> operator()(const Time<S>& t) const {
    if (t == start_) return {S(0), S(-1)};
    if (t == end_) return {S(1), S(0)};
    const W passed = elapsed<S>(start_, t);
    const W left = elapsed<S>(t, end_);
    if (plain_ && low_part<S>(passed) == S(0) && low_part<S>(left) == S(0) && low_part<S>(duration_) == S(0)) {
      return {high_part<S>(passed) / high_part<S>(duration_), -high_part<S>(left) / high_part<S>(duration_)};
    }
    if (passed < left) return plain_ ? from_start<S>(passed / duration_) : warped(passed / duration_);
    return plain_ ? from_end<S>(left / duration_) : warped_from_end(left / duration_);
  }
  /// Also where the part of the ease is known, which an inexact scalar may not decide.
  LocalParameter<S> operator()(const Time<S>& t, std::optional<EasePart> part) const {
    if (!part || plain_ || t == start_ || t == end_) return (*this)(t);
    return warp_.at(elapsed<S>(start_, t) / duration_, elapsed<S>(t, end_) / duration_, *part);
  }

 private:
  using W = working_t<S>;

  LocalParameter<S> warped(const W& u) const { return warp_.at(u, -u + S(1)); }
  LocalParameter<S> warped_from_end(const W& left) const { return warp_.at(-left + S(1), left); }

  Time<S> start_, end_;
  Warp<S> warp_;
  W duration_;
  bool plain_;  ///< whether the warp is the identity
};

}  // namespace tcb::spline
