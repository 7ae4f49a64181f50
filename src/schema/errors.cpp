// Errors of columns: requested roles, names, channels, segments, rotations, and units of times.
#include "schema/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error role_without_column(std::string_view request) {
  return {Exit::usage, fmt::format("{} has no column; expected its name or number; give it, as in {}NAME",
                                   in_quotes(request), request)};
}

Error not_a_role_with_columns(std::string_view text) {
  return {Exit::usage,
          fmt::format(
              "{} is not a role with its columns; expected time=NAME, position=NAME:NAME…, tension=, "
              "continuity=, bias=, tension_NAME=, continuity_NAME=, bias_NAME=, NAME_v=, NAME_vin=, NAME_vout=, "
              "ease_in=, ease_out=, group=, carry=, ignore= or nanoseconds=; for example {} time=frame,position=px:py",
              in_quotes(text), option::columns)};
}

Error same_column_names(std::string_view name) {
  return {Exit::data, fmt::format("two columns are called {}; expected different names; rename one, or choose columns "
                                  "by number with {}",
                                  in_quotes(name), option::columns)};
}

Error no_such_column(std::string_view name, std::span<const std::string> columns) {
  return {Exit::data,
          fmt::format("there is no column {}; expected one of {}; correct the name", in_quotes(name), listed(columns))};
}

Error no_such_column_number(std::string_view number, std::size_t column_count) {
  return {Exit::data, fmt::format("there is no column {}; the columns have no names; expected a number from 1 to {}; "
                                  "correct it",
                                  in_quotes(number), column_count)};
}

Error column_without_channel(std::string_view number, std::span<const std::string> numbers_of_channels) {
  return {Exit::data, fmt::format("column {} is the time or has another role; expected one of the columns {}; give "
                                  "another number, or {} uniform if the keys have no times",
                                  number, listed(numbers_of_channels), option::parameter)};
}

Error column_with_two_roles(std::string_view column) {
  return {Exit::data,
          fmt::format("column {} has two roles; expected one; correct {}", in_quotes(column), option::columns)};
}

Error two_times(std::string_view column, std::string_view other_column, std::string_view request,
                std::string_view other_request) {
  return {Exit::data, fmt::format("both {} and {} may be the time; expected one column of times; give {} {} or {} {}",
                                  in_quotes(column), in_quotes(other_column), option::columns, in_shell(request),
                                  option::columns, in_shell(other_request))};
}

Error two_columns_for_role(std::string_view role, std::string_view second_column) {
  return {Exit::data, fmt::format("a second column, {}, has the role {}; expected one column with it; choose one with "
                                  "{} {}=NAME",
                                  in_quotes(second_column), role, option::columns, role)};
}

Error column_may_be_group(std::string_view column) {
  return {Exit::data,
          fmt::format(
              "column {} may tell curves apart, and is no position by its name; expected its role; give {} {} for "
              "one curve per value, {} {} to keep it in the rows, or {} {} to leave it out",
              in_quotes(column), option::group, in_shell(column), option::columns,
              in_shell(fmt::format("carry={}", column)), option::columns, in_shell(fmt::format("ignore={}", column)))};
}

Error no_channel_column() {
  return {Exit::data, fmt::format("there is no position column; expected at least one column of numbers besides the "
                                  "time; name it with {} position=NAME",
                                  option::columns)};
}

Error column_nearly_role(std::string_view column, std::string_view role) {
  return {Exit::data, fmt::format("column {} would be a channel, but its name is close to the role {}; expected {}, or "
                                  "a name that is not close to it; rename the column, or give {} {}={} if it has this "
                                  "role, or {} position=NAME:NAME if it has not",
                                  in_quotes(column), role, role, option::columns, role, column, option::columns)};
}

Error column_of_unknown_channel(std::string_view column, std::string_view channel,
                                std::span<const std::string> channels) {
  return {Exit::data, fmt::format("column {} names a channel {}, which does not exist; expected one of "
                                  "{}; correct the name, or name the channels with {} position=NAME:NAME",
                                  in_quotes(column), in_quotes(channel), listed(channels), option::columns)};
}

Error role_of_unknown_channel(std::string_view role, std::string_view channel, std::span<const std::string> channels) {
  return {Exit::data, fmt::format("the role {} names a channel {}, which does not exist; expected one of the "
                                  "channels {}; correct the role",
                                  role, in_quotes(channel), listed(channels))};
}

Error velocity_columns_overlap(std::string_view both_sides, std::string_view one_side) {
  return {Exit::data, fmt::format("columns {} and {} both give the velocity on the same side of a key; expected {} for "
                                  "both sides, or a column for each side; remove one, or give {} ignore=NAME",
                                  in_quotes(both_sides), in_quotes(one_side), both_sides, option::columns)};
}

Error velocity_column_missing(std::string_view column, std::string_view missing_column) {
  return {Exit::data, fmt::format("column {} gives the velocity on one side of a key, but there is no {} for the other "
                                  "side; expected both, or one column for both sides; add it, or give {} ignore={}",
                                  in_quotes(column), in_quotes(missing_column), option::columns, column)};
}

Error velocity_with_tcb(std::string_view velocity_column, std::string_view tcb_column) {
  return {Exit::data, fmt::format("column {} gives velocities, so {} has no effect; expected velocities, or tension, "
                                  "continuity and bias; remove one of the columns, or give {} ignore=NAME",
                                  in_quotes(velocity_column), in_quotes(tcb_column), option::columns)};
}

Error tcb_with_all_velocities(std::string_view role) {
  return {Exit::data,
          fmt::format("all channels have velocities, so the column of {} has no effect; expected velocities, "
                      "or tension, continuity and bias; remove the column, or give {} ignore=NAME",
                      role, option::columns)};
}

Error segment_column_missing(std::string_view column, std::string_view missing_column) {
  return {Exit::data,
          fmt::format("the rows are segments and have a column {}, but no {}; expected both; add the missing "
                      "column, or give {} ignore={}",
                      in_quotes(column), in_quotes(missing_column), option::columns, column)};
}

Error segment_without_duration(double duration) {
  return {Exit::data,
          fmt::format("the duration of the segment is {}; expected a positive number, and an end within the "
                      "range of doubles; correct it",
                      duration)};
}

Error rotation_column_missing(std::string_view missing_column, std::span<const std::string> columns) {
  return {Exit::data,
          fmt::format("columns {} are three numbers of a quaternion, but there is no {}; expected four "
                      "numbers; add the missing column, or give {} none to take the three as plain channels",
                      listed(columns), in_quotes(missing_column), option::rotation)};
}

Error quaternion_without_letters(std::span<const std::string> columns, std::string_view with_first_as_w,
                                 std::string_view with_last_as_w) {
  return {
      Exit::data,
      fmt::format("columns {} may be a quaternion, but their names do not tell which of them is w; expected names with "
                  "x, y, z and w; give {} {} if it is {}, {} {} if it is {}, or {} none for plain channels",
                  listed(columns), option::rotation, in_shell(with_first_as_w), in_quotes(columns.front()),
                  option::rotation, in_shell(with_last_as_w), in_quotes(columns.back()), option::rotation)};
}

Error column_in_two_rotations(std::string_view column) {
  return {Exit::data, fmt::format("column {} is used twice; expected different columns for each rotation and angle; "
                                  "name another column",
                                  in_quotes(column))};
}

Error no_rotation_to_show(std::string_view form) {
  return {Exit::data, fmt::format("there is no rotation to show as {}; expected columns of a rotation; name them with "
                                  "{}",
                                  form, option::rotation)};
}

Error times_unclear(std::string_view column) {
  return {Exit::data,
          fmt::format("there is no time column, but column {} may be one; expected a column called time; give "
                      "{} time={}, or {} uniform if the keys have no times",
                      in_quotes(column), option::columns, column, option::parameter)};
}

Error times_without_column() {
  return {Exit::data, fmt::format("there is no time column, but the option needs one; name the column with {} "
                                  "time=NAME, or remove the option",
                                  option::columns)};
}

Error time_units_differ(std::string_view column, std::string_view unit_of_column, std::string_view unit_of_option) {
  return {Exit::data, fmt::format("the times are in {} by this option, but in {} by the name of column {}; "
                                  "expected one unit; remove the option, or rename the column",
                                  unit_of_option, unit_of_column, in_quotes(column))};
}

Error times_without_rate(std::string_view column) {
  return {Exit::data, fmt::format("the times in column {} are frames or timecode, but no frame rate is given; expected "
                                  "one; give it with {}, as in {} 24 or {} 30000/1001",
                                  in_quotes(column), option::input_fps, option::input_fps, option::input_fps)};
}

Error date_order_unknown(std::string_view column, std::string_view date) {
  return {Exit::data, fmt::format("the dates in column {}, such as {}, do not tell which number is the day; expected "
                                  "dates with the year first, or their order; give {} dmy if the day is first, or {} "
                                  "mdy if the month is",
                                  in_quotes(column), in_quotes(date), option::date_order, option::date_order)};
}

Error dates_have_year_first(std::string_view column, std::string_view date) {
  return {Exit::data,
          fmt::format("the dates in column {}, such as {}, have the year first; expected dates with the year "
                      "last; remove the option",
                      in_quotes(column), in_quotes(date))};
}

Error times_are_no_dates(std::string_view column) {
  return {Exit::data, fmt::format("the times in column {} are not dates; expected dates with the year last; remove the "
                                  "option",
                                  in_quotes(column))};
}

Error same_output_names(std::string_view name) {
  return {Exit::data, fmt::format("two columns of the output would be called {}; expected different names; choose "
                                  "another name, or rename the column in the input",
                                  in_quotes(name))};
}

}  // namespace tcb
