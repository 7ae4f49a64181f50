// Windows: successive keys with one key of context on either side, and the segments that they make.
//
// Segment i is complete with the key after its end: its end tangent needs both neighbours. A window is therefore a few
// keys with one key of context on either side, unless the curve starts or ends there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/ease.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rules.hpp"
#include "tcb/spline/segment.hpp"

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

/// Cuts a stream of keys into windows. It keeps three keys, for a curve of any length; of a closed curve five.
template <class S>
class Linker {
 public:
  /// For an open curve.
  Linker() = default;
  /// For a closed curve: `last` is its last key, and `end` the time when it is back at the first one; see closing.hpp.
  Linker(Keys<S> last, const Time<S>& end) : tail_(std::move(last)), end_(end), starts_(false) {}

  /// The window that these keys complete; it may have no segments yet. `ends`: no keys follow.
  Window<S> link(const Keys<S>& block, bool ends) {
    if (end_ && block.size() > 0) keep_first_keys(block);
    Window<S> window{std::move(tail_), starts_, ends && !end_, ends};
    append(window.keys, block, 0, block.size());
    tail_ = {};
    if (ends && end_) append_period(window.keys);
    if (ends) return window;
    if (window.has_segments()) starts_ = false;
    const std::size_t size = window.keys.size();
    append(tail_, window.keys, starts_ || size < 3 ? 0 : size - 3, size);
    return window;
  }

 private:
  /// Keeps the first two keys, and once the first one is known, puts the last one a period before it.
  void keep_first_keys(const Keys<S>& block) {
    if (first_.size() == 0) tail_.times[0] = after_periods<S>(tail_.times[0], block.times[0], *end_, -1);
    if (first_.size() < 2) append(first_, block, 0, std::min(2 - first_.size(), block.size()));
  }

  /// Appends the first two keys one period later. Requires: two keys.
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

/// The rule at one end of an open curve.
template <class S>
struct EndChoice {
  EndRule rule = EndRule::half;
  std::vector<S> velocity;  ///< per unit of time, one number per channel, where the rule takes one
};

/// The rules that give the tangents of keys.
template <class S>
struct CurveRules {
  TangentRule tangents = TangentRule::velocity;
  EndChoice<S> start, end;
  bool equal_speed = false;                 ///< both tangents of a key get the same speed
  std::vector<std::size_t> metric;          ///< the channels of speeds and lengths; empty: all; or turn_metric
  std::vector<KeyRotation> rotations = {};  ///< not in the metric
  RotationRules rotation_rules = {};
  std::vector<AngleChannel> angles = {};
};

/// Whether a channel is neither an angle nor a number of a rotation.
template <class S>
bool is_plain(const CurveRules<S>& rules, std::size_t channel) {
  return !is_in_rotation(rules.rotations, channel) &&
         std::ranges::count(rules.angles, channel, &AngleChannel::channel) == 0;
}

/// The difference between the positions of a key and the next one in a channel; that of angles is less than half a
/// turn.
template <class S>
struct PositionChord {
  const Keys<S>& keys;
  const std::vector<AngleChannel>& angles;

  working_t<S> operator()(std::size_t key, std::size_t channel) const {
    const auto chord = exact_difference(keys.position(key + 1)[channel], keys.position(key)[channel]);
    for (const AngleChannel& angle : angles) {
      if (angle.channel == channel) return chord - nearest_turns<S>(chord, angle.degrees);
    }
    return chord;
  }
};

/// The rules of a product, the same end rule for both ends.
template <class S>
CurveRules<S> rules_of(Preset preset) {
  const PresetRow& row = row_of(preset);
  return {row.tangents, {row.ends, {}}, {row.ends, {}}, false, {}, {}, row.rotations};
}

/// The rules that give the tangents of rotations, over all their numbers.
template <class S>
CurveRules<S> rules_of_rotations(CurveRules<S> rules) {
  const RotationRules& own = rules.rotation_rules;
  rules.metric.clear();
  if (own.tangents) rules.tangents = *own.tangents;
  if (own.ends) rules.start = rules.end = {*own.ends, {}};
  return rules;
}

/// Successive segments. Shapes: one more time than segments; `channels` cubics per segment; one warp per
/// segment, or none if no key has ease; as many rotations per segment as the rules have, which replace the cubics of
/// their channels.
template <class S>
struct Segments {
  std::size_t channels = 0;
  std::vector<Time<S>> times;
  std::vector<Cubic<S>> cubics;
  std::vector<Warp<S>> warps;
  std::vector<RotationSegment<S>> rotations = {};

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

}  // namespace tcb::spline
