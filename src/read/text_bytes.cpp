// Text bytes: the bytes of an input up to a NUL.
#include "read/text_bytes.hpp"

#include <optional>

#include "error.hpp"

namespace tcb {

bool TextBytes::append_to(std::string& text, LinePosition position) {
  if (at_nul_) {
    const LinePosition nul = position_after(text, position);
    throw data_error(
        "this is a NUL byte; expected text in UTF-8; convert the input, for example with iconv -f UTF-16 -t UTF-8")
        .at({"", nul.line, nul.column});
  }
  const std::optional<std::string> more = bytes_();
  if (!more) return false;
  const std::size_t nul = more->find('\0');
  at_nul_ = nul != std::string::npos;
  text.append(*more, 0, nul);
  return true;
}

}  // namespace tcb
