// Pieces: the cubics from a sample to the end of its piece, in three forms, with their duration and length.
//
// With the piece from t0 to t1, h = t1 - t0, and X a channel:
//   hermite  X(t0), X'(t0), X(t1), X'(t1)
//   bezier   X(t0), X(t0) + h X'(t0) / 3, X(t1) - h X'(t1) / 3, X(t1)
//   poly     c0, c1, c2, c3 with X(t) = c0 + c1 (t - t0) + c2 (t - t0)^2 + c3 (t - t0)^3
// Requires: a segment without ease.
// Promises: positions are those of samples at t0 and t1. For doubles each other number is within 2 ulp of the exact
//   one; on a part of a segment, within 4 ulp of its largest term.
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "numbers/decimal_time.hpp"
#include "sample/point.hpp"
#include "tcb/spline/arc_length.hpp"

namespace tcb {

/// The time of a sample; at a key that of the key.
template <class S>
const spline::Time<S>& time_of(const CurveSegmentOf<S>& segment, const SampleOf<S>& sample) {
  return sample.at.u == S(0) ? segment.start : sample.at.w == S(0) ? segment.end : sample.t;
}
template <class S>
const spline::Time<S>& piece_start(const Point<S>& point) {
  return time_of(point.segment(), point.sample());
}
template <class S>
const spline::Time<S>& piece_end(const Point<S>& point) {
  return time_of(point.segment(), point.end());
}

/// The time from a piece's start to its end, before it is rounded.
template <class S>
spline::Time<S> piece_time(const Point<S>& point) {
  const auto& segment = point.segment();
  return spline::elapsed<S>(segment.precise(piece_start(point)), segment.precise(piece_end(point)));
}

template <class S>
S piece_duration(const Point<S>& point) {
  const spline::Time<S>&start = piece_start(point), &end = piece_end(point);
  if constexpr (std::is_same_v<S, double>) {
    if (is_long_decimal(start) || is_long_decimal(end)) {
      return nearest_double(exact_number(end, false) - exact_number(start, false));
    }
  }
  return spline::high_part<S>(piece_time(point));
}

/// A channel of the piece as a cubic of its own, between the positions of samples.
template <class S>
spline::Cubic<S> piece_cubic(const Point<S>& point, std::size_t channel) {
  const auto& segment = point.segment();
  const spline::Cubic<S>& whole = segment.cubics[channel];
  if constexpr (spline::bounds_errors<S>) {  // whose places tell whether they are at keys; times may not
    return spline::part_between(whole, point.sample().at, point.end().at);
  }
  spline::Cubic<S> cubic =
      spline::expanded_part(whole, segment.precise(segment.start), segment.precise(segment.end),
                            segment.precise(piece_start(point)), segment.precise(piece_end(point)));
  cubic.p0 = spline::position(whole, point.sample().at);
  cubic.p1 = spline::position(whole, point.end().at);
  return cubic;
}

/// A working value rounded; a zero is not negative.
template <class S>
S rounded_once(const spline::working_t<S>& value) {
  return spline::high_part<S>(value) + S(0);
}

/// The forms of the cubic of a piece that takes the time h.
template <class S>
using CubicForm = std::array<S, 4> (*)(const spline::Cubic<S>& x, const spline::working_t<S>& h);

template <class S>
std::array<S, 4> hermite_form(const spline::Cubic<S>& x, const spline::working_t<S>& h) {
  using W = spline::working_t<S>;
  return {x.p0, rounded_once<S>(W(x.out) / h), x.p1, rounded_once<S>(W(x.in) / h)};
}

template <class S>
std::array<S, 4> bezier_form(const spline::Cubic<S>& x, const spline::working_t<S>&) {
  using W = spline::working_t<S>;
  return {x.p0, rounded_once<S>(W(x.p0) + W(x.out) / W(3)), rounded_once<S>(W(x.p1) - W(x.in) / W(3)), x.p1};
}

template <class S>
std::array<S, 4> polynomial_form(const spline::Cubic<S>& x, const spline::working_t<S>& h) {
  using W = spline::working_t<S>;
  const W c = W(x.c) + W(x.c_low);
  return {x.p0, rounded_once<S>(W(x.out) / h), rounded_once<S>(c / h / h), rounded_once<S>(W(x.d) / h / h / h)};
}

/// The length of the piece over the metric channels. Lengths are not rational.
template <class S>
S piece_length(const Point<S>& point) {
  if constexpr (spline::has_roots<S>) {
    std::vector<spline::Cubic<S>> cubics;
    for (std::size_t i = 0; i < point.segment().cubics.size(); ++i) cubics.push_back(piece_cubic(point, i));
    spline::SegmentLength<S> length;
    length.assign(cubics, {}, point.segment().metric);
    return length.total().value;
  } else {
    return S(0);
  }
}

}  // namespace tcb
