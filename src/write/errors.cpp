// Errors of outputs: what a format cannot hold, columns, times in words, and provenance.
#include "write/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error text_in_binary_format(std::string_view column, std::string_view format) {
  return {Exit::data, fmt::format("column {} holds text, but {} holds only numbers; expected a format with text; give "
                                  "another one, such as csv, to {}, or remove the column",
                                  in_quotes(column), format, option::output_format)};
}

Error text_in_poses(std::string_view column, std::string_view format) {
  return {Exit::data, fmt::format("column {} holds text, but {} holds only times and poses; expected rows without "
                                  "text; give another format, such as csv, to {}",
                                  in_quotes(column), format, option::output_format)};
}

Error not_a_pose(std::size_t positions, std::size_t rotations, std::string_view format) {
  return {Exit::data,
          fmt::format("each row of {} is a pose, but the curve has channels of position: {}, rotations: "
                      "{}; expected 3 channels and 1 rotation; choose them with {} and {}, or give "
                      "another format, such as csv, to {}",
                      format, positions, rotations, option::columns, option::rotation, option::output_format)};
}

Error channel_of_format_missing(std::string_view channel, std::string_view format) {
  return {Exit::data,
          fmt::format("no channel is {}, which every row of {} has; expected a column of that name; add one, "
                      "or give another format to {}",
                      in_quotes(channel), format, option::output_format)};
}

Error poses_without_unit_of_time(std::string_view column, std::string_view format) {
  return {Exit::data, fmt::format("the times in column {} have no known unit, but those of {} are in nanoseconds; "
                                  "expected a unit; give {} s if they are seconds",
                                  in_quotes(column), format, option::time_unit)};
}

Error several_curves_in_one_table(std::string_view format) {
  return {Exit::data, fmt::format("there is more than one curve, but {} holds one table of rows; expected one curve; "
                                  "give another format, such as csv, to {}",
                                  format, option::output_format)};
}

Error no_path_with_yaw(const std::vector<std::string>& channels) {
  return {Exit::data,
          fmt::format("the channels are {}; expected three of a position, and yaw if there is a fourth; choose "
                      "them with {}, as in position=x:y:z:yaw",
                      listed(channels), option::columns)};
}

Error durations_not_in_seconds(std::string_view unit) {
  return {Exit::data,
          fmt::format("the times are in {}, but the durations of polynomials are in seconds; expected times in "
                      "seconds; convert them, or give {} where they are frames",
                      unit, option::input_fps)};
}

Error no_target_of_node(const std::vector<std::string>& channels) {
  return {Exit::data,
          fmt::format("the channels are {}; expected three of a translation, one rotation, or sx, sy and sz "
                      "of a scale; choose others with {}, or give another format to {}",
                      listed(channels), option::columns, option::output_format)};
}

Error no_target_of_track(std::string_view track) {
  return {Exit::data,
          fmt::format("the track {} is no position, rotation or scale that a node has; expected one of these; "
                      "choose others with {}",
                      in_quotes(track), option::only)};
}

Error several_curves_of_node(std::string_view name) {
  return {Exit::data,
          fmt::format("there is more than one curve of {}; expected one for each node of an animation; give "
                      "another format, such as csv, to {}",
                      in_quotes(name), option::output_format)};
}

Error time_before_start_of_animation(double time, double seconds) {
  return data_error("a keyframe is at {} seconds; expected times from 0 on, as animations have them; give {} {}",
                    seconds, option::time_zero, time);
}

Error times_not_in_single_precision(double seconds) {
  return {Exit::data,
          fmt::format(
              "the keyframe at {} seconds has the time of the one before it in single precision; "
              "expected times that differ there; give fewer samples, or {} first to count the times from the first key",
              seconds, option::time_zero)};
}

Error number_beyond_single_precision(double number) {
  return {Exit::data,
          fmt::format("{} is beyond the range of single precision; expected less than 3.4e38 in size; scale the "
                      "keys down",
                      number)};
}

Error animation_without_rows() {
  return {Exit::data, "a curve has no row in the range; expected one at least; give a longer range"};
}

Error time_not_a_double(std::string_view time) {
  return {Exit::data, fmt::format("time {} has more digits than a double holds; expected a double, or a text format; "
                                  "give another format, such as csv, to {}",
                                  time, option::output_format)};
}

Error time_not_in_notation(std::string_view time, std::string_view notation) {
  return {Exit::data,
          fmt::format("the time {} of a row cannot be written as {}; expected a time that is not before 0 "
                      "and is at a frame for timecode, and a year from 0 to 9999 for a date; give {} seconds",
                      time, notation, option::time_format)};
}

Error input_without_marks() {
  return {Exit::usage, fmt::format("the input is JSON, which has neither a delimiter nor a decimal mark; expected "
                                   "delimited text; remove {}",
                                   option::like_input)};
}

Error columns_differ_from_before(std::span<const std::string> columns, std::span<const std::string> columns_before) {
  return {Exit::data, fmt::format("the columns are {}; expected {}, as in the earlier files; give {} to write "
                                  "an output for each file",
                                  listed(columns), listed(columns_before), option::output_dir)};
}

Error file_column_taken(std::string_view name) {
  return {Exit::data, fmt::format("there already is a column {}; expected another name for the column of files; give "
                                  "{}=NAME",
                                  in_quotes(name), option::file_column)};
}

Error file_name_not_utf8(char byte) {
  return {Exit::data,
          fmt::format("the name of the file has the byte {:02X}, which is not UTF-8; expected UTF-8 for {}; "
                      "rename the file",
                      static_cast<unsigned char>(byte), option::file_column)};
}

Error checksum_differs(std::string_view checksum, std::string_view expected, std::string_view output) {
  return {Exit::data, fmt::format("its SHA-256 is {}; expected {}, as recorded in {}; give the recorded "
                                  "file",
                                  checksum, expected, output)};
}

Error made_from_fewer_inputs(std::string_view output, std::size_t inputs) {
  return {Exit::usage,
          fmt::format("there are more key files than {} was made from; expected {}; remove the rest", output, inputs)};
}

Error made_from_more_inputs(std::string_view output, std::size_t inputs) {
  return {Exit::usage,
          fmt::format("there are fewer key files than {} was made from; expected {}; add the rest", output, inputs)};
}

}  // namespace tcb
