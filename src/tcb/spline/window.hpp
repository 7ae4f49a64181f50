// Windows: successive keys with one key of context on either side, whose segments can be made.
//
// Segment i is complete with the key after its end: its end tangent needs both neighbours. A window is therefore a few
// keys with one key of context on either side, unless the curve starts or ends there.
#pragma once

#include <cstddef>

#include "tcb/spline/keys.hpp"

namespace tcb::spline {

/// Successive keys of one curve, with the key before and the key after those of the segments.
template <class S>
struct Window {
  Keys<S> keys;
  bool starts = true;  ///< the first key is the curve's first, not context
  bool ends = true;    ///< the last key is the curve's last, not context
  bool last = true;    ///< no window follows

  std::size_t first_key() const { return starts ? 0 : 1; }
  std::size_t last_key() const { return keys.size() - (ends ? 1 : 2); }
  bool is_single_key() const { return starts && ends && keys.size() == 1; }
  bool has_segments() const { return keys.size() > (starts ? 1U : 2U) + (ends ? 0U : 1U); }
};

/// The time of a key of a closed curve after a number of periods, which may be negative. `end`: when the curve is back
/// at its first key, which is at `start`.
template <class S>
Time<S> after_periods(const Time<S>& time, const Time<S>& start, const Time<S>& end, int periods) {
  if (periods == 0) return time;
  if (periods == 1 && time == start) return end;
  return time + Time<S>(periods) * (end - start);
}

}  // namespace tcb::spline
