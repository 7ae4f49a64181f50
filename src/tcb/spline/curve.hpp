// Curve: an open or closed Kochanek-Bartels curve, built from keys and rules, evaluated by time or by arc length.
//
// On segment i, from key i at t_i to key i+1, with h = t_(i+1) - t_i, u = (t - t_i)/h (warped where keys have ease) and
// `out`, `in` the tangents by the rules of rules.hpp:
//   X(u) = (2u^3 - 3u^2 + 1) P_i + (3u^2 - 2u^3) P_(i+1) + (u^3 - 2u^2 + u) out_i + (u^3 - u^2) in_(i+1)
// Source: D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", section 2; for rules and lengths see rules.hpp and
//   arc_length.hpp.
// Units: times and lengths as the keys have them; derivatives per unit of time to the power of their order.
// Threads: a curve does not change once it is built; any number of threads may evaluate it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/build_error.hpp"
#include "tcb/spline/derivatives.hpp"
#include "tcb/spline/tangents.hpp"

namespace tcb::spline {

template <class S>
class Curve;

/// A curve, or the error that prevents it.
template <class S>
class BuildResult {
 public:
  BuildResult(Curve<S> curve) : result_(std::move(curve)) {}  // NOLINT(google-explicit-constructor): either
  BuildResult(BuildError error) : result_(error) {}           // NOLINT(google-explicit-constructor): converts

  /// Whether there is a curve.
  explicit operator bool() const { return std::holds_alternative<Curve<S>>(result_); }

  /// The curve. Throws: std::bad_variant_access if there is none.
  const Curve<S>& operator*() const& { return std::get<Curve<S>>(result_); }
  Curve<S>&& operator*() && { return std::get<Curve<S>>(std::move(result_)); }
  const Curve<S>* operator->() const { return &**this; }

  /// The error. Throws: std::bad_variant_access if there is none.
  const BuildError& error() const { return std::get<BuildError>(result_); }

 private:
  std::variant<Curve<S>, BuildError> result_;
};

/// The cubic of each channel between two times. Valid as long as the curve exists.
template <class S>
struct Segment {
  Time<S> start, end;
  std::span<const Cubic<S>> cubics;  ///< one per channel
  Warp<S> warp;                      ///< of u; the identity where keys have no ease
};

/// The side of a knot time from which a derivative is taken; the two differ at a key with a corner.
enum class Side : std::uint8_t { left, right };

/// Shapes: `out` takes one number per channel; if it is shorter, only the first channels are computed.
/// No evaluation allocates memory or throws. A time of NaN gives NaN.
template <class S>
class Curve {
 public:
  /// An open curve. One key gives a constant. The result has the error in the keys or rules, if there is one.
  static BuildResult<S> build(Keys<S> keys, const CurveRules<S>& rules = {}) {
    if (const auto error = find_key_error(keys)) return *error;
    if (const auto error = find_rule_error(rules, keys, false)) return *error;
    return of_window({std::move(keys)}, rules, false);
  }

  /// A closed curve: one more segment joins the last key to the first, which repeats after the period. A last key at
  /// exactly the position of the first only ends the period and needs none; it must have the same tension, continuity
  /// and bias, and its incoming velocity counts. The end rules have no effect. The result may be an error.
  static BuildResult<S> build_closed(Keys<S> keys, const CurveRules<S>& rules = {},
                                     const std::optional<Time<S>>& period = std::nullopt);

  std::size_t channels() const { return segments_.channels; }
  bool is_closed() const { return closed_; }
  /// The times of the first key and of the last key or, if closed, of the return to the first.
  S start() const { return high_part<S>(segments_.times.front()); }
  S end() const { return high_part<S>(segments_.times.back()); }

  /// The number of segments: one less than keys, or as many if closed. A single key has one, without duration.
  std::size_t segment_count() const { return segments_.size(); }

  /// Segment number i, from 0. Requires: i < segment_count().
  Segment<S> segment(std::size_t i) const {
    return {segments_.times[i], segments_.times[i + 1], segments_[i], segments_.warp(i)};
  }

  /// X(t). Before the start and after the end, an open curve keeps its end positions; a closed curve is periodic.
  /// Promises: within 3 ulp of the largest of |P_i|, |P_(i+1)|, |out_i|, |in_(i+1)|; at a key, its position exactly.
  void position(const Time<S>& t, std::span<S> out) const {
    const auto [segment, at, passed] = spot(t, Side::right);
    const auto cubics = segments_[segment];
    for (std::size_t i = 0; i < std::min(out.size(), cubics.size()); ++i) out[i] = spline::position(cubics[i], at);
  }

  /// X(t) for many times. Shapes: `out` takes channels() numbers per time, time after time; times for which it has no
  /// room are skipped.
  void positions(std::span<const S> times, std::span<S> out) const {
    const std::size_t count = std::min(times.size(), out.size() / channels());
    for (std::size_t i = 0; i < count; ++i) position(times[i], out.subspan(i * channels(), channels()));
  }

  /// dX/dt, at a key from one side; outside an open curve that of its end. The same as derivative(1, ...).
  void velocity(const Time<S>& t, std::span<S> out, Side side = Side::right) const { derivative(1, t, out, side); }

  /// The derivative of any order by time, at a key from one side (at the ends of an open curve, from inside). Outside
  /// an open curve it is that of the end; a single key has the derivative 0. Order 0 is the position. Infinite or NaN
  /// where it exceeds the range of the scalar.
  void derivative(std::size_t order, const Time<S>& t, std::span<S> out, Side side = Side::right) const;

  /// The length over the metric channels from the start to the end, with a bound on its error. Promises: see ArcLength.
  Length<S> length() const requires has_roots<S> { return {high_part<S>(lengths_.back()), error_}; }

  /// The length from the start to a time; a time outside the curve is moved to its start or end.
  Length<S> length_to(const Time<S>& t) const requires has_roots<S> {
    const Spot at = spot_inside(std::clamp(t, segments_.times.front(), segments_.times.back()), Side::left);
    return {high_part<S>(lengths_[at.segment] + working_t<S>(arcs_[at.segment].to(at.local).value)), error_};
  }

  /// The first time at which the length from the start is s, rounded; also sets `out` to the position there, which is
  /// that of the exact length. A length below 0 or above that of the curve gives the start or the end.
  /// Promises: accurate to a few units in the last place of the length of the segment.
  S at_length(const S& s, std::span<S> out = {}) const requires has_roots<S>;

 private:
  using W = working_t<S>;

  /// A place on the curve.
  struct Spot {
    std::size_t segment;
    LocalParameter<S> local;
    S passed;  ///< the elapsed fraction of the segment's duration
  };

  Curve(Segments<S> segments, std::vector<std::size_t> metric, bool closed)
      : segments_(std::move(segments)), metric_(std::move(metric)), closed_(closed) {}

  static BuildResult<S> of_window(const Window<S>& window, const CurveRules<S>& rules, bool closed);
  std::optional<BuildError> find_overflow() const;
  std::optional<BuildError> measure();

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

  Segments<S> segments_;
  std::vector<std::size_t> metric_;
  bool closed_;
  std::vector<ArcLength<S>> arcs_;  ///< one per segment
  std::vector<W> lengths_;          ///< up to each knot
  S error_{};                       ///< a bound on the error of the lengths
};

template <class S>
BuildResult<S> Curve<S>::build_closed(Keys<S> keys, const CurveRules<S>& rules, const std::optional<Time<S>>& period) {
  using enum BuildErrorCode;
  if (const auto error = find_key_error(keys)) return *error;
  if (const auto error = find_rule_error(rules, keys, true)) return *error;
  if (period && !is_finite(*period)) return BuildError{.code = period_not_finite};
  const std::size_t last = keys.size() - 1;
  auto end = period ? std::optional<Time<S>>(keys.times[0] + *period) : std::nullopt;
  const bool repeated = last > 0 && std::ranges::equal(keys.position(0), keys.position(last));
  if (repeated) {
    for (std::size_t i = 0; i < keys.channels; ++i) {
      if (keys.tcb(last, i) != keys.tcb(0, i)) return BuildError{.code = seam_tcb_differs, .key = last, .channel = i};
    }
    if (end && *end != keys.times[last]) return BuildError{.code = period_contradicted, .key = last};
    end = keys.times[last];
  } else if (end && !(*end > keys.times[last])) {
    return BuildError{.code = period_too_short, .key = last};
  }
  const std::size_t count = repeated ? last : last + 1;
  if (count < 2) return BuildError{.code = closed_too_few_keys, .found = count};
  if (!end) return BuildError{.code = period_missing};
  const Time<S> duration = *end - keys.times[0];
  if (!is_finite(*end) || !is_finite(duration)) return BuildError{.code = period_not_finite};
  for (std::size_t i = 0; repeated && !keys.velocities.empty() && i < keys.channels; ++i) {
    keys.velocities[i].in = keys.velocities[last * keys.channels + i].in;
    keys.velocities[last * keys.channels + i].out = keys.velocities[i].out;
  }
  if (repeated) std::ranges::copy(std::span(keys.turns).last(keys.turns_per_key()), keys.turns.begin());
  if (const auto error = find_velocity_error(keys, true)) return *error;
  Window<S> window{{}, false, false, true};
  const auto add = [&](std::size_t key, const Time<S>& time) {
    append(window.keys, keys, key, key + 1);
    window.keys.times.back() = time;
  };
  add(count - 1, keys.times[count - 1] - duration);
  append(window.keys, keys, 0, count);
  add(0, *end);
  add(1, keys.times[1] + duration);
  return of_window(window, rules, true);
}

template <class S>
BuildResult<S> Curve<S>::of_window(const Window<S>& window, const CurveRules<S>& rules, bool closed) {
  Curve curve(spline::segments(window, rules), rules.metric, closed);
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
std::optional<BuildError> Curve<S>::measure() {
  lengths_.push_back(W(0));
  arcs_.reserve(segments_.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    arcs_.emplace_back(segments_[i], metric_);
    const Length<S> length = arcs_.back().total();
    lengths_.push_back(lengths_.back() + W(length.value));
    error_ += length.error;
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
  const auto first = times.begin() + 1, last = times.end() - 1;
  const auto after = side == Side::left ? std::lower_bound(first, last, t) : std::upper_bound(first, last, t);
  const auto i = static_cast<std::size_t>(after - first);
  const W duration = times[i + 1] - times[i];
  const S passed = duration == W(0) ? S(0) : high_part<S>((t - times[i]) / duration);
  return {i, TimeMap<S>(times[i], times[i + 1], segments_.warp(i))(t), passed};
}

template <class S>
void Curve<S>::derivative(std::size_t order, const Time<S>& t, std::span<S> out, Side side) const {
  if (order == 0) return position(t, out);
  const Spot at = spot(t, side);
  const S h = high_part<S>(segments_.times[at.segment + 1] - segments_.times[at.segment]);
  const auto cubics = segments_[at.segment];
  const Warp<S> warp = segments_.warp(at.segment);
  for (std::size_t i = 0; i < std::min(out.size(), cubics.size()); ++i) {
    out[i] = h == S(0) ? S(0) : time_derivative(order, cubics[i], at.local, warp, at.passed, h);
  }
}

template <class S>
S Curve<S>::at_length(const S& s, std::span<S> out) const requires has_roots<S> {
  const auto& times = segments_.times;
  const auto from = std::lower_bound(lengths_.begin() + 1, lengths_.end() - 1, W(s));
  const auto i = static_cast<std::size_t>(from - lengths_.begin()) - 1;
  const auto local = s == s ? ArcInverse<S>(arcs_[i], lengths_[i], lengths_[i + 1]).at(W(s)) : LocalParameter<S>{s, s};
  const auto cubics = segments_[i];
  for (std::size_t k = 0; k < std::min(out.size(), cubics.size()); ++k) out[k] = spline::position(cubics[k], local);
  if (local.u == S(0)) return high_part<S>(times[i]);
  if (local.w == S(0)) return high_part<S>(times[i + 1]);
  return high_part<S>(times[i] + (times[i + 1] - times[i]) * segments_.warp(i).inverse(local));
}

}  // namespace tcb::spline
