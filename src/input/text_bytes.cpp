// Bytes of a text as they come, up to a NUL: what stands before it is understood first.
#include "input/text_bytes.hpp"

#include <optional>

#include "error.hpp"

namespace tcb {

bool TextBytes::append_to(std::string& text, LinePosition place) {
  if (at_nul_) {
    const LinePosition nul = place_after(text, place);
    throw Error(Exit::data, TextPosition{"", nul.line, nul.column},
                "a NUL byte; expected text in UTF-8; convert the input, for example with iconv -f UTF-16 -t UTF-8");
  }
  const std::optional<std::string> more = bytes_();
  if (!more) return false;
  const std::size_t nul = more->find('\0');
  at_nul_ = nul != std::string::npos;
  text.append(*more, 0, nul);
  return true;
}

}  // namespace tcb
