// UTF-8: lines and columns, invalid bytes, and quoting texts in messages.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tcb {

/// What some editors write before a text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// How many line ends a text has.
inline std::uint64_t count_lines(std::string_view text) {
  std::uint64_t count = 0;
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) ++count;
  return count;
}

/// The column after a text that begins in the given one; columns count characters.
std::uint64_t column_after(std::string_view text, std::uint64_t column);

/// A line and a column in it, from 1.
struct LinePosition {
  std::uint64_t line = 1;
  std::uint64_t column = 1;
};

/// The position after a text that begins in the given one.
inline LinePosition position_after(std::string_view text, LinePosition position) {
  return {position.line + count_lines(text), column_after(text, position.column)};
}

/// Finds the positions of places in a text that follow one another.
class LineCounter {
 public:
  explicit LineCounter(LinePosition begin = {}) : position_(begin) {}

  /// The position of a place, which is not before the last one.
  LinePosition to(std::string_view text, std::size_t place) {
    position_ = position_after(text.substr(place_, place - place_), position_);
    place_ = place;
    return position_;
  }

 private:
  std::size_t place_ = 0;
  LinePosition position_;
};

/// Where the first invalid byte of a text is, or npos.
std::size_t find_invalid_utf8(std::string_view text);

/// Text in quotes as messages show it: cut to a length that fits a line, with the bytes of control characters, among
/// them those of the direction of writing, and of invalid characters as \xNN.
std::string in_quotes(std::string_view text);

/// Text as messages and reports show it on a terminal: with invalid bytes and those of control characters, which names
/// of files and columns may have, as \xNN.
std::string printable(std::string_view text);

/// A message, or the place before it, as standard error shows it: printable, and where it is longer than 16 KB, with
/// each long word cut, as a name of a column may have any length.
std::string in_message(std::string_view text);

/// Text as a file holds it in one line: with the bytes of control characters as \xNN; invalid bytes remain.
std::string in_one_line(std::string_view text);

}  // namespace tcb
