// Errors: a message, where the fault is, and the exit code of the program.
//
// A message stands where its fault is found: throw data_error("{} is not a number; expected …; …", in_quotes(cell)).
// Where an option settles an error, the remedy says "give --NAME VALUE", from which cli/open_questions.cpp takes it.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
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

/// The one exception of the program, thrown where something is wrong; caught in main, or where the other
/// files of a batch go on.
class Error : public std::exception {
 public:
  /// The message: the fault, what was expected, and the remedy, separated by "; ".
  Error(Exit exit, std::string message) : exit_(exit), message_(std::move(message)) {}

  Exit exit() const { return exit_; }
  const std::string& message() const { return message_; }
  const TextPosition& position() const { return position_; }
  const std::vector<Error>& others() const { return others_; }

  /// Not for people: error_text() in io/terminal.hpp is.
  const char* what() const noexcept override { return "tcb::Error"; }

  /// What else is wrong with the same input.
  void add(Error other) { others_.push_back(std::move(other)); }

  /// This error about the value of an option or a member of JSON: its name and a colon come first.
  Error about(std::string_view subject) const {
    Error error = *this;
    error.message_ = std::string(subject) + ": " + message_;
    return error;
  }

  /// This error in a file, unless it already names one.
  Error in(const std::string& file) const {
    Error error = *this;
    if (error.position_.file.empty()) error.position_.file = file;
    for (Error& other : error.others_) other = other.in(file);
    return error;
  }

  /// This error without a position.
  Error without_position() const {
    Error error(exit_, message_);
    for (const Error& other : others_) error.others_.push_back(other.without_position());
    return error;
  }

  /// This error at a position, unless it already has one.
  Error at(const TextPosition& position) const {
    Error error = *this;
    if (error.position_.file.empty()) error.position_.file = position.file;
    if (error.position_.line == 0) error.position_ = {error.position_.file, position.line, position.column};
    return error;
  }

 private:
  Exit exit_;
  std::string message_;
  TextPosition position_;
  std::vector<Error> others_;
};

/// An error of the data, with exit code 1. The format and its arguments are those of fmt.
template <class... Arguments>
Error data_error(fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  return {Exit::data, fmt::format(message, std::forward<Arguments>(arguments)...)};
}

/// An error of usage, with exit code 2.
template <class... Arguments>
Error usage_error(fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  return {Exit::usage, fmt::format(message, std::forward<Arguments>(arguments)...)};
}

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
