// Window segments: the segments between the keys of a window.
#pragma once

#include <cstddef>

#include "tcb/spline/detail/rotation_of_window.hpp"
#include "tcb/spline/detail/tangents.hpp"
#include "tcb/spline/detail/time_slopes.hpp"
#include "tcb/spline/rules.hpp"
#include "tcb/spline/segments.hpp"
#include "tcb/spline/window.hpp"

namespace tcb::spline {

/// The segments of a window; none where it has none yet. A single key is a constant segment.
template <class S>
Segments<S> segments(const Window<S>& window, const CurveRules<S>& rules) {
  if (window.is_single_key()) return constant_segment(window.keys, rules);
  if (!window.has_segments()) return {};
  const Keys<S>& keys = window.keys;
  const Tangents<S> tangents(window, rules);
  const TimeSlopes<S> time_slopes(window);
  Segments<S> result{keys.channels, {}, {}, {}};
  result.cubics.reserve((window.last_key() - window.first_key()) * keys.channels);
  for (std::size_t key = window.first_key(); key < window.last_key(); ++key) {
    result.times.push_back(keys.times[key]);
    for (std::size_t i = 0; i < keys.channels; ++i) {
      result.cubics.push_back(cubic<S>(keys.position(key)[i], keys.position(key + 1)[i], tangents.chord(key)[i],
                                       tangents.outgoing(key)[i], tangents.incoming(key + 1)[i]));
    }
    result.limited_tangents += tangents.limited(key);
    if (!keys.eases.empty()) result.warps.emplace_back(keys.eases[key].out, keys.eases[key + 1].in);
    if (rules.timing == Timing::monotone) result.warps.push_back(time_slopes.warp(key));
  }
  result.times.push_back(keys.times[window.last_key()]);
  if constexpr (has_roots<S>) {
    set_rotations(result, window, rules);
  }
  return result;
}

#ifdef TCB_SPLINE_CURVE_DOUBLE
extern template Segments<double> segments(const Window<double>& window, const CurveRules<double>& rules);
#endif

}  // namespace tcb::spline
