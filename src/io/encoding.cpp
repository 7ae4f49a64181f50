// Encodings: text in UTF-16, UTF-32 or Windows-1252 to UTF-8, by iconv of the C library.
#include "io/encoding.hpp"

#include <iconv.h>

#include <array>
#include <cerrno>
#include <memory>
#include <utility>

#include "io/errors.hpp"

namespace tcb {
namespace {

using namespace std::string_view_literals;

class Converter {
 public:
  explicit Converter(std::string_view encoding) : state_(iconv_open("UTF-8", std::string(encoding).c_str())) {}
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  ~Converter() {
    if (is_known()) iconv_close(state_);
  }

  // NOLINTNEXTLINE(performance-no-int-to-ptr): POSIX defines this value for unknown encodings
  bool is_known() const { return state_ != reinterpret_cast<iconv_t>(-1); }

  /// Appends the converted bytes to a text. An incomplete character at the end waits for further bytes.
  /// Returns whether all bytes may be text.
  bool add(std::string_view bytes, std::string& text) {
    rest_ += bytes;
    char* in = rest_.data();
    std::size_t left = rest_.size();
    bool more = true;
    while (more && left > 0) {
      std::array<char, 4096> part{};
      char* out = part.data();
      std::size_t room = part.size();
      errno = 0;
      const bool failed = iconv(state_, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
      text.append(part.data(), out);
      if (failed && errno == EILSEQ) return false;
      more = !failed || errno == E2BIG;
    }
    rest_.erase(0, rest_.size() - left);
    return true;
  }

  bool is_complete() const { return rest_.empty(); }

 private:
  iconv_t state_;
  std::string rest_;
};

}  // namespace

std::string_view encoding_of_mark(std::string_view beginning) {
  constexpr std::array marks{std::pair{"\xFF\xFE\0\0"sv, "UTF-32"sv}, std::pair{"\0\0\xFE\xFF"sv, "UTF-32"sv},
                             std::pair{"\xFF\xFE"sv, "UTF-16"sv}, std::pair{"\xFE\xFF"sv, "UTF-16"sv}};
  for (const auto& [mark, encoding] : marks) {
    if (beginning.starts_with(mark)) return encoding;
  }
  return {};
}

std::optional<std::string> in_utf8(std::string_view text, std::string_view encoding) {
  Converter converter(encoding);
  std::string result;
  const bool is_text = converter.is_known() && converter.add(text, result) && converter.is_complete();
  return is_text ? std::optional(result) : std::nullopt;
}

std::optional<Source<std::string>> in_utf8(Source<std::string> bytes, std::string_view encoding) {
  const auto converter = std::make_shared<Converter>(encoding);
  if (!converter->is_known()) return std::nullopt;
  return [=, bytes = std::move(bytes), is_text = true]() mutable -> std::optional<std::string> {
    std::string text;
    while (text.empty()) {
      if (!is_text) throw not_in_encoding(encoding);  // after the text before it, whose errors come first
      const std::optional<std::string> more = bytes();
      if (!more && !converter->is_complete()) throw not_in_encoding(encoding);
      if (!more) return std::nullopt;
      is_text = converter->add(*more, text);
    }
    return text;
  };
}

}  // namespace tcb
