// Curves: keys linked to segments, a window of keys at a time.
//
// Segment i is known once the key after its end is: its end tangent needs both neighbours. A window
// is therefore some keys with one key of context on either side, unless the curve starts or ends there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "spline/end.hpp"
#include "spline/key.hpp"
#include "spline/segment.hpp"
#include "spline/tangent.hpp"

namespace tcb::spline {

/// Which rules make the tangents, as indices into tangent_rules and end_rules.
struct CurveRules {
  std::size_t tangents = 0;
  std::size_t start = 0;
  std::size_t end = 0;
};

/// Successive keys of one curve, with the key before and the key after those whose segments are wanted.
template <class S>
struct Window {
  Keys<S> keys;
  bool starts = true;  ///< the first key is the curve's first, not context
  bool ends = true;    ///< the last key is the curve's last, not context

  std::size_t first_key() const { return starts ? 0 : 1; }
  std::size_t last_key() const { return keys.size() - (ends ? 1 : 2); }
  bool has_segments() const { return keys.size() > (starts ? 1U : 2U) + (ends ? 0U : 1U); }
};

/// Successive segments. Shapes: one more time than segments; `channels` cubics a segment.
template <class S>
struct Segments {
  std::size_t channels = 0;
  std::vector<Time<S>> times;
  std::vector<Cubic<S>> cubics;

  std::size_t size() const { return times.empty() ? 0 : times.size() - 1; }
  std::span<const Cubic<S>> operator[](std::size_t segment) const {
    return std::span(cubics).subspan(segment * channels, channels);
  }
};

/// The tangents at the keys of a window, `channels` numbers a key; context keys are left at zero.
template <class S>
struct Tangents {
  std::vector<working_t<S>> incoming, outgoing;
};

/// P[key + 1] - P[key] in one channel.
template <class S>
working_t<S> chord(const Keys<S>& keys, std::size_t key, std::size_t channel) {
  using W = working_t<S>;
  return W(keys.position(key + 1)[channel]) - W(keys.position(key)[channel]);
}

/// Both tangents of a key that has two neighbours.
template <class S>
void set_interior(const Keys<S>& keys, std::size_t key, const TangentRule<S>& rule, Tangents<S>& tangents) {
  const auto h0 = keys.times[key] - keys.times[key - 1];
  const auto h1 = keys.times[key + 1] - keys.times[key];
  const auto weights = rule.weights(factors(keys.tcb(key)), h0, h1);
  for (std::size_t i = 0; i < keys.channels; ++i) {
    const auto d0 = chord(keys, key - 1, i);
    const auto d1 = chord(keys, key, i);
    tangents.incoming[key * keys.channels + i] = weights.in0 * d0 + weights.in1 * d1;
    tangents.outgoing[key * keys.channels + i] = weights.out0 * d0 + weights.out1 * d1;
  }
}

/// The outgoing tangent of the curve's first key.
template <class S>
void set_start(const Keys<S>& keys, const EndRule<S>& rule, Tangents<S>& tangents) {
  const auto f = factors(keys.tcb(0));
  const auto weights = rule.weights({f.b, f.a, keys.times[1] - keys.times[0]});
  for (std::size_t i = 0; i < keys.channels; ++i) {
    tangents.outgoing[i] = weights.chord * chord(keys, 0, i) + weights.other * tangents.incoming[keys.channels + i];
  }
}

/// The incoming tangent of the curve's last key.
template <class S>
void set_end(const Keys<S>& keys, const EndRule<S>& rule, Tangents<S>& tangents) {
  const std::size_t last = keys.size() - 1;
  const auto f = factors(keys.tcb(last));
  const auto weights = rule.weights({f.c, f.d, keys.times[last] - keys.times[last - 1]});
  for (std::size_t i = 0; i < keys.channels; ++i) {
    tangents.incoming[last * keys.channels + i] =
        weights.chord * chord(keys, last - 1, i) + weights.other * tangents.outgoing[(last - 1) * keys.channels + i];
  }
}

template <class S>
Tangents<S> tangents(const Window<S>& window, const CurveRules& rules) {
  const Keys<S>& keys = window.keys;
  const std::vector<working_t<S>> zero(keys.size() * keys.channels, working_t<S>(0));
  Tangents<S> result{zero, zero};
  for (std::size_t key = 1; key + 1 < keys.size(); ++key) {
    set_interior(keys, key, tangent_rules<S>[rules.tangents], result);
  }
  if (window.starts) set_start(keys, end_rules<S>[rules.start], result);
  if (window.ends) set_end(keys, end_rules<S>[rules.end], result);
  return result;
}

/// The segments that a window makes known. Requires: window.has_segments().
template <class S>
Segments<S> segments(const Window<S>& window, const CurveRules& rules) {
  const Keys<S>& keys = window.keys;
  const Tangents<S> slopes = tangents(window, rules);
  const std::size_t first = window.first_key();
  const std::size_t last = window.last_key();
  Segments<S> result;
  result.channels = keys.channels;
  result.times.assign(keys.times.begin() + static_cast<std::ptrdiff_t>(first),
                      keys.times.begin() + static_cast<std::ptrdiff_t>(last + 1));
  result.cubics.reserve((last - first) * keys.channels);
  for (std::size_t i = first * keys.channels; i < last * keys.channels; ++i) {
    const std::size_t next = i + keys.channels;
    result.cubics.push_back(
        cubic<S>(keys.positions[i], keys.positions[next], slopes.outgoing[i], slopes.incoming[next]));
  }
  return result;
}

/// Cuts a stream of keys into windows. It holds three keys, whatever the length of the curve.
template <class S>
class Linker {
 public:
  /// The window that some more keys make known; it may have no segments yet. `last`: no keys follow.
  Window<S> link(const Keys<S>& block, bool last) {
    Window<S> window{std::move(tail_), starts_, last};
    append(window.keys, block, 0, block.size());
    tail_ = {};
    if (last) return window;
    if (window.has_segments()) starts_ = false;
    const std::size_t size = window.keys.size();
    append(tail_, window.keys, starts_ ? 0 : size - 3, size);
    return window;
  }

 private:
  Keys<S> tail_;
  bool starts_ = true;
};

}  // namespace tcb::spline
