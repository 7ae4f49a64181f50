// Keys: times, positions, tension, continuity, bias and ease of successive keys.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "tcb/spline/double_double.hpp"
#include "tcb/spline/key.hpp"

namespace tcb::spline {

/// Successive keys, each with the same number of channels. A rotation is always four channels x, y, z, w; for other
/// notations see rotation_notation.hpp.
template <class S>
struct Keys {
  std::size_t channels = 0;
  std::vector<Time<S>> times;
  /// `channels` numbers per key, key after key. A position may be missing: it is NaN, or where the scalar has no NaN,
  /// `missing` says so. A channel then runs through the keys that have a position in it, as if there were no others.
  std::vector<S> positions;
  /// One entry per key; or `channels` entries per key, of which a rotation takes those of its first channel; or none:
  /// then every key has `common_tcb`.
  std::vector<Tcb<S>> tcbs;
  Tcb<S> common_tcb;
  /// One entry per key, or none. With missing positions they are an error.
  std::vector<Ease<S>> eases;
  /// `channels` entries per key, or none. In a channel that is `given`, the velocities are those of the curve, and no
  /// tangent rule and no end rule applies. They may be NaN before the channel's first key and after its last.
  std::vector<Velocity<S>> velocities = {};
  /// One entry per channel if there are velocities, else none. Where `given` is false, the channel's velocities are
  /// ignored.
  std::vector<bool> given = {};
  /// As many entries per key as rotations have turns: the turn to it from the key before, where that is half a turn or
  /// makes whole turns; zeros: the shorter way.
  std::vector<TurnVector<S>> turns = {};
  /// One entry per position, or none.
  std::vector<bool> missing = {};

  std::size_t size() const { return times.size(); }
  std::span<const S> position(std::size_t key) const { return std::span(positions).subspan(key * channels, channels); }
  /// The number of entries of tcbs per key: 0, 1 or `channels`.
  std::size_t tcbs_per_key() const {
    if (tcbs.empty()) return 0;
    return channels == 0 ? 1 : tcbs.size() * channels / positions.size();
  }
  std::size_t turns_per_key() const { return turns.empty() ? 0 : turns.size() * channels / positions.size(); }
  /// Whether each channel has its own tension, continuity and bias.
  bool has_channel_tcbs() const { return tcbs_per_key() > 1; }
  bool is_missing(std::size_t key, std::size_t channel) const {
    const std::size_t i = key * channels + channel;
    return missing.empty() ? positions[i] != positions[i] : missing[i];
  }
  bool is_sparse() const {
    return missing.empty() ? std::ranges::any_of(positions, [](const S& position) { return position != position; })
                           : std::ranges::count(missing, true) > 0;
  }
  /// Tension, continuity and bias of a key in a channel; those of a rotation are those of its first channel.
  const Tcb<S>& tcb(std::size_t key, std::size_t channel = 0) const {
    if (tcbs.empty()) return common_tcb;
    return has_channel_tcbs() ? tcbs[key * channels + channel] : tcbs[key];
  }
};

/// Calls f with each column of keys in turn, in one or in several containers: the times, positions, and so on. A column
/// has as many entries for each key. Whatever copies, cuts or converts keys does it here, so that no column is
/// forgotten; the containers need the members of Keys.
template <class F, class... SomeKeys>
void for_each_column(F f, SomeKeys&&... keys) {
  f(keys.times...);
  f(keys.positions...);
  f(keys.tcbs...);
  f(keys.eases...);
  f(keys.velocities...);
  f(keys.turns...);
  f(keys.missing...);
}

/// Takes over what all keys have in common.
template <class To, class From>
void take_common(To& to, const From& from) {
  to.channels = from.channels;
  to.common_tcb = from.common_tcb;
  to.given = from.given;
}

/// Appends the entries of keys [first, last) of a column that has entries for `size` keys, or none.
template <class To, class From>
void append_entries(To& to, const From& from, std::size_t size, std::size_t first, std::size_t last) {
  if (from.empty()) return;
  const std::size_t per_key = from.size() / size;
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first * per_key),
            from.begin() + static_cast<std::ptrdiff_t>(last * per_key));
}

/// Appends keys [first, last) of `from`. Requires: both have as many tcbs per key; likewise for eases.
template <class S>
void append(Keys<S>& to, const Keys<S>& from, std::size_t first, std::size_t last) {
  if (first == last) return;
  take_common(to, from);
  for_each_column([&](auto& target, const auto& source) { append_entries(target, source, from.size(), first, last); },
                  to, from);
}

}  // namespace tcb::spline
