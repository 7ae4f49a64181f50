// Ease: a warp of the local parameter that lets a segment start and stop slowly.
//
//   s = f + e; if s > 1, both are divided by s; k = 1/(2 - f - e)
//   warped(u) = (k/f) u^2 for u < f,  k (2u - f) for u < 1 - e,  1 - (k/e)(1 - u)^2 beyond
// with f the ease_out of the segment's first key and e the ease_in of its last.
// Source: the behaviour of 3D Studio, 3ds Max and programs compatible with them.
#pragma once

#include "tcb/spline/segment.hpp"

namespace tcb::spline {

/// The warp of one segment, with f + e at most 1; the identity where both are 0.
template <class S>
class Warp {
 public:
  Warp() = default;
  /// Requires: ease_out and ease_in in [0, 1].
  Warp(const S& ease_out, const S& ease_in) : f_(ease_out), e_(ease_in) {
    const W sum = f_ + e_;
    if (sum > W(1)) {
      f_ = f_ / sum;
      e_ = e_ / sum;
    }
    k_ = W(1) / (W(2) - f_ - e_);
  }

  bool is_identity() const { return f_ == W(0) && e_ == W(0); }

  /// The local parameter after the fraction u of the segment's duration. `left` is 1 - u.
  LocalParameter<S> at(const working_t<S>& u, const working_t<S>& left) const {
    if (is_identity()) return u < left ? from_start<S>(u) : from_end<S>(left);
    if (u < f_) return from_start<S>(k_ / f_ * u * u);
    if (left > e_) return from_start<S>(k_ * (u + u - f_));
    return from_end<S>(e_ == W(0) ? W(0) : k_ / e_ * left * left);
  }

  /// The inverse of at(): the fraction of the duration at a local parameter.
  working_t<S> inverse(const LocalParameter<S>& place) const {
    using std::sqrt;
    const W u = place.near_start() ? W(place.u) : W(1) + W(place.w);
    if (is_identity()) return u;
    const W left = place.near_start() ? W(1) - W(place.u) : W(-place.w);
    if (u < k_ * f_) return sqrt(u * f_ / k_);
    if (left > k_ * e_) return W(0.5) * (u / k_ + f_);
    return W(1) - sqrt(left * e_ / k_);
  }

  /// The local parameters between which the warp is linear.
  S end_of_first_part() const { return high_part<S>(k_ * f_); }
  S start_of_last_part() const { return high_part<S>(W(1) - k_ * e_); }

  /// The first and second derivative of the warp after the fraction u of the duration.
  S first_derivative(const S& u) const {
    if (is_identity()) return S(1);
    const S f = high_part<S>(f_), e = high_part<S>(e_), k = high_part<S>(k_);
    if (u < f || f == S(1)) return S(2) * k / f * u;
    return S(1) - u > e || e == S(0) ? S(2) * k : S(2) * k / e * (S(1) - u);
  }
  S second_derivative(const S& u) const {
    if (is_identity()) return S(0);
    const S f = high_part<S>(f_), e = high_part<S>(e_), k = high_part<S>(k_);
    if (u < f || f == S(1)) return S(2) * k / f;
    return S(1) - u > e || e == S(0) ? S(0) : S(-2) * k / e;
  }

 private:
  using W = working_t<S>;

  W f_{0}, e_{0}, k_{0.5};
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
