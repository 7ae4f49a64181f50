// UTF-8: decoding as far as validity needs it, and escaping.
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace tcb {
namespace {

unsigned code(char c) { return static_cast<unsigned char>(c); }

/// Whether a character changes how a terminal or a page shows the text around it: controls of ASCII and of Latin-1 (C0
/// and C1), separators of lines, and controls of the direction of writing.
/// Source: the Unicode Standard, sections 23.1 and 23.2 (general categories Cc, Zl and Zp; property Bidi_Control).
bool is_control(std::string_view character) {
  if (character.size() == 1) return code(character[0]) < 0x20 || code(character[0]) == 0x7F;
  if (character.size() == 2) return (character[0] == '\xC2' && code(character[1]) < 0xA0) || character == "\u061C";
  if (character.size() > 3) return false;
  return character == "\u200E" || character == "\u200F" || (character >= "\u2028" && character <= "\u202E") ||
         (character >= "\u2066" && character <= "\u2069");
}

std::string escaped(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("\\x{:02X}", code(c));
  return text;
}

/// How many bytes the character at the beginning has; 0 if it is invalid.
/// Source: RFC 3629, section 4.
std::size_t character_size(std::string_view text) {
  const unsigned first = code(text[0]);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((code(text[i]) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = code(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool beyond = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : size;
}

/// The characters in the first bytes of a text, with the bytes of control characters and maybe of invalid ones as \xNN.
struct ShownText {
  std::string text;
  bool is_cut = false;  ///< it has more characters
};
ShownText shown_text(std::string_view text, std::size_t most_bytes, bool escapes_invalid) {
  ShownText shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_size(text.substr(at));
    const std::string_view character = text.substr(at, std::max<std::size_t>(size, 1));
    at += character.size();
    if (at > most_bytes) return {std::move(shown.text), true};
    const bool is_escaped = is_control(character) || (size == 0 && escapes_invalid);
    shown.text += is_escaped ? escaped(character) : std::string(character);
  }
  return shown;
}

/// The first and the last bytes of valid UTF-8, without parts of characters, around "…".
std::string without_middle(std::string_view text, std::size_t first, std::size_t last) {
  const auto is_inside = [](char c) { return (code(c) & 0xC0U) == 0x80U; };
  std::size_t end = first, begin = text.size() - last;
  while (end > 0 && is_inside(text[end])) --end;
  while (begin < text.size() && is_inside(text[begin])) ++begin;
  return fmt::format("{}…{}", text.substr(0, end), text.substr(begin));
}

/// The number of bytes that begin a character; those after its first are 10xxxxxx. Eight bytes of ASCII at a time.
std::uint64_t count_characters(std::string_view text) {
  std::uint64_t count = text.size();
  const char *at = text.data(), *const end = at + text.size();
  const auto is_ascii = [&] {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof bytes);
    return (bytes & 0x8080808080808080) == 0;
  };
  while (at != end) {
    if (end - at >= 8 && is_ascii()) {
      at += 8;
    } else {
      count -= (code(*at++) & 0xC0U) == 0x80U ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

std::uint64_t column_after(std::string_view text, std::uint64_t column) {
  if (text.find('\n') != std::string_view::npos) {
    text.remove_prefix(text.rfind('\n') + 1);
    column = 1;
  }
  return column + count_characters(text);
}

std::size_t find_invalid_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_size(text.substr(at));
    if (size == 0) return at;
    at += size;
  }
  return std::string_view::npos;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  const ShownText shown = shown_text(text, longest, true);
  return "\"" + shown.text + (shown.is_cut ? "…\"" : "\"");
}

std::string printable(std::string_view text) { return shown_text(text, text.size(), true).text; }

std::string in_message(std::string_view text) {
  constexpr std::size_t longest = 16'000, longest_word = 100;
  const std::string all = printable(text);
  if (all.size() <= longest) return all;
  std::string shown;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(' ', at), all.size() - 1) + 1;
    const std::string_view word = std::string_view(all).substr(at, end - at);
    shown += word.size() > longest_word ? without_middle(word, 40, 20) : std::string(word);
    at = end;
  }
  return shown.size() > longest ? without_middle(shown, 1'000, 500) : shown;
}

std::string in_one_line(std::string_view text) { return shown_text(text, text.size(), false).text; }

}  // namespace tcb
