// Closing: when a closed curve is back at its first key, and what the key that repeats the first one gives it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "tcb/spline/build_error.hpp"

namespace tcb::spline {

/// How a closed curve closes.
template <class S>
struct Closing {
  Time<S> end;           ///< when it is back at its first key
  bool repeats = false;  ///< the last key repeats the first one: it gives the end, and is no key of its own
};

/// A key with the sign of each rotation, and of its velocities, that is nearer to that of another key.
template <class S>
Keys<S> with_signs_of(const Keys<S>& other, Keys<S> key, const std::vector<KeyRotation>& rotations) {
  for (const KeyRotation& rotation : rotations) {
    S dot(0);
    for (const std::size_t i : rotation.channels) dot += other.positions[i] * key.positions[i];
    if (!(dot < S(0))) continue;
    for (const std::size_t i : rotation.channels) {
      key.positions[i] = S(0) - key.positions[i];  // 0 stays without a sign
      if (!key.velocities.empty()) key.velocities[i] = {-key.velocities[i].in, -key.velocities[i].out};
    }
  }
  return key;
}

/// Whether the last key has the position of the first one, in every channel. Each is given alone.
template <class S>
bool is_repeated(const Keys<S>& first, const Keys<S>& last) {
  const bool is_complete = !first.is_sparse() && !last.is_sparse();
  return is_complete && std::ranges::equal(first.position(0), last.position(0));
}

/// An error where a last key repeats the first one's position, but not its other numbers. A velocity that is not
/// finite is not given.
template <class S>
std::optional<BuildError> find_repetition_error(const Keys<S>& first, const Keys<S>& last, std::size_t number) {
  for (std::size_t i = 0; i < first.channels; ++i) {
    if (last.tcb(0, i) != first.tcb(0, i)) {
      return BuildError{.code = BuildErrorCode::seam_tcb_differs, .key = number, .channel = i};
    }
  }
  const auto differ = [](const S& a, const S& b) { return is_finite(a) && is_finite(b) && a != b; };
  for (std::size_t i = 0; i < last.velocities.size(); ++i) {
    const Velocity<S>&a = first.velocities[i], &b = last.velocities[i];
    if (!differ(a.in, b.in) && !differ(a.out, b.out)) continue;
    return BuildError{.code = BuildErrorCode::seam_velocity_differs, .key = number, .channel = i};
  }
  return std::nullopt;
}

/// How a curve of `count` keys closes. `first` and `last` hold the first and the last key alone, the latter with the
/// signs of the first one. `end`: the end of the period, if it is known.
template <class S>
BuildResult<Closing<S>> find_closing(const Keys<S>& first, const Keys<S>& last, std::size_t count,
                                     const std::optional<Time<S>>& end) {
  using enum BuildErrorCode;
  const std::size_t number = count - 1;  // of the last key
  if (end && !is_finite(Time<S>(*end - first.times[0]))) return BuildError{.code = period_not_finite};
  if (end && !(*end > first.times[0])) return BuildError{.code = period_too_short, .key = 0};
  const bool repeats = count > 1 && is_repeated(first, last);
  if (repeats) {
    if (const auto error = find_repetition_error(first, last, number)) return *error;
    if (end.value_or(last.times[0]) != last.times[0]) return BuildError{.code = period_contradicted, .key = number};
  } else if (end && !(*end > last.times[0])) {
    return BuildError{.code = period_too_short, .key = number};
  }
  const std::size_t own = repeats ? number : count;
  if (own < 2) return BuildError{.code = closed_too_few_keys, .found = own};
  if (!repeats && !end) return BuildError{.code = period_missing};
  return Closing<S>{repeats ? last.times[0] : *end, repeats};
}

/// Copies to the first key what the repeated last key adds: its incoming velocities and turns.
template <class SomeKeys, class S>
void join_seam(SomeKeys& keys, const Keys<S>& repeated) {
  for (std::size_t i = 0; i < repeated.velocities.size(); ++i) keys.velocities[i].in = repeated.velocities[i].in;
  std::ranges::copy(repeated.turns, keys.turns.begin());
}

/// An error in the given velocities at the seam of a closed curve, if any: each channel needs the one with which the
/// curve arrives at the first key that has a position in it, and the one with which it leaves the last. `key_at(i)`
/// gives key i alone.
template <class S, class KeyAt>
std::optional<BuildError> find_seam_error(KeyAt key_at, std::size_t count) {
  const std::vector<bool> given = Keys<S>(key_at(0)).given;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) continue;
    std::size_t first = 0, last = count - 1;
    while (first < last && Keys<S>(key_at(first)).is_missing(0, i)) ++first;
    while (last > first && Keys<S>(key_at(last)).is_missing(0, i)) --last;
    const S in = Keys<S>(key_at(first)).velocities[i].in, out = Keys<S>(key_at(last)).velocities[i].out;
    if (is_finite(in) && is_finite(out)) continue;
    return BuildError{.code = BuildErrorCode::seam_velocity_missing, .key = is_finite(in) ? last : first, .channel = i};
  }
  return std::nullopt;
}

}  // namespace tcb::spline
