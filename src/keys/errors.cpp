// Errors of keys: their order, curves, numbers, times made from distances, rotations, velocities, and segments.
#include "keys/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// "keys[3]: " where a key is in a list; its line is the position of the error elsewhere.
std::string beginning(const ShownKey& key) {
  return key.list_position.empty() ? "" : fmt::format("{}: ", key.list_position);
}

std::string time_and_place(const ShownKey& key) {
  if (!key.list_position.empty()) return fmt::format("{} of {}", key.time, key.list_position);
  return fmt::format("{} on line {}", key.time, key.line);
}

}  // namespace

Error equal_times(const ShownKey& key, const ShownKey& before) {
  return {Exit::data,
          fmt::format("{}time {} repeats the time {}; expected increasing times; remove one of the keys, or "
                      "give {} first, last or break",
                      beginning(key), key.time, time_and_place(before), option::duplicates)};
}

Error decreasing_times(const ShownKey& key, const ShownKey& before, bool are_unnamed) {
  return {
      Exit::data,
      fmt::format("{}time {} is less than the time {}; expected increasing times; sort the keys by "
                  "time, or give {}{}",
                  beginning(key), key.time, time_and_place(before), option::sort,
                  are_unnamed ? fmt::format(", or give {} uniform if the keys have no times", option::parameter) : "")};
}

Error curves_interleaved(const ShownKey& key, const ShownKey& before, std::string_view column) {
  return {Exit::data,
          fmt::format("{}time {} does not follow the time {}, but the times increase for each value of {}; "
                      "expected the keys of one curve; give {} {} for one curve per value",
                      beginning(key), key.time, time_and_place(before), in_quotes(column), option::group, column)};
}

Error sort_mixes_curves(std::string_view column) {
  return {Exit::data,
          fmt::format("{} would mix rows with different values of {} in one curve; expected the rows of one "
                      "curve; give {} {} for one curve per value, or {} carry={} if the values do not "
                      "distinguish curves",
                      option::sort, in_quotes(column), option::group, column, option::columns, column)};
}

Error sort_without_times() {
  return {Exit::data, fmt::format("{} orders rows by time, but there is no time column; remove it, or name the column "
                                  "with {} time=NAME",
                                  option::sort, option::columns)};
}

Error duplicates_without_times() {
  return {Exit::data, fmt::format("{} is about equal times, but there is no time column; remove it, or name the column "
                                  "with {} time=NAME",
                                  option::duplicates, option::columns)};
}

Error sort_of_segments() {
  return {Exit::data, fmt::format("{} orders keys, but the rows are segments; expected segments in order; remove {}",
                                  option::sort, option::sort)};
}

Error too_few_keys(std::size_t count) {
  return {Exit::data, fmt::format("there {}; a curve needs at least two; add keys",
                                  count == 0 ? "are no keys" : "is only one key")};
}

Error tcb_from_0_to_50(std::string_view role, double value) {
  return {Exit::data,
          fmt::format("{} is {}, as in 3ds Max and similar programs, which show 0 to 50 with 25 for 0; expected a "
                      "number that is usually from -1 to 1; give {} 3dsmax to convert it, or {} none to take "
                      "it unchanged",
                      role, value, option::tcb_scale, option::tcb_scale)};
}

Error tcb_in_percent(std::string_view role, double value) {
  return {Exit::data, fmt::format("{} is {}, as in a product that shows percent; expected a number that is usually "
                                  "from -1 to 1; divide it by 100, or give {} none to take it unchanged",
                                  role, value, option::tcb_scale)};
}

Error ease_out_of_range(std::string_view role, double value) {
  return {Exit::data,
          fmt::format("{} is {}; expected a number from 0 to 1; correct it, or give {}", role, value, option::no_ease)};
}

Error position_repeats(std::uint64_t line_before) {
  return {Exit::data,
          fmt::format("the position repeats the one on line {}, so the distance from which the time is made "
                      "is 0; expected different positions; remove one of the rows, or give {} uniform",
                      line_before, option::parameter)};
}

Error parameter_step_lost(double step, double time) {
  return {Exit::data, fmt::format("the distance gives a step of {}, which is too small to change the time {}; "
                                  "expected times that doubles can distinguish; give a smaller exponent to {}",
                                  step, time, option::parameter)};
}

Error rotation_incomplete(std::string_view column) {
  return {Exit::data, fmt::format("the rotation that begins with {} lacks a number; expected all of its numbers, or "
                                  "none; fill it in, or remove the row",
                                  in_quotes(column))};
}

Error quaternion_is_zero(std::string_view column) {
  return {Exit::data, fmt::format("the quaternion that begins with {} is zero, so it is not a rotation; expected the "
                                  "norm 1; correct it, or give {} none for plain channels",
                                  in_quotes(column), option::rotation)};
}

Error quaternion_not_unit(std::string_view column, double norm) {
  return {Exit::data, fmt::format("the quaternion that begins with {} has the norm {}; expected 1, within 0.001; check "
                                  "its columns and their order, or give {} to divide by the norm, or {} none for plain "
                                  "channels",
                                  in_quotes(column), norm, option::normalize, option::rotation)};
}

Error matrix_not_a_rotation(std::string_view column, double determinant) {
  return {Exit::data, fmt::format("the matrix that begins with {} has the determinant {}, so it is not a rotation; "
                                  "expected 1; check its columns and their order, or give {} none for plain channels",
                                  in_quotes(column), determinant, option::rotation)};
}

Error matrix_not_orthogonal(std::string_view column, double deviation) {
  return {Exit::data, fmt::format("the matrix that begins with {} deviates from an orthogonal one by {}; expected rows "
                                  "of the norm 1 at right angles, within 0.001; check its columns and their order, or "
                                  "give {} for the nearest rotation, or {} none for plain channels",
                                  in_quotes(column), deviation, option::normalize, option::rotation)};
}

Error axis_is_zero(std::string_view column, double angle) {
  return {Exit::data,
          fmt::format("the rotation that begins with {} has an angle of {}, but an axis of zero; expected a "
                      "direction; correct the axis",
                      in_quotes(column), angle)};
}

Error half_turn_between_rotations(std::string_view column, std::uint64_t other_line) {
  return {Exit::data, fmt::format("the rotation that begins with {} is exactly 180 degrees from the rotation on line "
                                  "{}, so its axis is undefined; expected a smaller angle; add a key between them",
                                  in_quotes(column), other_line)};
}

Error whole_turns_of_rotation(std::string_view column, double angle) {
  return {Exit::data, fmt::format("the rotation that begins with {} makes whole turns, with an angle of {}; expected a "
                                  "curve that can make them; give {} squad or slerp",
                                  in_quotes(column), angle, option::rotation_curve)};
}

Error velocities_of_part_of_rotation(std::string_view column) {
  return {Exit::data,
          fmt::format("some numbers of the rotation that begins with {} have velocities; expected "
                      "velocities of all four numbers of a quaternion, or none; leave these columns out with "
                      "{} ignore=NAME",
                      in_quotes(column), option::columns)};
}

Error velocities_with_slerp(std::string_view column) {
  return {Exit::data,
          fmt::format("the rotation that begins with {} has velocities, which the curve slerp does not use; "
                      "expected another curve; give {} squad, or leave the columns out with {} ignore=NAME",
                      in_quotes(column), option::rotation_curve, option::columns)};
}

Error angle_missing(std::string_view column) {
  return {Exit::data, fmt::format("the angle {} is missing; expected a number at every key; fill it in, or remove the "
                                  "row",
                                  in_quotes(column))};
}

Error angle_over_one_turn(std::string_view column, double radians) {
  return {Exit::data,
          fmt::format("{} has an angle of {} radians; expected at most one turn, 6.2832; give degrees as its "
                      "unit with {} or {}, or subtract whole turns",
                      in_quotes(column), radians, option::angles, option::angle)};
}

Error angle_too_large(std::string_view column, double angle) {
  return {Exit::data, fmt::format("{} has an angle of {}; expected at most 10000 turns; check its column, and its unit "
                                  "with {} or {}",
                                  in_quotes(column), angle, option::angles, option::angle)};
}

Error half_turn_between_angles(std::string_view column, std::uint64_t other_line) {
  return {Exit::data, fmt::format("the angle {} is exactly half a turn from the angle on line {}, so its direction is "
                                  "undefined; expected a smaller difference; add a key between them",
                                  in_quotes(column), other_line)};
}

Error equal_speed_with_velocities() {
  return {Exit::data, fmt::format("the keys have velocities, which {} would change; expected one of the two; remove {}",
                                  option::equal_speed, option::equal_speed)};
}

Error velocities_with_timing() {
  return {Exit::data,
          fmt::format("the keys have velocities, which a preset with monotone timing would change; expected "
                      "one of the two; give another {}",
                      option::preset)};
}

Error ease_with_timing() {
  return {Exit::data, fmt::format("the keys have ease, and the preset has monotone timing; expected one of the two; "
                                  "give {}, or another {}",
                                  option::no_ease, option::preset)};
}

Error missing_cells_with_timing() {
  return {Exit::data,
          fmt::format("some numbers were skipped by {} skip-cell, but a preset with monotone timing needs a "
                      "number in every channel; fill them in, or give another {}",
                      option::missing, option::preset)};
}

Error incoming_velocity_missing(std::string_view channel) {
  return {Exit::data, fmt::format("the incoming velocity of channel {} is missing; expected a number at every key but "
                                  "the first; fill it in, or remove the row",
                                  in_quotes(channel))};
}

Error outgoing_velocity_missing(std::string_view channel) {
  return {Exit::data, fmt::format("the outgoing velocity of channel {} is missing; expected a number at every key but "
                                  "the last; fill it in, or remove the row",
                                  in_quotes(channel))};
}

Error segment_starts_elsewhere(std::string_view start, std::string_view end_before) {
  return {Exit::data, fmt::format("this segment starts at {}, but the segment before it ends at {}; expected segments "
                                  "without gaps, in order; correct them, or divide the curves with {}",
                                  start, end_before, option::group)};
}

Error segment_jumps(double position, double position_before) {
  return {Exit::data, fmt::format("this segment starts at the position {}, but the segment before it ends at {}; "
                                  "expected the same position; correct one of the two",
                                  position, position_before)};
}

}  // namespace tcb
