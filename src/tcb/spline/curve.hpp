// Curve: an open or closed Kochanek-Bartels curve that is kept, evaluated by time or by arc length.
//
// It is built from keys and rules at once, or from the segments of a CurveStream as they come.
//
// On segment i, from key i at t_i to key i+1, with h = t_(i+1) - t_i, u = (t - t_i)/h (warped where keys have ease) and
// `out`, `in` the tangents by the rules of rules.hpp:
//   X(u) = (2u^3 - 3u^2 + 1) P_i + (3u^2 - 2u^3) P_(i+1) + (u^3 - 2u^2 + u) out_i + (u^3 - u^2) in_(i+1)
// The channels of a rotation have the numbers x, y, z, w of a unit quaternion, see rotation.hpp. An angle is from 0 to
// less than a whole turn. A channel in which keys lack positions runs through the keys that have one; before the first
// of them and after the last, an open curve is constant there.
// Source: D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", section 2; for rules and lengths see rules.hpp and
//   arc_length.hpp.
// Units: times and lengths as the keys have them; derivatives per unit of time to the power of their order.
// Threads: a curve does not change once it is built; any number of threads may evaluate it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/build_error.hpp"
#include "tcb/spline/closing.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/derivatives.hpp"
#include "tcb/spline/segment_length.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb::spline {

/// One segment of a curve, with the cubic of each channel. Valid as long as the curve exists and has no more segments.
template <class S>
struct Segment {
  Time<S> start, end;
  std::span<const Cubic<S>> cubics;               ///< one per channel; those of rotations have no meaning
  Warp<S> warp;                                   ///< of u; the identity where keys have no ease
  std::span<const RotationSegment<S>> rotations;  ///< one for each rotation of the rules
  working_t<S> length_start, length_end;          ///< of the curve, up to its ends; 0 where it is not measured
  S length_error;                                 ///< a bound on the error of length_end
};

/// The length of each segment over the channels of metric_of(), as Curve::append() takes them. Promises: see ArcLength.
template <class S>
std::vector<Length<S>> lengths_of(const Segments<S>& segments, std::span<const std::size_t> metric) {
  std::vector<Length<S>> lengths;
  lengths.reserve(segments.size());
  SegmentLength<S> arc;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    arc.assign(segments[i], metric);
    lengths.push_back(arc.total());
  }
  return lengths;
}

/// Shapes: `out` takes one number per channel; if it is shorter, only the first channels are computed.
/// Evaluations do not throw. They do not allocate, except lengths on appended segments. A time of NaN gives NaN.
template <class S>
class Curve {
 public:
  using W = working_t<S>;

  /// An open curve. One key gives a constant. The result has the error in the keys or rules, if there is one.
  static BuildResult<Curve> build(Keys<S> keys, const CurveRules<S>& rules = {}) {
    if (const auto error = find_key_error(keys)) return *error;
    if (const auto error = find_rule_error(rules, keys, false)) return *error;
    return of_keys(CurveKeys<S>(std::move(keys), rules), rules);
  }

  /// A closed curve: one more segment joins the last key to the first, which repeats after the period. `period`: the
  /// duration from the first key to its repetition, not a time; without it, the last key must end it. A last key at
  /// exactly the position of the first only ends the period and needs none; it must have the same tension, continuity
  /// and bias, and the same velocities or none; its incoming velocity counts. A rotation may be repeated with the other
  /// sign. The end rules have no effect. The result may be an error.
  static BuildResult<Curve> build_closed(Keys<S> keys, const CurveRules<S>& rules = {},
                                         const std::optional<Time<S>>& period = std::nullopt);

  /// A curve without segments; nothing but append() may be called. `count`: how many segments will follow, if known.
  explicit Curve(const CurveRules<S>& rules, bool closed = false, std::size_t count = 0)
      : rules_(rules), closed_(closed), expected_(count) {}

  /// Appends the segments that follow, as those of a CurveStream; no error is looked for. `lengths`: one per segment,
  /// as lengths_of() gives them, or always none: then the curve is not measured, which only length(), length_to(),
  /// find_length() and at_length() require. The memory per segment is constant.
  void append(Segments<S> next, std::span<const Length<S>> lengths = {});

  std::size_t channels() const { return segments_.channels; }
  bool is_closed() const { return closed_; }
  /// The times of the first key and of the last key or, if closed, of the return to the first.
  S start() const { return high_part<S>(segments_.times.front()); }
  S end() const { return high_part<S>(segments_.times.back()); }

  /// The number of segments: one less than keys, or as many if closed. A single key has one, without duration.
  std::size_t segment_count() const { return segments_.size(); }

  /// How many tangents were made smaller so that it does not overshoot.
  std::size_t limited_tangents() const { return segments_.limited_tangents; }

  /// Segment number i, from 0. Requires: i < segment_count().
  Segment<S> segment(std::size_t i) const {
    const bool measured = is_measured();
    return {.start = segments_.times[i],
            .end = segments_.times[i + 1],
            .cubics = segments_[i],
            .warp = segments_.warp(i),
            .rotations = segments_.rotations_of(i),
            .length_start = measured ? lengths_[i] : W(0),
            .length_end = measured ? lengths_[i + 1] : W(0),
            .length_error = measured ? errors_[i + 1] : S(0)};
  }

  /// The times of the keys, and of the return to the first one if closed: one more than segments.
  std::span<const Time<S>> times() const { return segments_.times; }

  /// The number of the segment at time t; of two that meet there, the one on that side. A time outside the curve
  /// counts as its start or end.
  std::size_t find_time(const Time<S>& t, Side side = Side::right) const {
    return segment_at_time<Time<S>>(segments_.times, t, side);
  }

  /// The number of the segment on which the length s from the start is first reached. Where that is at its end and it
  /// has a length, it is the segment after it if `side` is right.
  std::size_t find_length(const W& s, Side side = Side::left) const requires has_roots<S>;

  /// Whether the lengths of the segments are known.
  bool is_measured() const { return !lengths_.empty(); }

  /// X(t). Before the start and after the end, an open curve keeps its end positions; a closed curve is periodic.
  /// Promises: within 3 ulp of the largest of |P_i|, |P_(i+1)|, |out_i|, |in_(i+1)|; at a key, its position exactly.
  void position(const Time<S>& t, std::span<S> out) const {
    const Spot at = spot(t, Side::right);
    position_at(at.segment, at.local, out);
  }

  /// X(t) for many times. Shapes: `out` takes channels() numbers per time, time after time; times for which it has no
  /// room are skipped.
  void positions(std::span<const S> times, std::span<S> out) const {
    const std::size_t count = std::min(times.size(), out.size() / channels());
    for (std::size_t i = 0; i < count; ++i) position(times[i], out.subspan(i * channels(), channels()));
  }

  /// A rotation, by its number among those of the rules; outside the curve as position(). Its sign is continuous from
  /// the start of the curve to its end. Requires: number < the number of rotations.
  Quaternion<S> rotation(const Time<S>& t, std::size_t number = 0) const requires has_roots<S> {
    const Spot at = spot(t, Side::right);
    return segments_.rotations_of(at.segment)[number].at(at.local);
  }

  /// The angular velocity of a rotation in radians per unit of time, in the frame in which the rotation is given; at a
  /// key from one side, outside an open curve that of its end, and 0 if it has a single key.
  Vector3<S> angular_velocity(const Time<S>& t, std::size_t number = 0,
                              Side side = Side::right) const requires has_roots<S> {
    return turn_rate(spot(t, side), number);
  }

  /// dX/dt, at a key from one side; outside an open curve that of its end. The same as derivative(1, ...). That of an
  /// angle is not wrapped to a turn; those of the channels of a rotation are dq/dt.
  void velocity(const Time<S>& t, std::span<S> out, Side side = Side::right) const { derivative(1, t, out, side); }

  /// The derivative of any order by time, at a key from one side (at the ends of an open curve, from inside). Outside
  /// an open curve it is that of the end; a single key has the derivative 0. Order 0 is the position. Infinite or NaN
  /// where it exceeds the range of the scalar. Orders 2 and above are NaN in the four channels of a rotation.
  void derivative(std::size_t order, const Time<S>& t, std::span<S> out, Side side = Side::right) const;

  /// The length over the metric from the start to the end, with a bound on its error; see metric_of() and lengths_of().
  /// It is rounded: at_length() of it may lie a rounding before the end.
  Length<S> length() const requires has_roots<S> { return {high_part<S>(lengths_.back()), errors_.back()}; }

  /// The length from the start to a time; a time outside the curve is moved to its start or end, also of a closed
  /// curve, whose position() is periodic.
  Length<S> length_to(const Time<S>& t) const requires has_roots<S> {
    const Spot at = spot_inside(std::clamp(t, segments_.times.front(), segments_.times.back()), Side::left);
    SegmentLength<S> own;
    return {high_part<S>(lengths_[at.segment] + W(arc(at.segment, own).to(at.local).value)), errors_.back()};
  }

  /// The first time at which the length from the start is s, rounded; also sets `out` to the position there, which is
  /// that of the exact length. A length below 0 or above that of the curve gives the start or the end, also of a closed
  /// curve, whose position() is periodic.
  /// Promises: accurate to a few units in the last place of the length of the segment.
  S at_length(const S& s, std::span<S> out = {}) const requires has_roots<S>;

 private:
  /// A place on the curve.
  struct Spot {
    std::size_t segment;
    LocalParameter<S> local;
    S passed;  ///< the elapsed fraction of the segment's duration
    EasePart part;
  };

  static BuildResult<Curve> of_keys(const CurveKeys<S>& keys, const CurveRules<S>& rules);
  std::optional<BuildError> find_overflow() const;
  std::optional<BuildError> measure() requires has_roots<S>;
  void append_length(const Length<S>& length);

  /// The lengths on a segment: those that are kept, or those that `own` is given.
  const SegmentLength<S>& arc(std::size_t segment, SegmentLength<S>& own) const requires has_roots<S> {
    if (!arcs_.empty()) return arcs_[segment];
    own.assign(segments_[segment], metric_);
    return own;
  }

  void position_at(std::size_t segment, const LocalParameter<S>& at, std::span<S> out) const;
  Vector3<S> turn_rate(const Spot& at, std::size_t number) const requires has_roots<S>;
  void rotation_derivative(std::size_t order, const Spot& at, std::span<S> out) const requires has_roots<S>;

  Time<S> wrapped(const Time<S>& t) const;
  Spot spot(const Time<S>& t, Side side) const {
    const auto& times = segments_.times;
    if (!closed_) return spot_inside(std::clamp(t, times.front(), times.back()), side);
    const Time<S> inside = wrapped(t);
    if (side == Side::left && inside == times.front()) return spot_inside(times.back(), side);
    if (side == Side::right && inside == times.back()) return spot_inside(times.front(), side);
    return spot_inside(inside, side);
  }
  Spot spot_inside(const Time<S>& t, Side side) const;

  CurveRules<S> rules_;
  bool closed_;
  std::size_t expected_;
  Segments<S> segments_;
  std::vector<std::size_t> metric_;
  std::vector<W> lengths_;              ///< up to each knot, or none
  std::vector<S> errors_;               ///< bounds on the errors of these
  std::vector<SegmentLength<S>> arcs_;  ///< one per segment, or none where segments were appended
};

template <class S>
BuildResult<Curve<S>> Curve<S>::build_closed(Keys<S> keys, const CurveRules<S>& rules,
                                             const std::optional<Time<S>>& period) {
  if (const auto error = find_key_error(keys)) return *error;
  if (const auto error = find_rule_error(rules, keys, true)) return *error;
  const auto key_at = [&](std::size_t number) {
    Keys<S> key;
    spline::append(key, keys, number, number + 1);
    return key;
  };
  const std::size_t size = keys.size();
  const Keys<S> last = with_signs_of(key_at(0), key_at(size - 1), rules.rotations);
  const auto end = period ? std::optional<Time<S>>(keys.times[0] + *period) : std::nullopt;
  const auto closing = find_closing(key_at(0), last, size, end);
  if (!closing) return closing.error();
  if (closing->repeats) {
    for_each_column([&](auto& column) { column.resize(column.size() - column.size() / size); }, keys);
    join_seam(keys, last);
  }
  if (const auto error = find_seam_error<S>(key_at, keys.size())) return *error;
  return of_keys(CurveKeys<S>(std::move(keys), rules, closing->end), rules);
}

template <class S>
void Curve<S>::append(Segments<S> next, std::span<const Length<S>> lengths) {
  if (next.size() == 0) return;
  if (segments_.size() > 0) {
    spline::append(segments_, next);
  } else {
    const std::size_t rotations = rules_.rotations.size();
    segments_ = std::move(next);
    segments_.times.reserve(expected_ + 1);
    segments_.cubics.reserve(expected_ * channels());
    segments_.rotations.reserve(expected_ * rotations);
    if (!segments_.warps.empty()) segments_.warps.reserve(expected_);
    metric_ = metric_of(rules_, channels());
  }
  for (const Length<S>& length : lengths) append_length(length);
}

template <class S>
void Curve<S>::append_length(const Length<S>& length) {
  if (lengths_.empty()) {
    lengths_.reserve(expected_ + 1);
    errors_.reserve(expected_ + 1);
    lengths_.push_back(W(0));
    errors_.push_back(S(0));
  }
  lengths_.push_back(lengths_.back() + W(length.value));
  errors_.push_back(errors_.back() + length.error);
}

template <class S>
BuildResult<Curve<S>> Curve<S>::of_keys(const CurveKeys<S>& keys, const CurveRules<S>& rules) {
  Curve curve(rules, keys.is_closed(), keys.size());
  curve.append(keys.segments(0, keys.size()));
  if (const auto error = curve.find_overflow()) return *error;
  if constexpr (has_roots<S>) {
    if (const auto error = curve.measure()) return *error;
  }
  return curve;
}

template <class S>
std::optional<BuildError> Curve<S>::find_overflow() const {
  for (std::size_t i = 0; i < segments_.cubics.size(); ++i) {
    const auto& [p0, out, c, c_low, p1, in, e, e_low, d] = segments_.cubics[i];
    if (is_finite(out) && is_finite(c) && is_finite(in) && is_finite(e) && is_finite(d)) continue;
    return BuildError{.code = BuildErrorCode::curve_overflow, .key = i / channels(), .channel = i % channels()};
  }
  return std::nullopt;
}

/// Sets the lengths.
template <class S>
std::optional<BuildError> Curve<S>::measure() requires has_roots<S> {
  arcs_.reserve(segments_.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    arcs_.emplace_back(segments_[i], metric_);
    append_length(arcs_.back().total());
    if (!is_finite(lengths_.back())) return BuildError{.code = BuildErrorCode::length_overflow, .key = i};
  }
  return std::nullopt;
}

/// The time of the first period that corresponds to t: start + (t - start) modulo the period, by doubling and halving.
template <class S>
Time<S> Curve<S>::wrapped(const Time<S>& t) const {
  const Time<S>& start = segments_.times.front();
  const Time<S>& end = segments_.times.back();
  if ((start <= t && t <= end) || !is_finite(t)) return is_finite(t) ? t : t - t;
  const W period = end - start;
  W left = t < start ? start - t : t - start;
  W step = period;
  int doublings = 0;
  for (; step <= left; ++doublings) step = step + step;
  for (; doublings > 0; --doublings) {
    step = halved(step);
    if (step <= left) left = left - step;
  }
  const W inside = t < start && left != W(0) ? end - left : start + left;
  return std::clamp(inside, start, end);
}

template <class S>
typename Curve<S>::Spot Curve<S>::spot_inside(const Time<S>& t, Side side) const {
  const auto& times = segments_.times;
  const std::size_t i = find_time(t, side);
  const W duration = times[i + 1] - times[i];
  const S passed = duration == W(0) ? S(0) : high_part<S>((t - times[i]) / duration);
  const Warp<S> warp = segments_.warp(i);
  const EasePart part = warp.part(W(t - times[i]), W(times[i + 1] - t), duration, side);
  return {i, TimeMap<S>(times[i], times[i + 1], warp)(t), passed, part};
}

/// Sets the numbers of all channels at a place on a segment.
template <class S>
void Curve<S>::position_at(std::size_t segment, const LocalParameter<S>& at, std::span<S> out) const {
  const auto cubics = segments_[segment];
  for (std::size_t i = 0; i < std::min(out.size(), cubics.size()); ++i) out[i] = spline::position(cubics[i], at);
  for (const AngleChannel& angle : rules_.angles) {
    if (angle.channel < out.size()) out[angle.channel] = spline::wrapped(out[angle.channel], angle.degrees, false);
  }
  if constexpr (has_roots<S>) {
    for (std::size_t i = 0; i < rules_.rotations.size(); ++i) {
      const auto [x, y, z, w] = segments_.rotations_of(segment)[i].at(at);
      const std::array numbers{x, y, z, w};
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (rules_.rotations[i].channels[k] < out.size()) out[rules_.rotations[i].channels[k]] = numbers[k];
      }
    }
  }
}

/// The angular velocity of a rotation.
template <class S>
Vector3<S> Curve<S>::turn_rate(const Spot& at, std::size_t number) const requires has_roots<S> {
  const S h = high_part<S>(segments_.times[at.segment + 1] - segments_.times[at.segment]);
  if (h == S(0)) return {S(0), S(0), S(0)};
  const S rate = segments_.warp(at.segment).first_derivative(at.passed, at.part) / h;
  const auto [x, y, z] = segments_.rotations_of(at.segment)[number].rate(at.local);
  return {x * rate, y * rate, z * rate};
}

/// Sets the derivatives of the numbers of rotations by time: of order 1 half the angular velocity times the rotation.
template <class S>
void Curve<S>::rotation_derivative(std::size_t order, const Spot& at, std::span<S> out) const requires has_roots<S> {
  for (std::size_t i = 0; i < rules_.rotations.size(); ++i) {
    const auto [x, y, z] = turn_rate(at, i);
    const auto [qx, qy, qz, qw] =
        Quaternion<S>{x, y, z, S(0)} * segments_.rotations_of(at.segment)[i].at(at.local) * S(0.5);
    const std::array numbers{qx, qy, qz, qw};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::size_t channel = rules_.rotations[i].channels[k];
      if (channel < out.size()) out[channel] = order == 1 ? numbers[k] : std::numeric_limits<S>::quiet_NaN();
    }
  }
}

template <class S>
void Curve<S>::derivative(std::size_t order, const Time<S>& t, std::span<S> out, Side side) const {
  if (order == 0) return position(t, out);
  const Spot at = spot(t, side);
  const S h = high_part<S>(segments_.times[at.segment + 1] - segments_.times[at.segment]);
  const auto cubics = segments_[at.segment];
  const Warp<S> warp = segments_.warp(at.segment);
  for (std::size_t i = 0; i < std::min(out.size(), cubics.size()); ++i) {
    out[i] = h == S(0) ? S(0) : time_derivative(order, cubics[i], at.local, warp, at.passed, h, at.part);
  }
  if constexpr (has_roots<S>) rotation_derivative(order, at, out);
}

template <class S>
std::size_t Curve<S>::find_length(const W& s, Side side) const requires has_roots<S> {
  const auto before = [&s](const W& length) { return W(high_part<S>(length)) < s; };
  const auto end = std::partition_point(lengths_.begin() + 1, lengths_.end() - 1, before);
  const auto i = static_cast<std::size_t>(end - lengths_.begin()) - 1;
  if (side == Side::left || i + 1 == segment_count()) return i;
  const S start = high_part<S>(lengths_[i]), stop = high_part<S>(lengths_[i + 1]);
  return W(stop) == s && start != stop ? i + 1 : i;
}

template <class S>
S Curve<S>::at_length(const S& s, std::span<S> out) const requires has_roots<S> {
  const auto& times = segments_.times;
  const std::size_t i = find_length(W(s));
  SegmentLength<S> own;
  const auto local = s == s ? arc(i, own).place(lengths_[i], lengths_[i + 1], W(s)) : LocalParameter<S>{s, s};
  position_at(i, local, out);
  if (local.u == S(0)) return high_part<S>(times[i]);
  if (local.w == S(0)) return high_part<S>(times[i + 1]);
  return high_part<S>(times[i] + (times[i + 1] - times[i]) * segments_.warp(i).inverse(local));
}

#ifdef TCB_SPLINE_CURVE_DOUBLE
extern template class Curve<double>;
#endif

}  // namespace tcb::spline
