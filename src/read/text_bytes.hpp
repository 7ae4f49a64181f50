// Text bytes: the bytes of an input up to a NUL.
#pragma once

#include <string>
#include <utility>

#include "stream/source.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// A source of text, which ends with an error at a NUL.
class TextBytes {
 public:
  explicit TextBytes(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  /// Appends the next bytes to a text that begins at `position`; false at the end of the input.
  /// Throws: Error (data) at a NUL, once the text before it was read.
  bool append_to(std::string& text, LinePosition position);

 private:
  Source<std::string> bytes_;
  bool at_nul_ = false;  ///< the next byte is a NUL
};

}  // namespace tcb
