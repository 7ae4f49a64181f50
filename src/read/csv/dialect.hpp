// Dialect: the syntax of delimited text.
//
// Source: RFC 4180 for quotes: a cell that begins with a quote ends with one, holds delimiters and line
//   ends as they are, and doubles each quote inside.
// Differs: LF or CRLF ends a record, the last may lack it; comment lines and blank lines are skipped;
//   where the delimiter is a blank, runs of blanks and tabs count as one, and a blank line or one that
//   begins with ">" ends a curve.
#pragma once

#include <string>
#include <string_view>

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

}  // namespace tcb
