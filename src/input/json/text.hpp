// JSON text as it comes: read on, looked at character by character, cut off, with its place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "input/input.hpp"
#include "input/text_bytes.hpp"
#include "stream/stream.hpp"

namespace tcb {

class JsonText {
 public:
  explicit JsonText(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  std::size_t size() const { return text_.size(); }
  std::string_view view() const { return text_; }
  bool is_blank() const;

  /// Scanning has come to the end of what was read.
  bool at_end() const { return at == text_.size(); }
  char now() const { return text_[at]; }

  void skip_blanks();
  /// Up to the next bracket, comma or line end outside strings; false where more text has to come to find one.
  bool skip_to_telling();
  /// From the opening brace at hand to before the closing one, where that is easily seen.
  void skip_plain_object();
  /// To the end of the string that is being scanned; false where more text has to come.
  bool skip_string();

  /// Cuts text off at `end`.
  Chunk take(std::size_t end);

  /// Reads on, up to a NUL; false at the end of the input.
  /// Throws: Error (data) where there is too much text, saying so, and at a NUL, once the text before it was read.
  bool read_more(const char* too_much);

  /// Throws: Error (data) at the beginning of the text.
  [[noreturn]] void refuse(const char* message) const;

  std::size_t at = 0;                  ///< scanned up to here
  bool in_string = false;              ///< which is inside a string
  std::uint64_t line = 1, column = 1;  ///< of the first character

 private:
  TextBytes bytes_;
  std::string text_;  ///< read and not yet cut off
  bool escaped_ = false;
};

}  // namespace tcb
