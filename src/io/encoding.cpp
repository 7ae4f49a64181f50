// Encodings: text in UTF-16, UTF-32 or Windows-1252 to UTF-8, in the same way on all systems.
#include "io/encoding.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "error.hpp"

namespace tcb {
namespace {

using namespace std::string_view_literals;

constexpr char32_t order_mark = 0xFEFF, high_surrogate = 0xD800, low_surrogate = 0xDC00, after_surrogates = 0xE000,
                   after_all = 0x110000;

bool is_surrogate(char32_t unit) { return unit >= high_surrogate && unit < after_surrogates; }

void append_utf8(std::string& text, char32_t character) {
  constexpr std::array<char32_t, 3> one_byte_more{0x80, 0x800, 0x10000};
  unsigned more = 0;
  while (more < one_byte_more.size() && character >= one_byte_more[more]) ++more;
  constexpr std::array<unsigned, 4> lead{0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(lead[more] | character >> 6 * more);
  while (more-- > 0) text += static_cast<char>(0x80 | (character >> 6 * more & 0x3F));
}

/// The characters of Windows-1252 from 0x80 to 0x9F, where it differs from Latin-1; 0 where it has none.
constexpr std::array<char16_t, 32> characters_of_windows_1252{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

/// Converts the bytes of a text, in parts of any size.
class Decoder {
 public:
  explicit Decoder(Encoding encoding) : encoding_(encoding) {}

  /// Appends the characters that are complete; the others wait for further bytes. Returns whether all may be text.
  bool add(std::string_view bytes, std::string& text) {
    rest_ += bytes;
    std::size_t at = 0;
    bool is_text = true;
    while (is_text && rest_.size() - at >= unit_size()) {
      char32_t character = unit(at);
      std::size_t size = unit_size();
      if (begins_ && size > 1 && (character == 0xFFFE || character == 0xFFFE0000)) {
        is_big_ = true;
        character = order_mark;
      }
      if (encoding_ == Encoding::utf16 && is_surrogate(character)) {
        if (rest_.size() - at < 2 * size) break;
        const char32_t low = unit(at + size);
        is_text = character < low_surrogate && low >= low_surrogate && low < after_surrogates;
        character = 0x10000 + ((character - high_surrogate) << 10) + (low - low_surrogate);
        size *= 2;
      } else if (encoding_ == Encoding::windows_1252 && character >= 0x80 && character < 0xA0) {
        character = characters_of_windows_1252[character - 0x80];
        is_text = character != 0;
      } else {
        is_text = !is_surrogate(character) && character < after_all;
      }
      const bool is_mark = std::exchange(begins_, false) && character == order_mark;
      if (is_text && !is_mark) append_utf8(text, character);
      if (is_text) at += size;
    }
    rest_.erase(0, at);
    return is_text;
  }

  bool is_complete() const { return rest_.empty(); }

 private:
  std::size_t unit_size() const { return encoding_ == Encoding::utf16 ? 2 : encoding_ == Encoding::utf32 ? 4 : 1; }

  char32_t unit(std::size_t at) const {
    char32_t value = 0;
    for (std::size_t i = 0; i < unit_size(); ++i) {
      const std::size_t place = is_big_ ? i : unit_size() - 1 - i;
      value = value << 8 | static_cast<unsigned char>(rest_[at + place]);
    }
    return value;
  }

  Encoding encoding_;
  bool begins_ = true, is_big_ = false;
  std::string rest_;
};

Error not_in_encoding(Encoding encoding) {
  return data_error(
      "the text is not in {}, as its byte order mark says; expected text; check whether the file is complete",
      name_of(encoding));
}

}  // namespace

std::string_view name_of(Encoding encoding) {
  constexpr std::array names{"UTF-8"sv, "UTF-16"sv, "UTF-32"sv, "WINDOWS-1252"sv};
  return names.at(static_cast<std::size_t>(encoding));
}

Encoding encoding_of_mark(std::string_view beginning) {
  constexpr std::array marks{std::pair{"\xFF\xFE\0\0"sv, Encoding::utf32}, std::pair{"\0\0\xFE\xFF"sv, Encoding::utf32},
                             std::pair{"\xFF\xFE"sv, Encoding::utf16}, std::pair{"\xFE\xFF"sv, Encoding::utf16}};
  for (const auto& [mark, encoding] : marks) {
    if (beginning.starts_with(mark)) return encoding;
  }
  return Encoding::utf8;
}

std::optional<std::string> in_utf8(std::string_view text, Encoding encoding) {
  Decoder decoder(encoding);
  std::string result;
  const bool is_text = decoder.add(text, result) && decoder.is_complete();
  return is_text ? std::optional(std::move(result)) : std::nullopt;
}

Source<std::string> in_utf8(Source<std::string> bytes, Encoding encoding) {
  return [bytes = std::move(bytes), encoding, decoder = Decoder(encoding),
          is_text = true]() mutable -> std::optional<std::string> {
    std::string text;
    while (text.empty()) {
      if (!is_text) throw not_in_encoding(encoding);  // after the text before it, whose errors come first
      const std::optional<std::string> more = bytes();
      if (!more && !decoder.is_complete()) throw not_in_encoding(encoding);
      if (!more) return std::nullopt;
      is_text = decoder.add(*more, text);
    }
    return text;
  };
}

}  // namespace tcb
