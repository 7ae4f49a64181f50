// What went wrong, where, and the exit code that it deserves.
#pragma once

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

/// A place in an input; line and column count from 1, column in characters, 0 where there is none.
struct Place {
  std::string file;
  std::uint64_t line = 0;
  std::uint64_t column = 0;
};

/// Text with its control characters, which names may have in them, as \xNN.
inline std::string in_one_line(const std::string& text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string shown;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool control = code < 0x20 || code == 0x7F;
    shown += control ? std::string{'\\', 'x', digits[code / 16], digits[code % 16]} : std::string(1, c);
  }
  return shown;
}

/// The one exception of the program, thrown by the layer that knows what is wrong, and caught in main, or where
/// other files of a batch go on.
/// The message says what is wrong, what was expected, and the remedy, in this order, parted by "; ".
class Error : public std::exception {
 public:
  Error(Exit exit, std::string message) : Error(exit, Place{}, std::move(message)) {}
  Error(Exit exit, Place place, std::string message)
      : exit_(exit), place_(std::move(place)), message_(std::move(message)) {}

  Exit exit() const { return exit_; }
  const char* what() const noexcept override { return message_.c_str(); }

  const Place& place() const { return place_; }

  /// What else is wrong with the same input; it is said on lines of its own.
  void add(Error other) { others_.push_back(std::move(other)); }

  /// The same error, said of this file unless it already names one.
  Error in(const std::string& file) const {
    Error error = *this;
    if (error.place_.file.empty()) error.place_.file = file;
    for (Error& other : error.others_) other = other.in(file);
    return error;
  }

  /// The same error, said of this place in its file unless it already names one.
  Error at(const Place& place) const {
    Error error = *this;
    if (error.place_.file.empty()) error.place_.file = place.file;
    if (error.place_.line == 0) error.place_ = {error.place_.file, place.line, place.column};
    return error;
  }

  /// "FILE:LINE:COLUMN: error: message", or "tcbsample: error: message" where there is no file; a line for each.
  std::string text() const {
    std::string all = line();
    for (const Error& other : others_) all += "\n" + other.text();
    return all;
  }

 private:
  std::string line() const {
    if (place_.file.empty()) return in_one_line("tcbsample: error: " + message_);
    std::string where = place_.file;
    if (place_.line != 0) where += ":" + std::to_string(place_.line);
    if (place_.line != 0 && place_.column != 0) where += ":" + std::to_string(place_.column);
    return in_one_line(where + ": error: " + message_);
  }

  Exit exit_;
  Place place_;
  std::string message_;
  std::vector<Error> others_;
};

/// Runs f; what it throws is said of this file.
template <class F>
auto in_file(const std::string& name, F f) {
  try {
    return f();
  } catch (const Error& error) {
    throw error.in(name);
  }
}

/// Runs f; what it throws is said of this place.
template <class F>
auto at_place(const Place& place, F f) {
  try {
    return f();
  } catch (const Error& error) {
    throw error.at(place);
  }
}

}  // namespace tcb
