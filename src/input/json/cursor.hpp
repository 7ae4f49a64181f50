// The cursor: JSON text as nlohmann-json reads it, but a number with a fraction or an exponent is read here.
//
// The parser sees a 0 in the place of each such number, which takes it a fraction of the time, and is told the number
// itself when it comes to what it read. What is not a number of JSON, or beyond doubles, it sees as it is.
#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

namespace tcb {

/// How far a parser has read, and what it has not seen.
struct JsonReading {
  struct Number {
    double value;
    std::string_view text;
  };

  const char* now;               ///< it has read up to here
  std::optional<Number> number;  ///< that it has read as 0, until it is asked for
};

/// A forward iterator over the text. Only one copy may be moved on, for they share what was read.
class JsonCursor {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  /// Requires: `reading` outlives it.
  JsonCursor(const char* at, const char* end, JsonReading& reading)
      : at_(at), end_(end), reading_(&reading), seen_(at) {
    look();
  }

  reference operator*() const { return behind_number_ == nullptr ? *at_ : zero; }
  JsonCursor& operator++() {
    if (behind_number_ == nullptr) {
      ++at_;
    } else {
      reading_->number = number_;
      at_ = behind_number_;
      behind_number_ = nullptr;
    }
    reading_->now = at_;
    look();
    return *this;
  }
  bool operator==(const JsonCursor& other) const { return at_ == other.at_; }

 private:
  static constexpr char zero = '0';

  /// Looks at the character that comes next.
  void look() {
    if (at_ == end_) return;
    if (in_string_) {
      in_string_ = escaped_ || *at_ != '"';
      escaped_ = !escaped_ && *at_ == '\\';
    } else if (*at_ == '"') {
      in_string_ = true;
    } else if (at_ >= seen_ && ((*at_ >= '0' && *at_ <= '9') || *at_ == '-')) {
      look_at_number();
    }
  }
  void look_at_number();

  const char* at_;
  const char* end_;
  JsonReading* reading_;
  bool in_string_ = false, escaped_ = false;
  const char* seen_;                     ///< up to here no number begins
  const char* behind_number_ = nullptr;  ///< a number that the parser sees as 0 is next, and ends here:
  JsonReading::Number number_{};         ///< this one
};

}  // namespace tcb
