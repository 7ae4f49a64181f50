// The linker: cuts a stream of keys into windows whose segments are known.
//
// Segment i is known once the key after its end is: its end tangent needs both neighbours. A window
// is therefore some keys with one key of context on either side, unless the curve starts or ends there.
#pragma once

#include <cstddef>
#include <utility>

#include "tcb/spline/key.hpp"

namespace tcb::spline {

/// Successive keys of one curve, with the key before and the key after those whose segments are wanted.
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

/// It holds three keys, whatever the length of the curve.
template <class S>
class Linker {
 public:
  /// For an open curve.
  Linker() = default;
  /// For a closed curve: the key before the first one is context. The keys to be linked end with the
  /// first key come round again, and one key more.
  explicit Linker(Keys<S> context) : tail_(std::move(context)), starts_(false), closed_(true) {}

  /// The window that some more keys make known; it may have no segments yet. `last`: no keys follow.
  Window<S> link(const Keys<S>& block, bool last) {
    Window<S> window{std::move(tail_), starts_, last && !closed_, last};
    append(window.keys, block, 0, block.size());
    tail_ = {};
    if (last) return window;
    if (window.has_segments()) starts_ = false;
    const std::size_t size = window.keys.size();
    append(tail_, window.keys, starts_ || size < 3 ? 0 : size - 3, size);
    return window;
  }

 private:
  Keys<S> tail_;
  bool starts_ = true;
  bool closed_ = false;
};

}  // namespace tcb::spline
