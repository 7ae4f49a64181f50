// Segments: the cubics, warps and rotations between successive keys, and the segment at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/curve_rules.hpp"
#include "tcb/spline/ease.hpp"
#include "tcb/spline/keys.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segment.hpp"

namespace tcb::spline {

/// Successive segments. Shapes: one more time than segments; `channels` cubics per segment; one warp per
/// segment, or none if no key has ease and the timing is even; as many rotations per segment as the rules have, which
/// replace the cubics of their channels; those by components are these cubics, normalized.
template <class S>
struct Segments {
  std::size_t channels = 0;
  std::vector<Time<S>> times;
  std::vector<Cubic<S>> cubics;
  std::vector<Warp<S>> warps;
  std::vector<RotationSegment<S>> rotations = {};
  std::size_t limited_tangents = 0;  ///< of their cubics, so that they do not overshoot

  std::size_t size() const { return times.empty() ? 0 : times.size() - 1; }
  std::span<const Cubic<S>> operator[](std::size_t segment) const {
    return std::span(cubics).subspan(segment * channels, channels);
  }
  Warp<S> warp(std::size_t segment) const { return warps.empty() ? Warp<S>() : warps[segment]; }
  std::span<const RotationSegment<S>> rotations_of(std::size_t segment) const {
    const std::size_t per_segment = rotations.size() / size();
    return std::span(rotations).subspan(segment * per_segment, per_segment);
  }
};

/// A single key as a constant segment without duration.
template <class S>
Segments<S> constant_segment(const Keys<S>& keys, const CurveRules<S>& rules) {
  Segments<S> result{keys.channels, {keys.times[0], keys.times[0]}, {}, {}};
  for (const S& p : keys.positions) result.cubics.push_back(cubic<S>(p, p, working_t<S>(0), working_t<S>(0)));
  if constexpr (has_roots<S>) {
    for (const KeyRotation& rotation : rules.rotations) {
      const Quaternion<S> q = rotation_of<S>(keys.position(0), rotation.channels);
      result.rotations.push_back({RotationCurve::slerp, {q, q, q, q}});
    }
  }
  return result;
}

/// Appends the segments that follow. Requires: they begin where the others end, and have as many channels, warps and
/// rotations per segment.
template <class S>
void append(Segments<S>& to, const Segments<S>& next) {
  to.channels = next.channels;
  if (!to.times.empty()) to.times.pop_back();
  to.times.insert(to.times.end(), next.times.begin(), next.times.end());
  to.cubics.insert(to.cubics.end(), next.cubics.begin(), next.cubics.end());
  to.warps.insert(to.warps.end(), next.warps.begin(), next.warps.end());
  to.rotations.insert(to.rotations.end(), next.rotations.begin(), next.rotations.end());
  to.limited_tangents += next.limited_tangents;
}

/// The number of the segment at time t: of two that meet there, the one on that side. Before the first segment it is
/// the first one, and after the last segment the last one. `times`: one more than segments; at least two.
template <class T>
std::size_t segment_at_time(std::span<const T> times, const T& t, Side side) {
  const auto ends = times.subspan(1, times.size() - 2);  // where the next segment begins
  const auto end = side == Side::left ? std::lower_bound(ends.begin(), ends.end(), t)
                                      : std::upper_bound(ends.begin(), ends.end(), t);
  return static_cast<std::size_t>(end - ends.begin());
}

}  // namespace tcb::spline
