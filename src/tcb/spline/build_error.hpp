// Build errors: the checks of keys and rules before a curve is built from them, and their messages.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tcb/spline/window.hpp"

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
  time_not_finite,
  times_not_increasing,
  duration_overflow,
  position_not_finite,
  tcb_not_finite,
  common_tcb_not_finite,
  ease_out_of_range,
  key_velocity_not_finite,
  unknown_rule,
  metric_channel_missing,
  velocity_count,
  velocity_not_finite,
  equal_speed_without_roots,
  curve_of_rotations,
  equal_speed_with_velocities,
  closed_too_few_keys,
  period_missing,
  period_not_finite,
  period_too_short,
  period_contradicted,
  seam_tcb_differs,
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
    {BuildErrorCode::positions_count, "positions has {found} numbers; expected {expected}, one per key and channel"},
    {BuildErrorCode::tcbs_count,
     "tcbs has {found} entries; expected {expected}, one per key, or as many per key as channels, or none"},
    {BuildErrorCode::eases_count, "eases has {found} entries; expected {expected}, one per key, or none"},
    {BuildErrorCode::velocities_count,
     "velocities has {found} entries; expected {expected}, one per key and channel, or none"},
    {BuildErrorCode::given_count,
     "given has {found} entries; expected {expected}, one per channel where there are velocities, or none"},
    {BuildErrorCode::time_not_finite, "the time of key {key} is not finite; expected a finite number"},
    {BuildErrorCode::times_not_increasing,
     "the time of key {key} is not after that of the key before it; expected increasing times"},
    {BuildErrorCode::duration_overflow,
     "the duration up to key {key} exceeds the range of the scalar; expected closer times"},
    {BuildErrorCode::position_not_finite,
     "the position of key {key} in channel {channel} is not finite; expected a finite number"},
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
    {BuildErrorCode::velocity_count, "the end rule at key {key} has {found} velocities; expected {expected}"},
    {BuildErrorCode::velocity_not_finite,
     "the end velocity at key {key} in channel {channel} is not finite; expected a finite number"},
    {BuildErrorCode::equal_speed_without_roots,
     "equal speed needs square roots, which the scalar does not have; expected no equal speed"},
    {BuildErrorCode::curve_of_rotations,
     "Curve has no rotations; expected rules without them; use segments() of tangents.hpp, which has"},
    {BuildErrorCode::equal_speed_with_velocities,
     "equal speed changes the velocities, which are given; expected no equal speed"},
    {BuildErrorCode::closed_too_few_keys,
     "a closed curve has {found} key besides a repeated first key; expected at least two"},
    {BuildErrorCode::period_missing,
     "the period is missing; expected one, or a last key at the position of the first key"},
    {BuildErrorCode::period_not_finite, "the period or its end is not finite; expected a finite number"},
    {BuildErrorCode::period_too_short, "the period ends at key {key} or before it; expected a longer period"},
    {BuildErrorCode::period_contradicted,
     "key {key} repeats the first position before or after the end of the period; expected it at the end"},
    {BuildErrorCode::seam_tcb_differs,
     "key {key} repeats the first position with other tension, continuity or bias; expected the same"},
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
      if (at != std::string::npos) text.replace(at, name.size(), std::to_string(value));
    };
    insert("{key}", key);
    insert("{channel}", channel);
    insert("{expected}", expected);
    insert("{found}", found);
    return text;
  }
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

/// An error in the given velocities, if any. Those before the first key and after the last have no effect, unless the
/// curve is `closed`.
template <class S>
std::optional<BuildError> find_velocity_error(const Keys<S>& keys, bool closed = false) {
  for (std::size_t i = 0; i < keys.velocities.size(); ++i) {
    const std::size_t key = i / keys.channels, channel = i % keys.channels;
    const auto& [in, out] = keys.velocities[i];
    const bool has_in = closed || key > 0, has_out = closed || key + 1 < keys.size();
    if (!keys.given[channel] || ((!has_in || is_finite(in)) && (!has_out || is_finite(out)))) continue;
    return BuildError{.code = BuildErrorCode::key_velocity_not_finite, .key = key, .channel = channel};
  }
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
  if (auto error = find_time_error<S>(keys.times)) return error;
  for (std::size_t i = 0; i < keys.positions.size(); ++i) {
    if (!is_finite(keys.positions[i])) {
      return BuildError{.code = position_not_finite, .key = i / channels, .channel = i % channels};
    }
  }
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

/// An error in the rules for these keys, if any. A closed curve has no ends.
template <class S>
std::optional<BuildError> find_rule_error(const CurveRules<S>& rules, const Keys<S>& keys, bool closed) {
  using enum BuildErrorCode;
  const std::size_t channels = keys.channels;
  if (static_cast<std::size_t>(rules.tangents) >= tangent_rules<S>.size()) return BuildError{.code = unknown_rule};
  if (rules.equal_speed && !has_roots<S>) return BuildError{.code = equal_speed_without_roots};
  if (!rules.rotations.empty() || !rules.angles.empty()) return BuildError{.code = curve_of_rotations};
  if (rules.equal_speed && std::ranges::count(keys.given, true) > 0) {
    return BuildError{.code = equal_speed_with_velocities};
  }
  for (const std::size_t channel : rules.metric) {
    if (channel >= channels) {
      return BuildError{.code = metric_channel_missing, .channel = channel, .expected = channels};
    }
  }
  if (closed) return std::nullopt;
  if (auto error = find_end_error(rules.start, channels, 0)) return error;
  return find_end_error(rules.end, channels, keys.size() - 1);
}

}  // namespace tcb::spline
