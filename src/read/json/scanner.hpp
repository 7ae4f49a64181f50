// JSON scanner: strings, brackets and tokens of JSON text, for the splitter, for the parser, and for error positions.
//
// Source: RFC 8259.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "error.hpp"
#include "read/chunk.hpp"
#include "read/text_bytes.hpp"
#include "stream/source.hpp"

namespace tcb {

inline bool is_json_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

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
  bool is_blank() const;

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

  /// Reads more, up to a NUL; false at the end of the input.
  /// Throws: Error (data) `too_long` if there is too much text; at a NUL, once the text before it was read.
  bool read_more(ErrorCode too_long);

  /// Throws: Error (data) at the beginning of the text.
  [[noreturn]] void refuse(ErrorCode code) const;

  std::size_t at = 0;                  ///< scanned up to here
  bool in_string = false;              ///< which is inside a string
  std::uint64_t line = 1, column = 1;  ///< of the first character

 private:
  TextBytes bytes_;
  std::string text_;  ///< read and not yet cut off
  bool escaped_ = false;
};

/// How far a parser has read, and the number that it has not seen.
struct JsonReading {
  struct Number {
    double value;
    std::string_view text;
  };

  const char* now;               ///< it has read up to here
  std::optional<Number> number;  ///< that it has read as 0
};

/// A forward iterator over JSON text for nlohmann-json. A number with a fraction or an exponent is read here, and the
/// parser reads a 0 in its place, which is much faster. All other text, and numbers beyond doubles, are passed on
/// unchanged. Only one copy may be incremented, as all share the reading.
class JsonCursor {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  /// Requires: `reading` outlives it.
  JsonCursor(const char* at, const char* end, JsonReading& reading)
      : at_(at), end_(end), reading_(&reading), scanned_(at) {
    look();
  }

  reference operator*() const { return number_end_ == nullptr ? *at_ : zero; }
  JsonCursor& operator++() {
    if (number_end_ == nullptr) {
      ++at_;
    } else {
      reading_->number = number_;
      at_ = number_end_;
      number_end_ = nullptr;
    }
    reading_->now = at_;
    look();
    return *this;
  }
  bool operator==(const JsonCursor& other) const { return at_ == other.at_; }

 private:
  static constexpr char zero = '0';

  /// Looks at the next character.
  void look() {
    if (at_ < scanned_ || at_ == end_) return;
    if (*at_ == '"') {
      bool escaped = false;
      const char* const quote = find_closing_quote(at_ + 1, end_, escaped);
      scanned_ = quote == end_ ? end_ : quote + 1;
    } else if ((*at_ >= '0' && *at_ <= '9') || *at_ == '-') {
      look_at_number();
    }
  }
  void look_at_number();

  const char* at_;
  const char* end_;
  JsonReading* reading_;
  const char* scanned_;               ///< no string and no number begins before it
  const char* number_end_ = nullptr;  ///< the next token is a number that the parser reads as 0, and ends here:
  JsonReading::Number number_{};      ///< this one
};

/// Reads the tokens of JSON text one after another.
class JsonTokens {
 public:
  explicit JsonTokens(std::string_view text) : rest_(text) {}

  /// The next bracket, comma, colon, string with its quotes, number or word; empty at the end.
  std::string_view next();

 private:
  std::string_view rest_;
};

/// Whether a token is a string with both quotes.
bool is_json_string(std::string_view token);

/// What may be in place of a token.
enum class JsonExpected { value, value_or_end, name, name_or_end, colon, comma_in_array, comma_in_object, nothing };

/// The first token that breaks the grammar of JSON: its text, and what was expected instead.
struct JsonFault {
  std::string_view token;  ///< empty if the text ends too early, at its last token
  JsonExpected expected;
};
JsonFault find_json_fault(std::string_view text);

/// The start of the last string, number or word of a text, or the place after its last opening bracket.
const char* last_json_value(std::string_view text);

}  // namespace tcb
