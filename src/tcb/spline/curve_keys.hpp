// Curve keys: the keys of an open or closed curve with its rules, and any of the segments that they make.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/window_segments.hpp"

namespace tcb::spline {

/// What makes the part of a segment between two times: part() or expanded_part().
template <class S>
using PartOfSegment = Cubic<S> (*)(const Cubic<S>& whole, const Time<S>& start, const Time<S>& end, const Time<S>& from,
                                   const Time<S>& to);

/// The range of times in which a closed curve passes all its keys once.
template <class S>
struct Period {
  Time<S> start, end;
};

/// Two successive keys among those that have a position in a channel, between which the channel has no curve.
struct ChannelGap {
  static constexpr std::size_t no_key = static_cast<std::size_t>(-1);
  std::size_t channel, first, last;  ///< `last` may be no_key: the channel has placeholders for all positions
};

/// One channel of a curve, or all of them, with the keys that have positions there, by their numbers from 0.
template <class S>
class ChannelKeys {
 public:
  /// `channel`: the only one; nothing: all. `period`: of a closed curve. `rules`: for these channels.
  /// Requires: `keys` outlives it; a number.
  ChannelKeys(const Keys<S>& keys, std::optional<std::size_t> channel, std::vector<std::size_t> numbers,
              CurveRules<S> rules, std::optional<Period<S>> period)
      : keys_(keys),
        channel_(channel),
        numbers_(std::move(numbers)),
        rules_(std::move(rules)),
        period_(std::move(period)) {
    if constexpr (has_roots<S>) {
      for (const KeyRotation& rotation : rules_.rotations) returns_negated_.push_back(period_ && is_negated(rotation));
    }
  }

  /// The first and the last one of its keys.
  std::size_t first_key() const { return numbers_.front(); }
  std::size_t last_key() const { return numbers_.back(); }

  /// Segments from key `first` to key `to`, counted among this channel's keys; on a closed curve any range of integers.
  Segments<S> own_segments(std::ptrdiff_t first, std::ptrdiff_t to) const {
    const bool starts = !period_ && first == 0, ends = !period_ && to >= last();
    Window<S> window{{}, starts, ends, true};
    append_own(window.keys, starts ? 0 : first - 1, ends ? last() : to + 1);
    return segments(window, rules_);
  }

  /// Appends the cubics of a channel between the keys `first` and `to` of the curve: parts of those between its own
  /// keys. Before the first of these and after the last, an open curve is constant. `times`: of all keys of the curve,
  /// and if it is closed of its end.
  void append_cubics(std::vector<Cubic<S>>& cubics, std::size_t channel, std::size_t first, std::size_t to,
                     const std::vector<Time<S>>& times, PartOfSegment<S> part) const {
    const Own own = own_between(first, to);
    for (std::size_t number = first; number < to; ++number) {
      const std::ptrdiff_t at = number_at(number);
      if (own.has(at)) {
        const std::size_t i = own.index(at);
        const Time<S>&start = own.segments.times[i], &end = own.segments.times[i + 1];
        cubics.push_back(part(own.segments[i][channel_ ? 0 : channel], start, end, times[number], times[number + 1]));
      } else {
        const S rest = resting_number(nearest_number(at), channel);
        cubics.push_back(cubic<S>(rest, rest, working_t<S>(0), working_t<S>(0)));
      }
    }
  }

  /// Appends the curves of the only rotation of the rules between the keys `first` and `to` of the curve, likewise.
  void append_rotations(std::vector<RotationSegment<S>>& rotations, std::size_t first, std::size_t to,
                        const std::vector<Time<S>>& times) const {
    const Own own = own_between(first, to);
    for (std::size_t number = first; number < to; ++number) {
      const std::ptrdiff_t at = number_at(number);
      if (own.has(at)) {
        const std::size_t i = own.index(at);
        const Time<S>&start = own.segments.times[i], &end = own.segments.times[i + 1];
        const auto fraction = [&](const Time<S>& from, const Time<S>& until) {
          return high_part<S>((until - from) / (end - start));
        };
        rotations.push_back(own.segments.rotations[i].part(fraction(start, times[number]),
                                                           fraction(times[number], times[number + 1]),
                                                           fraction(times[number + 1], end)));
      } else {
        const auto q = rotation_of<S>(keys_.position(nearest_number(at)), rules_.rotations[0].channels);
        rotations.push_back(RotationSegment<S>(RotationCurve::slerp, {q, q, q, q}));
      }
    }
  }

 private:
  /// Segments between its own keys `low` and `high`.
  struct Own {
    std::ptrdiff_t low, high;
    Segments<S> segments = {};

    bool has(std::ptrdiff_t at) const { return low <= at && at < high; }
    std::size_t index(std::ptrdiff_t at) const { return static_cast<std::size_t>(at - low); }
  };

  std::ptrdiff_t last() const { return static_cast<std::ptrdiff_t>(numbers_.size()) - 1; }

  /// The number of the last of these keys that is not after a key of the curve; -1 if there is none.
  std::ptrdiff_t number_at(std::size_t key) const {
    return std::ranges::upper_bound(numbers_, key) - numbers_.begin() - 1;
  }
  /// The key of the curve whose position an open curve keeps where there is no segment.
  std::size_t nearest_number(std::ptrdiff_t at) const { return at < 0 ? numbers_.front() : numbers_.back(); }

  /// The number of a channel at a key; that of a rotation is one of a unit quaternion.
  S resting_number(std::size_t key, std::size_t channel) const {
    if constexpr (has_roots<S>) {
      if (!channel_) {
        const RotationChannels& channels = rules_.rotations[0].channels;
        const auto [x, y, z, w] = rotation_of<S>(keys_.position(key), channels);
        return std::array{x, y, z,
                          w}[static_cast<std::size_t>(std::ranges::find(channels, channel) - channels.begin())];
      }
    }
    return keys_.position(key)[channel];
  }

  /// The segments that cover those between the keys `first` and `to` of the curve.
  Own own_between(std::size_t first, std::size_t to) const {
    Own own{number_at(first), number_at(to - 1) + 1};
    if (!period_) own.low = std::max<std::ptrdiff_t>(own.low, 0);
    if (!period_) own.high = std::min(own.high, last());
    if (own.low < own.high) own.segments = own_segments(own.low, own.high);
    return own;
  }

  /// Whether a rotation has the opposite sign when a closed curve is back at its first key.
  bool is_negated(const KeyRotation& rotation) const requires has_roots<S> {
    const std::size_t first = numbers_.front(), last = numbers_.back();
    Quaternion<S> q = rotation_of<S>(keys_.position(last), rotation.channels);
    if (rotation.turn && !keys_.turns.empty()) {
      q = q * exponential(keys_.turns[first * keys_.turns_per_key() + *rotation.turn]);
    }
    return dot(q, rotation_of<S>(keys_.position(first), rotation.channels)) < S(0);
  }

  /// Negates the rotations of the last key that return with the opposite sign.
  void negate_last(Keys<S>& keys) const {
    const std::size_t start = (keys.size() - 1) * keys.channels;
    for (std::size_t i = 0; i < returns_negated_.size(); ++i) {
      for (const std::size_t channel : rules_.rotations[i].channels) {
        if (!returns_negated_[i]) continue;
        keys.positions[start + channel] = S(0) - keys.positions[start + channel];
        if (keys.velocities.empty()) continue;
        auto& [in, out] = keys.velocities[start + channel];
        in = S(0) - in;
        out = S(0) - out;
      }
    }
  }

  /// Appends its keys from number `from` to `to`, on a closed curve by periodic extension: the keys of the period in
  /// which the curve begins have the signs that were given.
  void append_own(Keys<S>& keys, std::ptrdiff_t from, std::ptrdiff_t to) const {
    const std::ptrdiff_t count = last() + 1;
    for (std::ptrdiff_t number = from; number <= to; ++number) {
      const std::ptrdiff_t own = (number % count + count) % count;
      const std::size_t key = numbers_[static_cast<std::size_t>(own)];
      append_key(keys, key);
      if (!period_) continue;
      const auto periods = static_cast<int>((number - own) / count);
      const bool is_end = key == 0 && periods == 1;  // known also where times are not exact
      Time<S>& time = keys.times.back();
      time = is_end ? period_->end : after_periods<S>(time, period_->start, period_->end, periods);
      if ((periods - (number_at(0) < 0 ? -1 : 0)) % 2 != 0) negate_last(keys);
    }
  }
  void append_key(Keys<S>& keys, std::size_t number) const {
    if (!channel_) return append(keys, keys_, number, number + 1);
    keys.channels = 1;
    keys.common_tcb = keys_.common_tcb;
    keys.times.push_back(keys_.times[number]);
    keys.positions.push_back(keys_.position(number)[*channel_]);
    if (!keys_.tcbs.empty()) keys.tcbs.push_back(keys_.tcb(number, *channel_));
    if (!keys_.eases.empty()) keys.eases.push_back(keys_.eases[number]);
    if (keys_.velocities.empty()) return;
    keys.given = {keys_.given[*channel_]};
    keys.velocities.push_back(keys_.velocities[number * keys_.channels + *channel_]);
  }

  const Keys<S>& keys_;
  std::optional<std::size_t> channel_;
  std::vector<std::size_t> numbers_;
  CurveRules<S> rules_;
  std::optional<Period<S>> period_;
  std::vector<bool> returns_negated_ = {};  ///< of each rotation of the rules
};

/// The rules for one channel that runs through its own keys, with its own velocities at the ends.
template <class S>
CurveRules<S> rules_of_channel(CurveRules<S> rules, std::size_t channel) {
  rules.metric.clear();
  rules.rotations.clear();
  std::erase_if(rules.angles, [channel](const AngleChannel& angle) { return angle.channel != channel; });
  for (AngleChannel& angle : rules.angles) angle.channel = 0;
  for (auto* end : {&rules.start, &rules.end}) {
    if (!end->velocity.empty()) end->velocity = std::vector<S>(1, end->velocity[channel]);
  }
  return rules;
}

/// All keys of a curve with its rules. A channel in which keys lack positions runs through its own keys, as if there
/// were no others; a rotation likewise. A channel with gaps is a curve of its own on both sides of each, and straight
/// within it, as a placeholder. Promises: a channel without a missing position has the cubics that it would have alone,
/// bit for bit.
template <class S>
class CurveKeys {
 public:
  /// `end`: when a closed curve is back at its first key. `part`: of a channel that lacks positions. `gaps`: of such
  /// channels of an open curve, in order. Requires: no BuildError.
  CurveKeys(Keys<S> keys, CurveRules<S> rules, const std::optional<Time<S>>& end = std::nullopt,
            PartOfSegment<S> part = spline::part<S>, const std::vector<ChannelGap>& gaps = {})
      : keys_(std::move(keys)),
        rules_(std::move(rules)),
        is_sparse_(keys_.is_sparse()),
        times_(keys_.times),
        part_(part) {
    if (end) period_ = {times_.front(), *end};
    if (end) times_.push_back(*end);
    if (times_.size() == 1) times_.push_back(times_.front());
    if (!is_sparse_) {
      channels_.emplace_back().emplace_back(keys_, std::nullopt, numbers_in({}), rules_, period_);
      return;
    }
    for (std::size_t i = 0; i < keys_.channels; ++i) add_channel(i, gaps);
    for (const KeyRotation& rotation : rules_.rotations) {
      CurveRules<S> rules_of_rotation = rules_;
      rules_of_rotation.metric.clear();
      rules_of_rotation.rotations = {rotation};
      rotations_.emplace_back(keys_, std::nullopt, numbers_in(rotation.channels[0]), rules_of_rotation, period_);
    }
  }
  CurveKeys(const CurveKeys&) = delete;
  CurveKeys& operator=(const CurveKeys&) = delete;

  /// The number of segments: at least one.
  std::size_t size() const { return times_.size() - 1; }
  /// The times of the keys, and the end of a closed curve.
  const std::vector<Time<S>>& times() const { return times_; }
  bool is_closed() const { return period_.has_value(); }

  Segments<S> segments(std::size_t first, std::size_t to) const {
    std::vector<Time<S>> times(times_.begin() + static_cast<std::ptrdiff_t>(first),
                               times_.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    if (!is_sparse_) {
      auto result = channels_[0][0].own_segments(static_cast<std::ptrdiff_t>(first), static_cast<std::ptrdiff_t>(to));
      result.times = std::move(times);
      return result;
    }
    Segments<S> result{channels_.size(), std::move(times), {}, {}};
    set_columns(result.cubics, channels_.size(), to - first, [&](std::size_t channel, std::vector<Cubic<S>>& own) {
      if (const ChannelKeys<S>* const rotation = rotation_with(channel)) {
        rotation->append_cubics(own, channel, first, to, times_, part_);
      } else {
        append_parts(own, channel, first, to);
      }
    });
    if constexpr (has_roots<S>) {
      const auto append_rotations = [&](std::size_t rotation, std::vector<RotationSegment<S>>& own) {
        rotations_[rotation].append_rotations(own, first, to, times_);
      };
      set_columns(result.rotations, rotations_.size(), to - first, append_rotations);
    }
    return result;
  }

 private:
  /// The numbers of the keys that have a position in a channel; without one, of all keys.
  std::vector<std::size_t> numbers_in(std::optional<std::size_t> channel) const {
    std::vector<std::size_t> numbers;
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      if (!channel || !keys_.is_missing(key, *channel)) numbers.push_back(key);
    }
    return numbers;
  }

  /// Adds a channel that lacks positions, one part on each side of its gaps.
  void add_channel(std::size_t channel, const std::vector<ChannelGap>& gaps) {
    std::vector<ChannelKeys<S>>& parts = channels_.emplace_back();
    const std::vector<std::size_t> numbers = numbers_in(channel);
    auto begin = numbers.begin();
    const auto add_to = [&](auto end) {
      parts.emplace_back(keys_, channel, std::vector(begin, end), rules_of_channel(rules_, channel), period_);
      begin = end;
    };
    for (const ChannelGap& gap : gaps) {
      if (gap.channel == channel && gap.last != ChannelGap::no_key)
        add_to(std::ranges::lower_bound(begin, numbers.end(), gap.last));
    }
    add_to(numbers.end());
  }

  /// The cubics of a channel between the keys `first` and `to` of the curve.
  void append_parts(std::vector<Cubic<S>>& cubics, std::size_t channel, std::size_t first, std::size_t to) const {
    const std::vector<ChannelKeys<S>>& parts = channels_[channel];
    while (first < to) {
      const auto next = std::ranges::upper_bound(parts.begin() + 1, parts.end(), first, {}, &ChannelKeys<S>::first_key);
      const ChannelKeys<S>& part = *(next - 1);
      const std::size_t end = next == parts.end() ? to : std::min(to, part.last_key());
      if (first < end) {
        part.append_cubics(cubics, channel, first, end, times_, part_);
        first = end;
      } else {
        const std::size_t from = part.last_key(), until = next->first_key();
        const S &p0 = keys_.position(from)[channel], &p1 = keys_.position(until)[channel];
        const working_t<S> chord = exact_difference(p1, p0);
        const Cubic<S> straight = cubic<S>(p0, p1, chord, chord);
        cubics.push_back(part_(straight, times_[from], times_[until], times_[first], times_[first + 1]));
        ++first;
      }
    }
  }

  /// Where positions are missing, the keys of the rotation by components that has a channel, or null.
  const ChannelKeys<S>* rotation_with(std::size_t channel) const {
    for (std::size_t i = 0; i < rotations_.size(); ++i) {
      const bool has_cubics = has_roots<S> && rules_.rotation_rules.curve == RotationCurve::components;
      if (has_cubics && rules_.rotations[i].has(channel)) return &rotations_[i];
    }
    return nullptr;
  }

  /// Interleaves the entries of each column so that those of one segment are contiguous.
  template <class T, class AppendOwn>
  static void set_columns(std::vector<T>& entries, std::size_t columns, std::size_t size, AppendOwn append_own) {
    entries.resize(size * columns);
    for (std::size_t i = 0; i < columns; ++i) {
      std::vector<T> own;
      append_own(i, own);
      for (std::size_t k = 0; k < size; ++k) entries[k * columns + i] = std::move(own[k]);
    }
  }

  Keys<S> keys_;
  CurveRules<S> rules_;
  bool is_sparse_;
  std::vector<Time<S>> times_;  ///< of the keys, then of the first one after a period
  std::optional<Period<S>> period_;
  PartOfSegment<S> part_;
  std::vector<std::vector<ChannelKeys<S>>> channels_;  ///< one for all, or if positions are missing, the parts of each
  std::vector<ChannelKeys<S>> rotations_;              ///< where positions are missing
};

#ifdef TCB_SPLINE_CURVE_DOUBLE
extern template class CurveKeys<double>;
#endif

}  // namespace tcb::spline
