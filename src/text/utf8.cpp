// UTF-8: decoding as far as validity needs it, and escaping.
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <cstring>

namespace tcb {
namespace {

unsigned code(char c) { return static_cast<unsigned char>(c); }

bool is_control(char c) { return code(c) < 0x20 || code(c) == 0x7F; }

std::string escaped(char c) { return fmt::format("\\x{:02X}", code(c)); }

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

/// The number of bytes that begin a character; those after its first are 10xxxxxx. Eight bytes at a time.
std::uint64_t count_characters(std::string_view text) {
  std::uint64_t count = text.size();
  for (; text.size() >= sizeof(std::uint64_t); text.remove_prefix(sizeof(std::uint64_t))) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, text.data(), sizeof bytes);
    constexpr std::uint64_t ones = 0x0101010101010101;
    count -= (bytes >> 7 & ~(bytes >> 6) & ones) * ones >> 56;  // the sum of eight bytes of 0 or 1
  }
  for (const char c : text) count -= (code(c) & 0xC0U) == 0x80U ? 1 : 0;
  return count;
}

}  // namespace

std::uint64_t column_after(std::string_view text, std::uint64_t column) {
  const std::size_t last = text.rfind('\n');
  if (last != std::string_view::npos) {
    text.remove_prefix(last + 1);
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
  std::string out = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_size(text.substr(at));
    if (at + std::max<std::size_t>(size, 1) > longest) return out + "…\"";
    const bool printable = size > 1 || (size == 1 && !is_control(text[at]));
    out += printable ? std::string(text.substr(at, size)) : escaped(text[at]);
    at += std::max<std::size_t>(size, 1);
  }
  return out + "\"";
}

std::string in_one_line(std::string_view text) {
  std::string out;
  for (const char c : text) out += is_control(c) ? escaped(c) : std::string(1, c);
  return out;
}

}  // namespace tcb
