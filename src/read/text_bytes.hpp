// Text bytes: the bytes of an input up to a NUL, and whole records of it.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "error.hpp"
#include "stream/source.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// Whole records of an input, as text.
struct Chunk {
  std::string text;
  std::uint64_t line = 1;    ///< of the first character, from 1
  std::uint64_t column = 1;  ///< of the first character, from 1
  std::uint64_t first = 0;   ///< number of the first record, in formats that count them
  std::string path = {};     ///< of the list that holds the records, in formats that have one
};

/// A source of text, which ends with an error at a NUL.
class TextBytes {
 public:
  explicit TextBytes(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  /// Appends the next bytes to a text that begins at `position`; false at the end of the input.
  /// Throws: Error (data) at a NUL, once the text before it was read.
  bool append_to(std::string& text, LinePosition position) {
    if (at_nul_) {
      const LinePosition nul = position_after(text, position);
      const bool may_be_utf16 = nul.line == 1 && nul.column <= 2;
      throw data_error("this is a NUL byte; expected text in UTF-8; {}",
                       may_be_utf16 ? fmt::format("convert it, as in iconv -f UTF-16{} -t UTF-8 <FILE | tcbsample",
                                                  nul.column == 1 ? "BE" : "LE")
                                    : "if it is text, remove such bytes")
          .at({"", nul.line, nul.column});
    }
    const std::size_t before = text.size();
    if (!append_next(text, bytes_)) return false;
    const std::size_t nul = text.find('\0', before);
    at_nul_ = nul != std::string::npos;
    if (at_nul_) text.resize(nul);
    return true;
  }

 private:
  Source<std::string> bytes_;
  bool at_nul_ = false;  ///< the next byte is a NUL
};

}  // namespace tcb
