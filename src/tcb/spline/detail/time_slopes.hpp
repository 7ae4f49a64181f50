// Time slopes: the slopes at keys of the monotone cubic from the times of keys to their numbers.
//
// With h0, h1 the durations before and after a key, the slope is 3 (h0 + h1)/(h0^2 + 4 h0 h1 + h1^2), a weighted
// harmonic mean. At an end, with h0 the duration of its segment and h1 that of the next one, it is that of the parabola
// through three keys, ((2 h0 + h1)/h0 - h0/h1)/(h0 + h1), but at least 0. Source: F. N. Fritsch, J. Butland, "A method
// for constructing local monotone piecewise cubic interpolants", 1984; for
//   the ends, the behaviour of PchipInterpolator of SciPy.
#pragma once

#include <algorithm>
#include <cstddef>

#include "tcb/spline/ease.hpp"
#include "tcb/spline/window.hpp"

namespace tcb::spline {

/// The warps of the segments of a window, from the slopes at their keys.
template <class S>
class TimeSlopes {
 public:
  using W = working_t<S>;

  /// Requires: at least two keys, and that `window` outlives it.
  explicit TimeSlopes(const Window<S>& window) : window_(window) {}

  /// The warp of the segment after a key.
  Warp<S> warp(std::size_t key) const {
    const std::size_t last = window_.keys.size() - 1;
    if (last == 1) return {};
    const W h = duration(key);
    const W first = key == 0 ? at_end(h, duration(1)) : between(duration(key - 1), h, h);
    const W second = key + 1 == last ? at_end(h, duration(key - 1)) : between(h, duration(key + 1), h);
    return Warp<S>::cubic(first, second);
  }

 private:
  W duration(std::size_t key) const { return window_.keys.times[key + 1] - window_.keys.times[key]; }

  /// The slope at a key, per duration `own` of one of its segments.
  static W between(const W& h0, const W& h1, const W& own) {
    const W unit = std::max(h0, h1);
    const W a = h0 / unit, b = h1 / unit;
    return W(3) * (a + b) * (own / unit) / (a * a + W(4) * a * b + b * b);
  }
  /// The slope at an end, per duration h0 of its segment.
  static W at_end(const W& h0, const W& h1) {
    const W unit = std::max(h0, h1);
    const W a = h0 / unit, b = h1 / unit;
    const W numerator = W(2) * a * b + b * b - a * a;
    return numerator > W(0) ? numerator / (b * (a + b)) : W(0);
  }

  const Window<S>& window_;
};

}  // namespace tcb::spline
