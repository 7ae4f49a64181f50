// Errors: a message, where the fault is, and the exit code of the program. Rooms make the messages in their errors.hpp;
// faults of the command line are codes, whose words are in cli/remedies.hpp.
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

/// What can be wrong with a command line. Each has its words in cli/remedies.
enum class ErrorCode {
  // run
  unexpected,  ///< the message of a standard exception
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
