// Tokenizer of delimited text: its syntax, records and their cells, and why a cell is not a number.
//
// Source: RFC 4180 for quotes: a cell that begins with a quote ends with one, holds delimiters and line
//   ends as they are, and doubles each quote inside.
// Differs: LF or CRLF ends a record, the last may lack it; comment lines and blank lines are skipped;
//   where the delimiter is a blank, runs of blanks and tabs count as one, and a blank line or one that
//   begins with ">" ends a curve.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "numbers/parse_number.hpp"
#include "read/text_bytes.hpp"

namespace tcb {

/// The syntax of records.
struct Dialect {
  char delimiter = ',';       ///< ' ' is any run of blanks and tabs
  std::string comment = "#";  ///< the prefix of lines to skip; empty: none
  bool divided = false;       ///< a blank line divides curves with any delimiter

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  bool is_comment(std::string_view line) const { return !comment.empty() && line.starts_with(comment); }
  /// Whether the line divides two curves.
  bool is_divider(std::string_view line) const { return delimiter == ' ' && line.starts_with('>'); }
};

inline constexpr std::size_t most_cells = std::size_t{1} << 20;  ///< of a record

/// Reads the records of a chunk one after another.
class Tokenizer {
 public:
  Tokenizer(const Chunk& chunk, const Dialect& dialect);

  /// The cells of the next record as written, without blanks around them; false at the end. Comments and blank lines
  /// are skipped; the comments directly above the record are in comment(). Throws: Error (data) for a misplaced quote
  /// and for more than most_cells, after it has skipped the record.
  bool next(std::vector<std::string_view>& cells);

  /// Whether a line before this record, or at the end one after the last record, ends the curve.
  bool broken() const { return broken_; }
  /// Whether there is a blank line before this record.
  bool follows_blank() const { return follows_blank_; }

  std::uint64_t line() const { return record_line_; }
  std::size_t offset() const { return static_cast<std::size_t>(record_ - begin_); }
  std::string_view comment() const { return comment_; }

  /// The text position of a cell of the current record.
  TextPosition position(std::string_view cell) const;
  std::uint64_t column(std::string_view cell) const;

 private:
  bool skip_to_record();
  void skip_line();
  [[noreturn]] void refuse_cells();
  std::string_view take_cell();
  std::string_view take_quoted();
  bool at_line_end() const {
    return at_ == end_ || *at_ == '\n' || (*at_ == '\r' && (at_ + 1 == end_ || at_[1] == '\n'));
  }
  void pass_line_end();

  const Dialect& dialect_;
  const char *begin_, *at_, *end_;
  const char* record_;
  std::uint64_t line_, record_line_;
  std::string_view comment_;
  bool broken_ = false, follows_blank_ = false;
};

/// A text without the blanks around it, and without CR at its end.
inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == '\r' || Dialect::is_blank(text.back()))) text.remove_suffix(1);
  while (!text.empty() && Dialect::is_blank(text.front())) text.remove_prefix(1);
  return text;
}

/// What is between the quotes of a cell, or the cell: a text in which a quote may be doubled.
inline std::string_view bare(std::string_view cell) {
  return cell.size() >= 2 && cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}
/// The text of a cell without its quotes.
std::string unquoted(std::string_view cell);

/// The number of a cell is too large for a double.
Error number_beyond_doubles(std::string_view column, std::string_view cell);

/// Marks of numbers in spreadsheets and in texts for people, besides a decimal point alone.
inline constexpr std::array other_marks{NumberMarks{'.', ','},  NumberMarks{',', 0},    NumberMarks{',', '.'},
                                        NumberMarks{',', ' '},  NumberMarks{'.', '\''}, NumberMarks{'.', ' '},
                                        NumberMarks{',', '\''}, NumberMarks{'.', '_'},  NumberMarks{',', '_'}};

/// Whether a text is a number with marks between thousands, such as 1,234.5, 1.234,5 or 1 234.
bool has_thousands_separators(std::string_view text);

/// A date in a form that is not read, which `known` is as date_in_known_form() returns it.
Error date_not_read(std::string_view column, std::string_view cell, std::string_view known);

/// Why a cell of a column is not a number, which was expected. `marks` are those of the input.
/// Requires: it is not a sign of a missing number.
Error why_not_number(std::string_view column, std::string_view cell, const NumberMarks& marks);

}  // namespace tcb
