// Curves given by all their keys, at any scalar: periodic extension, channels with keys of their own, segments by
// number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/tangents.hpp"

namespace tcb {

/// Key `number` of a closed curve of `count` keys, by periodic extension: any number, also below 0. `key(i)` gives
/// key i of the curve, as Keys that hold it alone.
template <class S, class KeyAt>
spline::Keys<S> extended_key(KeyAt key, std::ptrdiff_t count, const spline::Time<S>& period, std::ptrdiff_t number) {
  const std::ptrdiff_t own = (number % count + count) % count;
  spline::Keys<S> result = key(static_cast<std::size_t>(own));
  const auto periods = static_cast<int>((number - own) / count);
  if (periods != 0) result.times[0] = result.times[0] + spline::Time<S>(periods) * period;
  return result;
}

/// What makes the part of a segment between two times.
template <class S>
using PartOfSegment = spline::Cubic<S> (*)(const spline::Cubic<S>& whole, const spline::Time<S>& start,
                                           const spline::Time<S>& end, const spline::Time<S>& from,
                                           const spline::Time<S>& to);

/// Successive channels of a curve, with the keys that have positions in them, by their numbers from 0.
template <class S>
class ChannelKeys {
 public:
  /// Requires: `keys` outlives it. `period`: of a closed curve. `rules`: for these channels alone.
  ChannelKeys(const spline::Keys<S>& keys, std::size_t channel, std::size_t channels, std::vector<std::size_t> numbers,
              spline::CurveRules<S> rules, std::optional<spline::Time<S>> period)
      : keys_(keys),
        channel_(channel),
        channels_(channels),
        numbers_(std::move(numbers)),
        rules_(std::move(rules)),
        period_(std::move(period)) {}

  bool is_closed() const { return period_.has_value(); }
  std::ptrdiff_t last() const { return static_cast<std::ptrdiff_t>(numbers_.size()) - 1; }

  /// The number of the last of these keys that is not after a key of the curve; -1 if there is none.
  std::ptrdiff_t number_at(std::size_t key) const {
    return std::ranges::upper_bound(numbers_, key) - numbers_.begin() - 1;
  }

  /// A key, on a closed curve by periodic extension.
  spline::Keys<S> key(std::ptrdiff_t number) const {
    const auto own = [&](std::size_t i) { return own_key(numbers_[i]); };
    if (!period_) return own(static_cast<std::size_t>(number));
    return extended_key<S>(own, last() + 1, *period_, number);
  }

  /// The segments from key `first` to key `to`, including the ends of the curve if they lie within.
  spline::Segments<S> segments(std::ptrdiff_t first, std::ptrdiff_t to) const {
    const bool starts = !period_ && first == 0, ends = !period_ && to >= last();
    spline::Window<S> window{{}, starts, ends, true};
    for (std::ptrdiff_t i = starts ? 0 : first - 1; i <= (ends ? last() : to + 1); ++i) {
      spline::append(window.keys, key(i), 0, 1);
    }
    return spline::segments(window, rules_);
  }

  /// Appends the curves of the only rotation between the keys `first` to `to` of the curve, likewise.
  void append_rotations(std::vector<spline::RotationSegment<S>>& rotations, std::size_t first, std::size_t to,
                        const std::vector<spline::Time<S>>& times) const {
    const auto rest = [&](std::size_t number) {
      const auto q = spline::rotation_of<S>(keys_.position(number), rules_.rotations[0].channels);
      return spline::RotationSegment<S>(spline::RotationCurve::slerp, {q, q, q, q});
    };
    for (std::size_t number = first; number < to; ++number) {
      const std::ptrdiff_t at = number_at(number);
      if (!period_ && (at < 0 || at == last())) {
        rotations.push_back(rest(numbers_[at < 0 ? 0 : numbers_.size() - 1]));
        continue;
      }
      const spline::Segments<S> own = segments(at, at + 1);
      const auto duration = own.times[1] - own.times[0];
      const auto fraction = [&](const auto& start, const auto& end) {
        return spline::high_part<S>((end - start) / duration);
      };
      rotations.push_back(own.rotations[0].part(fraction(own.times[0], times[number]),
                                                fraction(times[number], times[number + 1]),
                                                fraction(times[number + 1], own.times[1])));
    }
  }

  /// Appends the cubics between the keys `first` to `to` of the curve, the parts of its own ones. Before the first of
  /// these keys and after the last, an open curve is constant. `times`: of all keys of the curve, and if it is closed
  /// of its end. Requires: a single channel.
  void append_cubics(std::vector<spline::Cubic<S>>& cubics, std::size_t first, std::size_t to,
                     const std::vector<spline::Time<S>>& times, PartOfSegment<S> part) const {
    const std::ptrdiff_t low = period_ ? number_at(first) : std::max<std::ptrdiff_t>(number_at(first), 0);
    const std::ptrdiff_t high = period_ ? number_at(to - 1) + 1 : std::min(number_at(to - 1) + 1, last());
    const spline::Segments<S> own = low < high ? segments(low, high) : spline::Segments<S>{};
    for (std::size_t number = first; number < to; ++number) {
      const std::ptrdiff_t at = number_at(number);
      if (low < high && low <= at && at < high) {
        const auto i = static_cast<std::size_t>(at - low);
        cubics.push_back(part(own[i][0], own.times[i], own.times[i + 1], times[number], times[number + 1]));
      } else {
        const S rest = keys_.position(numbers_[at < 0 ? 0 : numbers_.size() - 1])[channel_];
        cubics.push_back(spline::cubic<S>(rest, rest, spline::working_t<S>(0), spline::working_t<S>(0)));
      }
    }
  }

 private:
  spline::Keys<S> own_key(std::size_t number) const {
    const auto position = keys_.position(number).subspan(channel_, channels_);
    spline::Keys<S> key{channels_, {keys_.times[number]}, {position.begin(), position.end()}, {}, keys_.common_tcb, {}};
    for (std::size_t i = 0; i < (keys_.has_channel_tcbs() ? channels_ : keys_.tcbs_per_key()); ++i) {
      key.tcbs.push_back(keys_.tcb(number, channel_ + i));
    }
    if (!keys_.eases.empty()) key.eases.push_back(keys_.eases[number]);
    const std::size_t turns = keys_.turns_per_key();
    for (std::size_t i = number * turns; i < (number + 1) * turns; ++i) key.turns.push_back(keys_.turns[i]);
    for (std::size_t i = channel_; !keys_.velocities.empty() && i < channel_ + channels_; ++i) {
      key.given.push_back(keys_.given[i]);
      key.velocities.push_back(keys_.velocities[number * keys_.channels + i]);
    }
    return key;
  }

  const spline::Keys<S>& keys_;
  std::size_t channel_, channels_;
  std::vector<std::size_t> numbers_;
  spline::CurveRules<S> rules_;
  std::optional<spline::Time<S>> period_;
};

/// The rules for one channel that runs through its own keys: with its own speed and its own velocities at the ends.
template <class S>
spline::CurveRules<S> rules_of_channel(spline::CurveRules<S> rules, std::size_t channel) {
  rules.metric.clear();
  rules.rotations.clear();
  for (auto* end : {&rules.start, &rules.end}) {
    if (!end->velocity.empty()) end->velocity = std::vector<S>(1, end->velocity[channel]);
  }
  return rules;
}

/// A curve by its keys. A channel in which keys lack positions runs through its own keys, as if there were no
/// others. Promises: a channel without a missing position has the cubics that it would have alone,
/// bit for bit.
template <class S>
class KeyedCurve {
 public:
  /// `missing`: whether each position is missing; empty: none. `end`: when a closed curve returns to its first key.
  /// Requires: a key, and a position in every channel.
  KeyedCurve(spline::Keys<S> keys, const std::vector<bool>& missing, const spline::CurveRules<S>& rules,
             const std::optional<spline::Time<S>>& end, PartOfSegment<S> part = spline::part<S>)
      : keys_(std::move(keys)), times_(keys_.times), part_(part) {
    std::optional<spline::Time<S>> period;
    if (end) period = *end - times_.front();
    if (end) times_.push_back(*end);
    if (times_.size() == 1) times_.push_back(times_.front());
    for (std::size_t i = 0; i < (missing.empty() ? 1 : keys_.channels); ++i) {
      std::vector<std::size_t> numbers;
      for (std::size_t key = 0; key < keys_.size(); ++key) {
        if (missing.empty() || !missing[key * keys_.channels + i]) numbers.push_back(key);
      }
      const bool alone = !missing.empty();
      channels_.emplace_back(keys_, i, alone ? 1 : keys_.channels, std::move(numbers),
                             alone ? rules_of_channel(rules, i) : rules, period);
    }
    if constexpr (spline::has_roots<S>) {
      if (!missing.empty()) add_rotations(missing, rules, period);
    }
  }
  KeyedCurve(const KeyedCurve&) = delete;
  KeyedCurve& operator=(const KeyedCurve&) = delete;

  /// The number of segments: at least one.
  std::size_t size() const { return times_.size() - 1; }
  const std::vector<spline::Time<S>>& times() const { return times_; }
  bool is_closed() const { return channels_.front().is_closed(); }

  /// Segments [first, to).
  spline::Segments<S> segments(std::size_t first, std::size_t to) const {
    if (channels_.size() == 1 && channels_.front().last() + 1 == static_cast<std::ptrdiff_t>(keys_.size())) {
      auto result = channels_.front().segments(static_cast<std::ptrdiff_t>(first), static_cast<std::ptrdiff_t>(to));
      result.times = times_between(first, to);
      return result;
    }
    const std::size_t size = to - first, channels = channels_.size();
    spline::Segments<S> result{channels, times_between(first, to), {}, {}};
    result.cubics.resize(size * channels);
    for (std::size_t i = 0; i < channels; ++i) {
      std::vector<spline::Cubic<S>> own;
      channels_[i].append_cubics(own, first, to, times_, part_);
      for (std::size_t k = 0; k < size; ++k) result.cubics[k * channels + i] = std::move(own[k]);
    }
    if constexpr (spline::has_roots<S>) {
      result.rotation_columns = rotation_columns_;
      result.rotations.resize(size * rotations_.size());
      for (std::size_t i = 0; i < rotations_.size(); ++i) {
        std::vector<spline::RotationSegment<S>> own;
        rotations_[i].append_rotations(own, first, to, times_);
        for (std::size_t k = 0; k < size; ++k) result.rotations[k * rotations_.size() + i] = own[k];
      }
    }
    return result;
  }

 private:
  /// Rotations whose numbers are missing in some keys run through the others, like channels.
  void add_rotations(const std::vector<bool>& missing, spline::CurveRules<S> rules,
                     const std::optional<spline::Time<S>>& period) {
    rotation_columns_ = std::exchange(rules.rotations, {});
    rules.metric.clear();
    for (const spline::RotationColumns& rotation : rotation_columns_) {
      rules.rotations = {rotation};
      std::vector<std::size_t> numbers;
      for (std::size_t key = 0; key < keys_.size(); ++key) {
        if (!missing[key * keys_.channels + rotation.channels[0]]) numbers.push_back(key);
      }
      rotations_.emplace_back(keys_, 0, keys_.channels, std::move(numbers), rules, period);
    }
  }

  std::vector<spline::Time<S>> times_between(std::size_t first, std::size_t to) const {
    return {times_.begin() + static_cast<std::ptrdiff_t>(first), times_.begin() + static_cast<std::ptrdiff_t>(to) + 1};
  }

  spline::Keys<S> keys_;
  std::vector<spline::Time<S>> times_;  ///< of the keys, then of the first one after a period
  PartOfSegment<S> part_;               ///< of a channel that has fewer keys
  std::vector<ChannelKeys<S>> channels_;
  std::vector<spline::RotationColumns> rotation_columns_;  ///< where positions are missing
  std::vector<ChannelKeys<S>> rotations_;                  ///< those of each
};

}  // namespace tcb
