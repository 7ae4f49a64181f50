// Where delimited records end: text is cut between them, without looking into them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "input/input.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// How records are written.
struct Dialect {
  char delimiter = ',';       ///< ' ' stands for runs of blanks and tabs
  std::string comment = "#";  ///< lines that begin with it are skipped; empty: none are
  bool divided = false;       ///< a blank line sets curves apart, whatever the delimiter

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  bool is_comment(std::string_view line) const { return !comment.empty() && line.starts_with(comment); }
  /// The line sets curves apart.
  bool is_divider(std::string_view line) const { return delimiter == ' ' && line.starts_with('>'); }
};

/// Cuts bytes into chunks of whole records. Requires: the bytes have no byte order mark.
/// Throws: Error (data) for a record over 64 MiB, which hardly anything but a quote left open makes, and for a NUL.
/// `line` is that of the first byte.
Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line = 1);

inline constexpr std::size_t longest_record = 64UL * 1024 * 1024;
[[noreturn]] void refuse_long_record(std::uint64_t line);

}  // namespace tcb
