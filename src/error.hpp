// Errors: what is wrong as a code with values, where, and the exit code that it deserves. The words are in
// cli/remedies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tcb {

enum class Exit : int {
  done = 0,
  data = 1,   ///< the data was rejected
  usage = 2,  ///< wrong usage, or a file that cannot be opened or written
  interrupted = 130,
};

/// A position in the text of an input: line and column count from 1, the column in characters; 0 if there is none.
struct TextPosition {
  std::string file;
  std::uint64_t line = 0;
  std::uint64_t column = 0;
};

/// What can be wrong, folder by folder of the code that finds it. Each has its words in cli/remedies.
enum class ErrorCode {
  // io
  // schema, read
  times_unclear,           ///< name of the column that may be the time
  no_such_time,            ///< column, cell
  time_in_other_notation,  ///< column, cell
  // read/csv
  // keys
  // sample
  before_first_key,
  after_last_key,
  before_curve_start,
  beyond_curve_length,
  step_too_small,
  too_many_rows,
  too_many_rows_or_more,
  end_before_start,
  start_after_end,
  samples_beyond_doubles,
  beyond_curve_end,
  no_piece_in_range,
  piece_with_ease,  ///< number of the segment, times of its keys
  tolerance_too_small,
  // keys, sample and fit: the curve
  unknown_rule,
  velocity_missing,
  unexpected_rule_value,
  velocity_not_a_number,
  velocity_of_other_size,
  too_many_end_rules,
  exponent_out_of_range,
  period_not_positive,
  period_beyond_doubles,
  period_of_open_curve,
  ends_of_closed_curve,
  unknown_metric_channel,
  repeated_metric_channel,
  rotation_in_metric,
  no_rotation,  ///< what is of rotations
  angle_in_metric,
  path_of_rotations,
  only_rotations,
  tolerance_without_rotation,
  tolerance_of_rotations,
  fit_without_times,
  fit_of_keys,            ///< name of a role
  fit_without_tolerance,  ///< name of a channel
  fit_of_other_form,      ///< name of a column
  fit_of_missing,         ///< name of a channel
  fit_of_single_sample,
  fit_of_sequence,           ///< name of the output format
  fit_of_setting,            ///< name of a member of JSON
  fit_beyond_doubles,        ///< name of a channel
  fit_below_doubles,         ///< tolerance, name of a channel, its largest size, the least tolerance
  kept_time_without_sample,  ///< the time
  fit_impossible,
  end_velocity_of_rotation,
  emit_of_rotation,
  emit_of_angles,
  emit_of_angle,
  row_beyond_doubles,
  // exact
  decimal_too_long,
  row_needs_more_digits,
  // write
  other_columns,  ///< columns, columns of the files before
  // plot
  picture_beyond_doubles,
  picture_too_small,  ///< channels
  // run
  out_of_memory,
  unexpected,  ///< the message of a standard exception
  parameter_with_times,
  unknown_axis,  ///< channel, channels
  same_axes,     ///< channel
  // check: errors
  nothing_to_compare,         ///< columns of the samples, columns that could be compared
  repeated_column,            ///< name
  samples_without_places,     ///< columns of the samples, name of the time column
  unnamed_sample_columns,     ///< number of columns, number of expected ones, their names
  fields_without_places,      ///< about --fields
  tolerance_of_other_column,  ///< column, columns that are compared; about the option of the tolerance
  no_position_column,         ///< channels of the keys
  no_samples_on_curve,        ///< with the problems that are the reasons
  no_sample_numbers,
  // check: problems, which a report lists
  missing_columns,     ///< names
  unknown_columns,     ///< names
  curve_without_rows,  ///< group, as NAME=VALUE
  rows_without_keys,   ///< group, line of the first row
  curve_counts,        ///< of the rows, of the keys, of both
  times_off_curve,     ///< number of rows, line of the first one, its time, the nearest time of the curve
  lengths_off_curve,   ///< the same of arc lengths
  rows_without_place,  ///< number of rows, line of the first one
  // cli
  wrong_command_line,  ///< in the words of CLI11
  unknown_option,      ///< name, names of all options
  option_repeated,
  flag_with_value,  ///< name
  value_missing,    ///< name
  empty_value,
  empty_file_name,
  unknown_name,  ///< name, known names
  expected_within_doubles,
  expected_positive_ratio,
  expected_ratio,
  expected_ratios,
  expected_rate,
  expected_range,
  endless_range,
  range_too_long,  ///< text, the largest number of places
  list_without_numbers,
  group_without_places,  ///< group, as NAME=VALUE
  grouped_places_in_provenance,
  unreadable_list,
  expected_count,
  expected_form,
  expected_whole_number,  ///< text, least, most
  expected_curve_tolerance,
  expected_fit,
  expected_corner,
  expected_tolerance,
  expected_delimiter,
  expected_decimal_mark,
  expected_tcb,
  expected_columns,
  expected_renamings,
  expected_scales,
  expected_rotation,
  expected_euler_order,  ///< in a value
  expected_rotation_form,
  expected_angles,
  expected_name_part,
  expected_axes,
  expected_size,
  field_repeated,
  options_exclude,   ///< both options, reason
  option_needs,      ///< as options_exclude
  option_idle_with,  ///< as options_exclude
  option_idle,       ///< option, reason
  no_sampling_option,
  output_of_other_format,  ///< file, format of its ending, format that is given
  output_not_written,      ///< file, its ending
  binary_to_terminal,
  range_backwards,  ///< to, from
  standard_input_twice,
  comparison_of_several_files,  ///< number of files
  fit_picture_of_several_files,
  line_end_in_provenance,
  option_not_of_provenance,
  file_in_provenance,
  provenance_incomplete,
  option_in_provenance,   ///< file with provenance
  other_number_of_files,  ///< file with provenance, its number of inputs, the number given
};

/// Every code has a row of words in cli/remedies.
inline constexpr std::size_t error_code_count = static_cast<std::size_t>(ErrorCode::other_number_of_files) + 1;

/// A value that the words of an error show.
using ErrorValue = std::variant<std::string, double, std::uint64_t, std::vector<std::string>>;

/// The one exception of the program, thrown where something is wrong; caught in main, or where the other
/// files of a batch go on.
class Error : public std::exception {
 public:
  /// The message: the fault, what was expected, and the remedy, separated by "; ". Rooms have a function for each fault
  /// in their errors.hpp, which makes it.
  Error(Exit exit, std::string message) : exit_(exit), message_(std::move(message)) {}

  Error(Exit exit, ErrorCode code, std::vector<ErrorValue> values = {})
      : exit_(exit), code_(code), values_(std::move(values)) {}

  const std::string& message() const { return message_; }

  Exit exit() const { return exit_; }
  ErrorCode code() const { return code_; }
  const std::vector<ErrorValue>& values() const { return values_; }
  const TextPosition& position() const { return position_; }
  /// What a message with a code is about: the name of an option.
  const std::string& option() const { return option_; }
  const std::string& member() const { return member_; }
  const std::vector<Error>& others() const { return others_; }

  /// Not for people: error_text() in io/terminal.hpp is.
  const char* what() const noexcept override { return "tcb::Error"; }

  /// What else is wrong with the same input.
  void add(Error other) { others_.push_back(std::move(other)); }

  /// The same error about the value of an option or a member of JSON: its name and a colon come first.
  Error about(std::string_view subject) const {
    Error error = *this;
    (message_.empty() ? error.option_ : error.message_) =
        message_.empty() ? std::string(subject) : std::string(subject) + ": " + message_;
    return error;
  }

  /// The same error about the member of JSON that has the value of an option.
  Error about_member(Exit exit, std::string member) const {
    Error error = *this;
    error.exit_ = exit;
    error.member_ = std::move(member);
    return error;
  }

  /// The same error in this file, unless it already names one.
  Error in(const std::string& file) const {
    Error error = *this;
    if (error.position_.file.empty()) error.position_.file = file;
    for (Error& other : error.others_) other = other.in(file);
    return error;
  }

  /// The same error at this position, unless it already has one.
  Error at(const TextPosition& position) const {
    Error error = *this;
    if (error.position_.file.empty()) error.position_.file = position.file;
    if (error.position_.line == 0) error.position_ = {error.position_.file, position.line, position.column};
    return error;
  }

 private:
  Exit exit_;
  std::string message_;
  ErrorCode code_ = ErrorCode::unexpected;
  std::vector<ErrorValue> values_;
  TextPosition position_;
  std::string option_;
  std::string member_;
  std::vector<Error> others_;
};

/// The message of an error, or the words of its code.
std::string error_message(const Error& error);

/// Runs f; the errors that it throws are in this file.
template <class F>
auto in_file(const std::string& name, F f) {
  try {
    return f();
  } catch (const Error& error) {
    throw error.in(name);
  }
}

/// Runs f; the errors that it throws are at this position.
template <class F>
auto at_position(const TextPosition& position, F f) {
  try {
    return f();
  } catch (const Error& error) {
    throw error.at(position);
  }
}

}  // namespace tcb
