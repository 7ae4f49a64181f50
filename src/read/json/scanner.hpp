// JSON scanner: strings and brackets of a JSON text that is read piece by piece; it knows no other grammar.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "read/chunk.hpp"
#include "read/text_bytes.hpp"
#include "stream/source.hpp"

namespace tcb {

inline bool is_json_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

bool is_json_blank(std::string_view text);

/// The closing quote of the string that `at` is in, or `end`. `escaped`: a backslash precedes `at`; on return at `end`,
/// whether one precedes what follows.
inline const char* find_closing_quote(const char* at, const char* end, bool& escaped) {
  if (at != end && escaped) {
    escaped = false;
    ++at;
  }
  while (at != end && *at != '"') {
    while (at != end && *at != '"' && *at != '\\') ++at;
    if (at == end || *at == '"') break;
    escaped = at + 1 == end;
    at += escaped ? 1 : 2;
  }
  return at;
}

/// Text that is appended to while it is scanned, and removed from its beginning.
class JsonScanner {
 public:
  explicit JsonScanner(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  std::size_t size() const { return text_.size(); }
  std::string_view view() const { return text_; }

  bool at_end() const { return at == text_.size(); }
  char now() const { return text_[at]; }

  void skip_blanks();
  /// Skips to the next bracket, comma or line end outside strings; false if the text ends before one.
  bool skip_to_structure();
  /// Skips from an opening brace to just before the closing one, where no other brace and no backslash is between.
  void skip_plain_object();
  /// Skips to the end of the current string; false if the text ends in it.
  bool skip_string();

  /// Cuts off and returns the text up to `end`.
  Chunk take(std::size_t end);

  /// Reads more, up to a NUL; false at the end of the input. Throws: Error (data) at a NUL, once the text before it was
  /// read.
  bool read_more() { return bytes_.append_to(text_, {line, column}); }

  std::size_t at = 0;                  ///< scanned up to here
  bool in_string = false;              ///< which is inside a string
  std::uint64_t line = 1, column = 1;  ///< of the first character

 private:
  TextBytes bytes_;
  std::string text_;  ///< read and not yet cut off
  bool escaped_ = false;
};

}  // namespace tcb
