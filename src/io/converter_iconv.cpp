// Converter by iconv of the C library.
#include <iconv.h>

#include <array>
#include <cerrno>

#include "io/converter.hpp"

namespace tcb {

struct Converter::State {
  iconv_t converter;

  // NOLINTNEXTLINE(performance-no-int-to-ptr): POSIX defines this value for unknown encodings
  bool is_known() const { return converter != reinterpret_cast<iconv_t>(-1); }
};

Converter::Converter(std::string_view encoding)
    : state_(std::make_unique<State>(State{iconv_open("UTF-8", std::string(encoding).c_str())})) {}

Converter::~Converter() {
  if (is_known()) iconv_close(state_->converter);
}

bool Converter::is_known() const { return state_->is_known(); }

bool Converter::add(std::string_view bytes, std::string& text) {
  rest_ += bytes;
  char* in = rest_.data();
  std::size_t left = rest_.size();
  bool more = true;
  while (more && left > 0) {
    std::array<char, 4096> part{};
    char* out = part.data();
    std::size_t room = part.size();
    errno = 0;
    const bool failed = iconv(state_->converter, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
    text.append(part.data(), out);
    if (failed && errno == EILSEQ) return false;
    more = !failed || errno == E2BIG;
  }
  rest_.erase(0, rest_.size() - left);
  return true;
}

}  // namespace tcb
