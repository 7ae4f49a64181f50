// Build errors: the checks of keys and rules before a curve is built from them, and their messages.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tcb/spline/curve_rules.hpp"
#include "tcb/spline/keys.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb::spline {

/// Reasons why no curve can be built; build_error_texts has a row for each, in this order.
enum class BuildErrorCode : std::uint8_t {
  no_keys,
  no_channels,
  positions_count,
  tcbs_count,
  eases_count,
  velocities_count,
  given_count,
  turns_count,
  missing_count,
  time_not_finite,
  times_not_increasing,
  duration_overflow,
  position_not_finite,
  channel_without_positions,
  ease_with_missing_positions,
  timing_with_missing_positions,
  timing_with_ease,
  timing_with_velocities,
  tcb_not_finite,
  common_tcb_not_finite,
  ease_out_of_range,
  key_velocity_not_finite,
  unknown_rule,
  metric_channel_missing,
  velocity_count,
  velocity_not_finite,
  scalar_without_roots,
  equal_speed_with_velocities,
  equal_speed_with_missing_positions,
  rotation_channel_missing,
  rotation_channel_shared,
  rotation_turn_missing,
  rotation_incomplete,
  rotation_zero,
  rotation_velocity_incomplete,
  end_velocity_of_rotation,
  metric_of_angles,
  closed_too_few_keys,
  period_missing,
  period_not_finite,
  period_too_short,
  period_contradicted,
  seam_tcb_differs,
  seam_velocity_differs,
  seam_velocity_missing,
  curve_overflow,
  length_overflow
};

/// The messages. {key} and {channel} are numbers from 0; {expected} and {found} are counts.
struct BuildErrorText {
  BuildErrorCode id;
  std::string_view text;
};
inline constexpr auto build_error_texts = std::to_array<BuildErrorText>({
    {BuildErrorCode::no_keys, "there are no keys; expected at least one"},
    {BuildErrorCode::no_channels, "the keys have no channels; expected at least one"},
    {BuildErrorCode::positions_count, "the size of positions is {found}; expected {expected}, one per key and channel"},
    {BuildErrorCode::tcbs_count,
     "the size of tcbs is {found}; expected {expected}, one per key, or as many per key as channels, or none"},
    {BuildErrorCode::eases_count, "the size of eases is {found}; expected {expected}, one per key, or none"},
    {BuildErrorCode::velocities_count,
     "the size of velocities is {found}; expected {expected}, one per key and channel, or none"},
    {BuildErrorCode::given_count,
     "the size of given is {found}; expected {expected}, one per channel where there are velocities, or none"},
    {BuildErrorCode::turns_count,
     "the size of turns is {found}; expected a multiple of {expected}, the number of keys"},
    {BuildErrorCode::missing_count,
     "the size of missing is {found}; expected {expected}, one per key and channel, or none"},
    {BuildErrorCode::time_not_finite, "the time of key {key} is not finite; expected a finite number"},
    {BuildErrorCode::times_not_increasing,
     "the time of key {key} is not after that of the key before it; expected increasing times"},
    {BuildErrorCode::duration_overflow,
     "the duration up to key {key} exceeds the range of the scalar; expected closer times"},
    {BuildErrorCode::position_not_finite,
     "the position of key {key} in channel {channel} is infinite; expected a finite number, or NaN if it is missing"},
    {BuildErrorCode::channel_without_positions,
     "every position in channel {channel} is missing; expected a key that has one"},
    {BuildErrorCode::ease_with_missing_positions,
     "some positions are missing, and the keys have eases; expected eases only where no position is missing"},
    {BuildErrorCode::timing_with_missing_positions,
     "some positions are missing, and the timing is monotone; expected such timing only where no position is missing"},
    {BuildErrorCode::timing_with_ease, "the keys have eases, and the timing is monotone; expected one of them"},
    {BuildErrorCode::timing_with_velocities,
     "velocities are given, and the timing is monotone; expected such timing only with tangents by a rule"},
    {BuildErrorCode::tcb_not_finite, "tension, continuity or bias of key {key} is not finite; expected finite numbers"},
    {BuildErrorCode::common_tcb_not_finite,
     "the common tension, continuity or bias is not finite; expected finite numbers"},
    {BuildErrorCode::ease_out_of_range, "an ease of key {key} is outside [0, 1]; expected a number from 0 to 1"},
    {BuildErrorCode::key_velocity_not_finite,
     "a velocity of key {key} in channel {channel} is not finite; expected finite numbers, except before the first key "
     "and after the last"},
    {BuildErrorCode::unknown_rule, "a tangent rule or end rule has no row in its table; expected an enumerator"},
    {BuildErrorCode::metric_channel_missing,
     "the metric has channel {channel}; expected a number below {expected}, the number of channels"},
    {BuildErrorCode::velocity_count,
     "the number of velocities of the end rule at key {key} is {found}; expected {expected}"},
    {BuildErrorCode::velocity_not_finite,
     "the end velocity at key {key} in channel {channel} is not finite; expected a finite number"},
    {BuildErrorCode::scalar_without_roots,
     "equal speed, rotations and angles in radians need square roots, which the scalar does not have; expected none of "
     "them"},
    {BuildErrorCode::equal_speed_with_velocities,
     "equal speed changes the velocities, which are given; expected no equal speed"},
    {BuildErrorCode::equal_speed_with_missing_positions,
     "some positions are missing, and equal speed needs all of them; expected equal speed only where no position is "
     "missing"},
    {BuildErrorCode::rotation_channel_missing,
     "a rotation or an angle has channel {channel}; expected a number below {expected}, the number of channels"},
    {BuildErrorCode::rotation_channel_shared,
     "channel {channel} occurs twice in rotations and angles; expected it once at most"},
    {BuildErrorCode::rotation_turn_missing,
     "a rotation has turn {found} of each key; expected a number below {expected}, the number of turns per key"},
    {BuildErrorCode::rotation_incomplete,
     "key {key} has some numbers of a rotation, but none in channel {channel}; expected all four or none"},
    {BuildErrorCode::rotation_zero,
     "the rotation of key {key} that begins with channel {channel} is zero; expected a quaternion that is not"},
    {BuildErrorCode::rotation_velocity_incomplete,
     "the velocity of a rotation in channel {channel} does not fit; expected one in all four channels or in none, and "
     "in none for the curve slerp, which has no tangents"},
    {BuildErrorCode::end_velocity_of_rotation,
     "the end rule at key {key} needs a velocity, which a rotation does not have; expected another end rule"},
    {BuildErrorCode::metric_of_angles,
     "the metric has channel {channel}, which is an angle or a number of a rotation; expected other channels"},
    {BuildErrorCode::closed_too_few_keys,
     "the number of keys of a closed curve, without a repeated first key, is {found}; expected at least two"},
    {BuildErrorCode::period_missing,
     "the period is missing; expected one, or a last key at the position of the first key"},
    {BuildErrorCode::period_not_finite, "the period or its end is not finite; expected a finite number"},
    {BuildErrorCode::period_too_short, "the period ends at key {key} or before it; expected a longer period"},
    {BuildErrorCode::period_contradicted,
     "key {key} repeats the first position before or after the end of the period; expected it at the end"},
    {BuildErrorCode::seam_tcb_differs,
     "key {key} repeats the first position with other tension, continuity or bias; expected the same"},
    {BuildErrorCode::seam_velocity_differs,
     "key {key} repeats the first position with another velocity in channel {channel}; expected the same"},
    {BuildErrorCode::seam_velocity_missing,
     "the velocity of key {key} in channel {channel} is not finite where the curve closes; expected a finite number"},
    {BuildErrorCode::curve_overflow,
     "the segment from key {key} on exceeds the range of the scalar in channel {channel}; expected smaller numbers"},
    {BuildErrorCode::length_overflow,
     "the length of the segment from key {key} on exceeds the range of the scalar; expected smaller positions"},
});
static_assert(is_in_order(build_error_texts));

/// Why no curve can be built: a code, and the values for its message.
struct BuildError {
  BuildErrorCode code = BuildErrorCode::no_keys;
  std::size_t key = 0;      ///< from 0
  std::size_t channel = 0;  ///< from 0
  std::size_t expected = 0, found = 0;

  /// The error in words: what is wrong, and what was expected.
  std::string message() const {
    std::string text(build_error_texts[static_cast<std::size_t>(code)].text);
    const auto insert = [&](std::string_view name, std::size_t value) {
      const std::size_t at = text.find(name);
      if (at == std::string::npos) return false;
      text.replace(at, name.size(), std::to_string(value));
      return true;
    };
    const bool has_key = insert("{key}", key), has_channel = insert("{channel}", channel);
    insert("{expected}", expected);
    insert("{found}", found);
    if (has_key && has_channel) return text + " (keys and channels count from 0)";
    return text + (has_key ? " (keys count from 0)" : has_channel ? " (channels count from 0)" : "");
  }
};

/// A value, or the error that prevents it.
template <class T>
class BuildResult {
 public:
  BuildResult(T value) : result_(std::move(value)) {}  // NOLINT(google-explicit-constructor): either converts
  BuildResult(BuildError error) : result_(error) {}    // NOLINT(google-explicit-constructor): either converts

  /// Whether there is a value.
  bool has_value() const { return std::holds_alternative<T>(result_); }
  explicit operator bool() const { return has_value(); }

  /// The value. Throws: std::bad_variant_access if there is none.
  const T& operator*() const& { return std::get<T>(result_); }
  T&& operator*() && { return std::get<T>(std::move(result_)); }
  const T* operator->() const { return &**this; }

  /// The error. Throws: std::bad_variant_access if there is none.
  const BuildError& error() const { return std::get<BuildError>(result_); }

 private:
  std::variant<T, BuildError> result_;
};

/// Whether the number is neither infinite nor NaN.
template <class T>
constexpr bool is_finite(const T& value) {
  return value - value == T(0);
}
template <class S>
bool is_finite(const Tcb<S>& tcb) {
  return is_finite(tcb.tension) && is_finite(tcb.continuity) && is_finite(tcb.bias);
}

/// An error in the times and the durations between them, if any.
template <class S>
std::optional<BuildError> find_time_error(const std::vector<Time<S>>& times) {
  for (std::size_t key = 0; key < times.size(); ++key) {
    if (!is_finite(times[key])) return BuildError{.code = BuildErrorCode::time_not_finite, .key = key};
    if (key == 0) continue;
    if (!(times[key] > times[key - 1])) return BuildError{.code = BuildErrorCode::times_not_increasing, .key = key};
    if (!is_finite(times[key] - times[0])) return BuildError{.code = BuildErrorCode::duration_overflow, .key = key};
  }
  return std::nullopt;
}

/// An error in the given velocities between the keys that have positions in a channel, if any. Those before the first
/// of them and after the last have no effect on an open curve; for a closed one see closing.hpp.
template <class S>
std::optional<BuildError> find_velocity_error(const Keys<S>& keys) {
  for (std::size_t i = 0; i < keys.given.size(); ++i) {
    if (!keys.given[i]) continue;
    const auto error_at = [i](std::size_t key) {
      return BuildError{.code = BuildErrorCode::key_velocity_not_finite, .key = key, .channel = i};
    };
    std::optional<std::size_t> before;
    for (std::size_t key = 0; key < keys.size(); ++key) {
      if (keys.is_missing(key, i)) continue;
      if (before && !is_finite(keys.velocities[*before * keys.channels + i].out)) return error_at(*before);
      if (before && !is_finite(keys.velocities[key * keys.channels + i].in)) return error_at(key);
      before = key;
    }
  }
  return std::nullopt;
}

/// An error in the positions, if any.
template <class S>
std::optional<BuildError> find_position_error(const Keys<S>& keys) {
  using enum BuildErrorCode;
  for (std::size_t channel = 0; channel < keys.channels; ++channel) {
    bool has_position = false;
    for (std::size_t key = 0; key < keys.size(); ++key) {
      if (keys.is_missing(key, channel)) continue;
      has_position = true;
      if (is_finite(keys.position(key)[channel])) continue;
      return BuildError{.code = position_not_finite, .key = key, .channel = channel};
    }
    if (!has_position) return BuildError{.code = channel_without_positions, .channel = channel};
  }
  if (!keys.eases.empty() && keys.is_sparse()) return BuildError{.code = ease_with_missing_positions};
  return std::nullopt;
}

/// An error in the keys, if any.
template <class S>
std::optional<BuildError> find_key_error(const Keys<S>& keys) {
  using enum BuildErrorCode;
  const std::size_t size = keys.size(), channels = keys.channels;
  if (size == 0) return BuildError{.code = no_keys};
  if (channels == 0) return BuildError{.code = no_channels};
  if (keys.positions.size() % channels != 0 || keys.positions.size() / channels != size) {
    return BuildError{.code = positions_count, .expected = size * channels, .found = keys.positions.size()};
  }
  if (!keys.tcbs.empty() && keys.tcbs.size() != size && keys.tcbs.size() != keys.positions.size()) {
    return BuildError{.code = tcbs_count, .expected = size, .found = keys.tcbs.size()};
  }
  if (!keys.eases.empty() && keys.eases.size() != size) {
    return BuildError{.code = eases_count, .expected = size, .found = keys.eases.size()};
  }
  if (!keys.velocities.empty() && keys.velocities.size() != keys.positions.size()) {
    return BuildError{.code = velocities_count, .expected = keys.positions.size(), .found = keys.velocities.size()};
  }
  if (const std::size_t expected = keys.velocities.empty() ? 0 : channels; keys.given.size() != expected) {
    return BuildError{.code = given_count, .expected = expected, .found = keys.given.size()};
  }
  if (keys.turns.size() % size != 0) {
    return BuildError{.code = turns_count, .expected = size, .found = keys.turns.size()};
  }
  if (!keys.missing.empty() && keys.missing.size() != keys.positions.size()) {
    return BuildError{.code = missing_count, .expected = keys.positions.size(), .found = keys.missing.size()};
  }
  if (auto error = find_time_error<S>(keys.times)) return error;
  if (auto error = find_position_error(keys)) return error;
  for (std::size_t i = 0; i < keys.tcbs.size(); ++i) {
    const std::size_t per_key = keys.tcbs_per_key();
    if (!is_finite(keys.tcbs[i])) return BuildError{.code = tcb_not_finite, .key = i / per_key, .channel = i % per_key};
  }
  if (!is_finite(keys.common_tcb)) return BuildError{.code = common_tcb_not_finite};
  if (auto error = find_velocity_error(keys)) return error;
  const auto in_range = [](const S& ease) { return ease >= S(0) && ease <= S(1); };
  for (std::size_t key = 0; key < keys.eases.size(); ++key) {
    const bool good = in_range(keys.eases[key].in) && in_range(keys.eases[key].out);
    if (!good) return BuildError{.code = ease_out_of_range, .key = key};
  }
  return std::nullopt;
}

/// An error in the end rule at a key, if any.
template <class S>
std::optional<BuildError> find_end_error(const EndChoice<S>& choice, std::size_t channels, std::size_t key) {
  using enum BuildErrorCode;
  if (static_cast<std::size_t>(choice.rule) >= end_rules<S>.size()) return BuildError{.code = unknown_rule};
  const std::size_t expected = row_of<S>(choice.rule).takes_velocity ? channels : 0, found = choice.velocity.size();
  if (found != expected) return BuildError{.code = velocity_count, .key = key, .expected = expected, .found = found};
  for (std::size_t i = 0; i < found; ++i) {
    if (!is_finite(choice.velocity[i])) return BuildError{.code = velocity_not_finite, .key = key, .channel = i};
  }
  return std::nullopt;
}

/// An error in a rotation of these keys, if any.
template <class S>
std::optional<BuildError> find_rotation_error(const KeyRotation& rotation, const CurveRules<S>& rules,
                                              const Keys<S>& keys) {
  using enum BuildErrorCode;
  if (rotation.turn && *rotation.turn >= keys.turns_per_key()) {
    return BuildError{.code = rotation_turn_missing, .expected = keys.turns_per_key(), .found = *rotation.turn};
  }
  const std::size_t first = rotation.channels[0];
  const bool has_velocity = !keys.given.empty() && keys.given[first];
  for (const std::size_t channel : rotation.channels) {
    const bool is_given = !keys.given.empty() && keys.given[channel];
    const bool is_bad = is_given != has_velocity || (is_given && rules.rotation_rules.curve == RotationCurve::slerp);
    if (is_bad) return BuildError{.code = rotation_velocity_incomplete, .channel = channel};
  }
  for (std::size_t key = 0; key < keys.size(); ++key) {
    const bool is_missing = keys.is_missing(key, first);
    bool is_zero = true;
    for (const std::size_t channel : rotation.channels) {
      is_zero = is_zero && keys.position(key)[channel] == S(0);
      if (keys.is_missing(key, channel) == is_missing) continue;
      return BuildError{.code = rotation_incomplete, .key = key, .channel = is_missing ? first : channel};
    }
    if (is_zero && !is_missing) return BuildError{.code = rotation_zero, .key = key, .channel = first};
  }
  return std::nullopt;
}

/// An error in which channels are rotations and angles, and in the numbers of these, if any.
template <class S>
std::optional<BuildError> find_rotation_error(const CurveRules<S>& rules, const Keys<S>& keys) {
  using enum BuildErrorCode;
  std::vector<bool> taken(keys.channels);
  const auto find_channel_error = [&](std::size_t channel) -> std::optional<BuildError> {
    if (channel >= keys.channels) {
      return BuildError{.code = rotation_channel_missing, .channel = channel, .expected = keys.channels};
    }
    if (taken[channel]) return BuildError{.code = rotation_channel_shared, .channel = channel};
    taken[channel] = true;
    return std::nullopt;
  };
  for (const AngleChannel& angle : rules.angles) {
    if (auto error = find_channel_error(angle.channel)) return error;
  }
  for (const KeyRotation& rotation : rules.rotations) {
    for (const std::size_t channel : rotation.channels) {
      if (auto error = find_channel_error(channel)) return error;
    }
    if (auto error = find_rotation_error(rotation, rules, keys)) return error;
  }
  return std::nullopt;
}

/// An error in the metric for these keys, if any.
template <class S>
std::optional<BuildError> find_metric_error(const CurveRules<S>& rules, const Keys<S>& keys) {
  using enum BuildErrorCode;
  const std::vector<bool> are_plain = plain_channels(rules.rotations, rules.angles, keys.channels);
  for (const std::size_t channel : rules.metric) {
    if (channel >= keys.channels) {
      return BuildError{.code = metric_channel_missing, .channel = channel, .expected = keys.channels};
    }
    if (!are_plain[channel]) return BuildError{.code = metric_of_angles, .channel = channel};
  }
  return std::nullopt;
}

/// An error in the timing for these keys, if any.
template <class S>
std::optional<BuildError> find_timing_error(const CurveRules<S>& rules, const Keys<S>& keys, bool closed) {
  using enum BuildErrorCode;
  if (rules.timing == Timing::even) return std::nullopt;
  if (!keys.eases.empty()) return BuildError{.code = timing_with_ease};
  if (keys.is_sparse()) return BuildError{.code = timing_with_missing_positions};
  const bool has_velocity = !closed && !(rules.start.velocity.empty() && rules.end.velocity.empty());
  if (has_velocity || std::ranges::count(keys.given, true) > 0) return BuildError{.code = timing_with_velocities};
  return std::nullopt;
}

/// An error in the rules for these keys, if any. A closed curve has no ends.
template <class S>
std::optional<BuildError> find_rule_error(const CurveRules<S>& rules, const Keys<S>& keys, bool closed) {
  using enum BuildErrorCode;
  const RotationRules& own = rules.rotation_rules;
  const bool is_known = static_cast<std::size_t>(rules.tangents) < tangent_rules<S>.size() &&
                        static_cast<std::size_t>(own.tangents.value_or(rules.tangents)) < tangent_rules<S>.size() &&
                        static_cast<std::size_t>(own.ends.value_or(EndRule{})) < end_rules<S>.size() &&
                        static_cast<std::size_t>(own.curve) < rotation_curves.size();
  if (!is_known) return BuildError{.code = unknown_rule};
  const bool needs_roots =
      rules.equal_speed || !rules.rotations.empty() || !std::ranges::all_of(rules.angles, &AngleChannel::degrees);
  if (needs_roots && !has_roots<S>) return BuildError{.code = scalar_without_roots};
  if (rules.equal_speed && std::ranges::count(keys.given, true) > 0) {
    return BuildError{.code = equal_speed_with_velocities};
  }
  if (auto error = find_timing_error(rules, keys, closed)) return error;
  if (rules.equal_speed && keys.is_sparse()) return BuildError{.code = equal_speed_with_missing_positions};
  if (auto error = find_rotation_error(rules, keys)) return error;
  if (auto error = find_metric_error(rules, keys)) return error;
  if (closed) return std::nullopt;
  const std::size_t last = keys.size() - 1;
  if (auto error = find_end_error(rules.start, keys.channels, 0)) return error;
  if (auto error = find_end_error(rules.end, keys.channels, last)) return error;
  if (rules.rotations.empty()) return std::nullopt;
  const auto takes_velocity = [&](const EndChoice<S>& end) {
    return row_of<S>(own.ends.value_or(end.rule)).takes_velocity;
  };
  if (takes_velocity(rules.start)) return BuildError{.code = end_velocity_of_rotation, .key = 0};
  if (takes_velocity(rules.end)) return BuildError{.code = end_velocity_of_rotation, .key = last};
  return std::nullopt;
}

}  // namespace tcb::spline
