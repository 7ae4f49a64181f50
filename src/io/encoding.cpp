// Encodings: text in UTF-16, UTF-32 or Windows-1252 to UTF-8.
#include "io/encoding.hpp"

#include <array>
#include <memory>
#include <utility>

#include "error.hpp"
#include "io/converter.hpp"

namespace tcb {
using namespace std::string_view_literals;

namespace {

Error not_in_encoding(std::string_view encoding) {
  return data_error(
      "the text is not in {}, as its byte order mark says; expected text; check whether the file is complete",
      encoding);
}

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
