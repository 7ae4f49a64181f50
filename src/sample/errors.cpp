// Errors of curves and samples, in the order of the flow.
#include "sample/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error about_setting(const SettingOrigin& setting, std::string message) {
  return Error(setting.exit(), std::move(message)).about(setting.subject).at(setting.position);
}

}  // namespace

Error unknown_rule(const SettingOrigin& setting, std::string_view name, std::span<const std::string_view> known) {
  return about_setting(setting, fmt::format("unknown name {}; expected one of {}{}", in_quotes(name), listed(known),
                                            did_you_mean(name, known)));
}

Error end_velocity_missing(const SettingOrigin& ends, std::string_view rule) {
  return about_setting(
      ends, fmt::format("{} has no velocity; expected a number for each channel, as in velocity=1:0", in_quotes(rule)));
}

Error end_velocity_unexpected(const SettingOrigin& ends, std::string_view rule) {
  return about_setting(ends, fmt::format("{} has a value; expected only a rule; remove it", in_quotes(rule)));
}

Error end_velocity_not_a_number(const SettingOrigin& ends, std::string_view rule, std::string_view number) {
  return about_setting(ends, fmt::format("{} in {} is not a number; expected a number for each channel, as in "
                                         "velocity=1:0",
                                         in_quotes(number), in_quotes(rule)));
}

Error end_velocity_of_other_size(const SettingOrigin& ends, std::size_t numbers,
                                 const std::vector<std::string>& channels) {
  return about_setting(ends, fmt::format("the velocity has {} numbers; expected {}, one for each of {}; correct it",
                                         numbers, channels.size(), listed(channels)));
}

Error end_velocity_with_timing(const SettingOrigin& ends) {
  return about_setting(ends,
                       fmt::format("the rule velocity gives a velocity, which a preset with monotone timing would "
                                   "change; expected a different end rule; change it, or give another {}",
                                   option::preset));
}

Error end_velocity_of_rotation(const SettingOrigin& ends) {
  return about_setting(ends, fmt::format("the rule velocity does not apply to rotations; expected a different end "
                                         "rule; change it, or give {} none to take rotations as plain channels",
                                         option::rotation));
}

Error too_many_end_rules(const SettingOrigin& ends, std::size_t rules) {
  return about_setting(
      ends, fmt::format("there are {} rules; expected one for both ends, or one for each end; remove some", rules));
}

Error ends_of_closed_curve(const SettingOrigin& ends, const SettingOrigin& closed) {
  const bool is_in_file = ends.exit() == Exit::data && closed.exit() == Exit::data;
  return Error(is_in_file ? Exit::data : Exit::usage,
               fmt::format("a closed curve has no ends; remove {} or {}", ends.subject, closed.subject))
      .about(ends.subject)
      .at(ends.position);
}

Error exponent_out_of_range(const SettingOrigin& parameter, std::string_view exponent) {
  return about_setting(parameter, fmt::format("the exponent is {}; expected 0 to 16", exponent));
}

Error period_not_positive(const SettingOrigin& period, std::string_view text) {
  return about_setting(
      period, fmt::format("{} is not a period; expected a decimal or a ratio above 0, such as 7.5", in_quotes(text)));
}

Error period_beyond_doubles(const SettingOrigin& period, std::string_view text) {
  return about_setting(period, fmt::format("{} is too large; expected at most 1.7976931348623157e308, the largest "
                                           "double",
                                           in_quotes(text)));
}

Error period_of_open_curve(const SettingOrigin& closed) {
  return about_setting(closed,
                       "the curve is open, but has a period; expected a closed curve; close it, or remove the period");
}

Error no_channel_of_metric(const SettingOrigin& metric, std::string_view name,
                           const std::vector<std::string>& channels) {
  return about_setting(metric, fmt::format("there is no channel {}; expected some of {}, by name or by number from 1{}",
                                           in_quotes(name), listed(channels), did_you_mean(name, channels)));
}

Error repeated_metric_channel(const SettingOrigin& metric, std::string_view channel) {
  return about_setting(
      metric, fmt::format("channel {} is repeated; expected each channel once; remove one", in_quotes(channel)));
}

Error rotation_in_metric(const SettingOrigin& metric, std::string_view channel) {
  return about_setting(metric, fmt::format("channel \"{}\" belongs to a rotation, which has no length; expected "
                                           "positions; give {} none to take it as a position",
                                           channel, option::rotation));
}

Error angle_in_metric(const SettingOrigin& metric, std::string_view channel) {
  return about_setting(metric, fmt::format("channel \"{}\" is an angle, which has no length; expected positions; leave "
                                           "it out, or take it as a position by leaving it out of {}",
                                           channel, option::angle));
}

Error metric_without_rotations(const SettingOrigin& metric) {
  return about_setting(metric, fmt::format("there is no rotation to measure; name its columns with {}, or measure "
                                           "channels",
                                           option::rotation));
}

Error only_rotations() {
  return {Exit::data, fmt::format("there are only rotations or angles, which have no length; expected a position; give "
                                  "{} rotation to measure angles, or {} none to take the numbers as positions",
                                  option::metric, option::rotation)};
}

Error path_of_rotations() {
  return {Exit::usage, fmt::format("{} rotation measures angles, so there are arc lengths, but no distances, speeds "
                                   "or shapes of a path; leave these out, or give the field angular_speed",
                                   option::metric)};
}

Error pieces_of_angles() {
  return {Exit::data, fmt::format("the pieces of an angle would lie in different turns; expected no angles; remove {} "
                                  "or {}",
                                  option::angle, option::emit)};
}

Error pieces_of_other_form() {
  return {Exit::data, fmt::format("the pieces of a rotation are cubics of its quaternion; expected "
                                  "rotations as quaternions; give {} quaternion",
                                  option::rotation_output)};
}

Error pieces_of_rotations(std::string_view curve) {
  return {Exit::data, fmt::format("the rotation curve {} has no cubics to print as pieces; expected components; give "
                                  "{} components, {} none, or samples instead, as with {}",
                                  curve, option::rotation_curve, option::rotation, option::count)};
}

Error field_without_rotations(std::string_view field) {
  return {Exit::data, fmt::format("{} needs a rotation, and there is none; name its columns with {}, or remove the "
                                  "field",
                                  field, option::rotation)};
}

Error tolerance_without_rotation() {
  return {Exit::data, fmt::format("the tolerance has an angle, but there is no rotation; give the distance alone, or "
                                  "name a rotation with {}",
                                  option::rotation)};
}

Error tolerance_of_rotations() {
  return {Exit::data, fmt::format("the tolerance has a distance, but there are only rotations or angles, which have "
                                  "none; give an angle alone, as in 0.5deg, or {} none to take the numbers as "
                                  "positions",
                                  option::rotation)};
}

Error closing_key_differs(std::uint64_t line) {
  return {Exit::data, fmt::format("this key closes the curve at the position of line {}, but has a different tension, "
                                  "continuity or bias; expected the same numbers; correct one of the two keys",
                                  line)};
}

Error closing_velocity_differs(std::uint64_t line) {
  return {Exit::data, fmt::format("this key closes the curve at the position of line {}, but the velocity differs; "
                                  "expected the same; correct one of the two keys, or leave the incoming velocity of "
                                  "the first key and the outgoing velocity of the last key empty",
                                  line)};
}

Error closing_key_against_period(std::uint64_t line) {
  return {Exit::data, fmt::format("this key repeats the position of line {}, so it ends the period, but the "
                                  "given period differs; remove the key or the period",
                                  line)};
}

Error period_too_short(std::string_view time) {
  return {Exit::data, fmt::format("the period ends before the last key, at time {}; give a longer period", time)};
}

Error too_few_closed_keys() { return {Exit::data, "a closed curve needs at least two distinct keys; add keys"}; }

Error no_period() {
  return {Exit::data, fmt::format("the period of the closed curve is unknown; give {}, or add a last row that repeats "
                                  "the first position",
                                  option::period)};
}

Error seam_velocity_missing(std::string_view channel) {
  return {Exit::data, fmt::format("a velocity of channel \"{}\" is missing where the closed curve returns to its first "
                                  "key; expected the incoming velocity of the first key and the outgoing velocity of "
                                  "the last key; fill them in",
                                  channel)};
}

Error channel_without_numbers(std::string_view channel) {
  return {Exit::data, fmt::format("no key has a number in channel \"{}\"; expected at least one; fill one in, or leave "
                                  "the column out with {}",
                                  channel, option::columns)};
}

Error ease_with_missing_cells() {
  return {Exit::data, fmt::format("some numbers were skipped by {} skip-cell, but ease_in and ease_out need a number "
                                  "in every channel; fill them in, or give {}",
                                  option::missing, option::no_ease)};
}

Error tangents_beyond_doubles(std::string_view from, std::string_view to) {
  return {Exit::data,
          fmt::format("the curve from time {} to {} has tangents beyond the range of doubles; expected less "
                      "than 1.8e308 in size; scale the keys down",
                      from, to)};
}

Error length_beyond_doubles(std::string_view to) {
  return {Exit::data, fmt::format("the length of the curve up to time {} is beyond the range of doubles; expected less "
                                  "than 1.8e308; scale the keys down",
                                  to)};
}

Error before_first_key(std::string_view time, std::string_view first) {
  return {Exit::usage, fmt::format("time {} is before the first key, at {}; give a time on the curve, or {}", time,
                                   first, option::extrapolate)};
}

Error after_last_key(std::string_view time, std::string_view last) {
  return {Exit::usage, fmt::format("time {} is after the last key, at {}; give a time on the curve, or {}", time, last,
                                   option::extrapolate)};
}

Error before_first_piece(std::string_view time, std::string_view first) {
  return {Exit::usage, fmt::format("time {} is before the first key, at {}; give a time on the curve", time, first)};
}

Error after_last_piece(std::string_view time, std::string_view last) {
  return {Exit::usage, fmt::format("time {} is after the last key, at {}; give a time on the curve", time, last)};
}

Error below_length(std::string_view length, std::string_view least) {
  return {Exit::usage, fmt::format("arc length {} is below {}, that of the first key; give a length within the curve",
                                   length, least)};
}

Error beyond_length(std::string_view length, std::string_view most) {
  return {Exit::usage, fmt::format("arc length {} is beyond the length of the curve, {}; give a length within the "
                                   "curve",
                                   length, most)};
}

Error end_before_start(std::string_view end, std::string_view start) {
  return {Exit::usage, fmt::format("{} is before {}, where samples begin without {}; give a later end, or {}", end,
                                   start, option::from, option::from)};
}

Error start_after_end(std::string_view start, std::string_view end) {
  return {Exit::usage, fmt::format("{} is after {}, where samples end without {}; give an earlier start, or {}", start,
                                   end, option::to, option::to)};
}

Error samples_beyond_doubles() {
  return {Exit::data,
          "the distance from the first sample to the last is beyond the range of doubles; expected less "
          "than 1.8e308; scale the keys down"};
}

Error step_too_small(std::string_view step, std::string_view place) {
  return {Exit::usage, fmt::format("the step {} is too small: two rows near {} would coincide; give a "
                                   "larger step",
                                   step, place)};
}

Error tolerance_too_small() {
  return {Exit::usage, "the tolerance is too small: two rows would be the same; give a larger tolerance"};
}

Error too_many_rows(std::string_view rows, std::uint64_t most, bool at_least) {
  return {Exit::usage, fmt::format("{}{} rows are requested; expected at most {}; request fewer, or raise {}",
                                   at_least ? "at least " : "", rows, most, option::max_rows)};
}

Error too_many_rows_of_unit(std::string_view rows, std::uint64_t most, std::string_view unit) {
  return {Exit::usage,
          fmt::format("{} rows are requested, as the unit of the times is unknown, but they seem to be {} since "
                      "1970; expected at most {}; give {} {}, with which rates and durations such as 0.1s are "
                      "in seconds",
                      rows, unit, most, option::time_unit, unit)};
}

Error no_piece_in_range() {
  return {Exit::usage, fmt::format("no part of the curve lies between {0} and {1}; expected a longer range; "
                                   "correct {0} or {1}",
                                   option::from, option::to)};
}

Error piece_with_ease(std::uint64_t number, std::string_view from, std::string_view to) {
  return {Exit::data, fmt::format("segment {}, from the key at time {} to the key at {}, has ease, so it is not cubic "
                                  "in time; expected keys without ease; give {}, or a sampling option instead of {}",
                                  number, from, to, option::no_ease, option::emit)};
}

Error row_beyond_doubles(std::string_view time) {
  return {Exit::data, fmt::format("the row at time {} has a number beyond the range of doubles; expected less than "
                                  "1.8e308 in size; scale the keys down",
                                  time)};
}

}  // namespace tcb
