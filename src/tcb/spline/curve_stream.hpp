// Curve stream: from keys to segments in constant memory, for curves of any length.
//
// Keys are pushed in blocks of any size. Each push gives the window of keys that it completes, and segments() makes the
// segments of a window, at once or later, on any thread:
//
//     CurveStream<double> stream;
//     while (read(block)) use(segments(stream.push(block), rules));
//     use(segments(stream.finish(), rules));
//
// Together these are the segments that Curve has, bit for bit; only the quaternions of a rotation may have the other
// sign, as each window takes that of its first key. A closed curve begins with what closes it, which
// find_closing() of closing.hpp finds. Keys that lack positions cannot be streamed, because the next key that has one
// may be any number of keys away; for them see CurveKeys.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "tcb/spline/window.hpp"
#include "tcb/spline/window_segments.hpp"

namespace tcb::spline {

/// Links keys to windows. It keeps three keys, or five of a closed curve.
template <class S>
class CurveStream {
 public:
  /// An open curve.
  CurveStream() = default;
  /// A closed curve. `last`: its last key alone, which will be pushed as well. `end`: when it is back at the first key.
  CurveStream(Keys<S> last, const Time<S>& end) : tail_(std::move(last)), end_(end), starts_(false) {}

  /// Takes the next keys. The result may have no segments yet. Requires: no BuildError, and no missing position.
  Window<S> push(const Keys<S>& keys) {
    if (end_ && keys.size() > 0) keep_first_keys(keys);
    Window<S> window{std::move(tail_), starts_, false, false};
    append(window.keys, keys, 0, keys.size());
    tail_ = {};
    if (window.has_segments()) starts_ = false;
    const std::size_t size = window.keys.size();
    append(tail_, window.keys, starts_ || size < 3 ? 0 : size - 3, size);
    return window;
  }

  /// What is left once all keys were pushed; a single key is a constant segment. Requires: it was not called before;
  /// for a closed curve two keys.
  Window<S> finish() {
    Window<S> window{std::move(tail_), starts_, !end_, true};
    if (end_) append_period(window.keys);
    return window;
  }

 private:
  /// Keeps the first two keys, and once the first one is known, puts the last one a period before it.
  void keep_first_keys(const Keys<S>& keys) {
    if (first_.size() == 0) tail_.times[0] = after_periods<S>(tail_.times[0], keys.times[0], *end_, -1);
    if (first_.size() < 2) append(first_, keys, 0, std::min(2 - first_.size(), keys.size()));
  }

  /// Appends the first two keys one period later.
  void append_period(Keys<S>& keys) {
    const Time<S> start = first_.times[0];
    for (Time<S>& time : first_.times) time = after_periods<S>(time, start, *end_, 1);
    append(keys, first_, 0, first_.size());
  }

  Keys<S> tail_;
  Keys<S> first_;  ///< of a closed curve: its first two keys
  std::optional<Time<S>> end_;
  bool starts_ = true;
};

}  // namespace tcb::spline
