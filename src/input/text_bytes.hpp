// Bytes of a text as they come, up to a NUL: what stands before it is understood first.
#pragma once

#include <string>
#include <utility>

#include "stream/stream.hpp"
#include "text/text_position.hpp"

namespace tcb {

class TextBytes {
 public:
  explicit TextBytes(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  /// Appends what comes next to a text that begins in `place`; false at the end of the input.
  /// Throws: Error (data) where a NUL stands behind the text.
  bool append_to(std::string& text, LinePosition place);

 private:
  Source<std::string> bytes_;
  bool at_nul_ = false;  ///< the byte behind the text is one
};

}  // namespace tcb
