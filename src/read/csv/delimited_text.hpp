// Delimited text: dialect, splitting into chunks of whole records, header, and records to keys.
//
// Source: RFC 4180 for quotes: a cell that begins with a quote ends with one, holds delimiters and line
//   ends as they are, and doubles each quote inside.
// Differs: LF or CRLF ends a record, the last may lack it; comment lines and blank lines are skipped;
//   where the delimiter is a blank, runs of blanks and tabs count as one, and a blank line or one that
//   begins with ">" ends a curve.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/chunk.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

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

/// The delimiter of a record: the first of tab, ";", "," and blank that occurs in it outside quotes, or "," where none
/// does; with a decimal comma "," comes last. Nothing if the text does not hold the whole record, with its line end.
std::optional<char> delimiter_of(std::string_view record, char decimal);

/// The beginning of delimited text.
struct Beginning {
  char delimiter = ',';
  std::string text;        ///< read so far, from the first record, or from a comment directly above it
  std::uint64_t line = 1;  ///< of the first character
};

/// Reads until the first record is whole. Throws: Error (data) for a record over 64 MiB.
Beginning find_delimiter(const Source<std::string>& bytes, const InputOptions& options);

/// The delimiter that a first line such as "sep=;" names, as spreadsheets write it; that line is dropped.
std::optional<char> take_named_delimiter(Source<std::string>& bytes);

/// Cuts bytes into chunks of whole records. `line` is that of the first byte.
/// Requires: the bytes have no byte order mark. Throws: Error (data) for a NUL, and for a record over 64 MiB, which
/// usually comes from a missing quote.
Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line = 1);

inline constexpr std::size_t longest_record = 64UL * 1024 * 1024;
[[noreturn]] void refuse_long_record(std::uint64_t line);

/// What the header and the first records determine.
struct DelimitedHead {
  Dialect dialect;
  Columns columns;
  KeyRules rules;
  char decimal = '.';
};

/// Dialect and columns, from the header if there is one and the first two records after it; `rest` gets the text that
/// was read, from the first record of numbers on. Throws: Error (data).
DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest);

/// Whether a text is a number such as 1,234.5 or 1,234,567.
bool has_thousands_separators(std::string_view text);

/// Why a cell of a column is not a number, which was expected. `decimal` is the decimal mark.
/// Requires: it is not a sign of a missing number.
Error why_not_number(std::string_view column, std::string_view cell, char decimal);

/// In a column of text a number is a fault up to this line; in those after it, it is a text.
inline constexpr std::uint64_t last_line_of_roles = 1000;

/// The keys of a chunk. A pure function. Errors are among its faults, at the position of the cell; at most ten.
KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head);

/// Opens delimited text whose delimiter is given, or else detected in the first record.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Records open_delimited(Source<std::string> bytes, const InputOptions& options);

inline constexpr std::size_t most_cells = std::size_t{1} << 20;  ///< of a record

/// Reads the records of a chunk one after another.
class Tokenizer {
 public:
  Tokenizer(const Chunk& chunk, const Dialect& dialect);

  /// The cells of the next record as written, without blanks around them; false at the end. Comments and blank lines
  /// are skipped; the last comment skipped is in comment(). Throws: Error (data) for a misplaced quote and for more
  /// than most_cells, after it has skipped the record.
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

/// The text of a cell without its quotes.
std::string unquoted(std::string_view cell);

}  // namespace tcb
