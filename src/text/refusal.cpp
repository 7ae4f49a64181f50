// What is said of a text that is refused: the text in quotes, what was expected, and the remedy.
#include "text/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/number.hpp"

namespace tcb {
namespace {

unsigned code(char c) { return static_cast<unsigned char>(c); }

/// How many bytes the character at the beginning has; 0 where it is no character of UTF-8.
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

/// The text with a point where it has a comma.
std::string with_point(std::string_view text) {
  std::string changed(text);
  std::ranges::replace(changed, ',', '.');
  return changed;
}

/// Several numbers, apart by blanks.
bool is_several_numbers(std::string_view text) {
  const std::size_t blank = text.find_first_of(" \t");
  return blank != std::string_view::npos && parse_number(with_point(text.substr(0, blank))).has_value();
}

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_size(text.substr(at));
    if (at + std::max<std::size_t>(size, 1) > longest) return out + "…\"";
    const bool visible = size > 1 || (size == 1 && code(text[at]) >= 0x20 && code(text[at]) != 0x7F);
    out += visible ? std::string(text.substr(at, size)) : fmt::format("\\x{:02X}", code(text[at]));
    at += std::max<std::size_t>(size, 1);
  }
  return out + "\"";
}

std::string no_number(std::string_view cell, char decimal) {
  if (is_missing(cell)) {
    return fmt::format("{} where a number was expected; fill it in, or give --missing skip-row, skip-cell or break",
                       cell.empty() ? "an empty cell" : shown(cell));
  }
  if (looks_numeric(cell) || (decimal != '.' && looks_numeric(with_point(cell)))) {
    if (decimal != '.' && cell.find('.') != std::string_view::npos) {
      return fmt::format("{} has a point; expected a decimal comma; correct the cell, or take --decimal out",
                         shown(cell));
    }
    return fmt::format("{} is not a finite double; expected less than 1.8e308 in size; correct the cell", shown(cell));
  }
  if (decimal == '.' && cell.find(',') != std::string_view::npos && parse_number(with_point(cell))) {
    return fmt::format("{} is not a number; expected a decimal point; give --decimal , if this is a decimal comma",
                       shown(cell));
  }
  if (is_several_numbers(cell)) {
    return fmt::format("{} is not a number; expected one in each cell; give the delimiter with -d", shown(cell));
  }
  return fmt::format("{} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell", shown(cell));
}

std::size_t find_foreign(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_size(text.substr(at));
    if (size == 0) return at;
    at += size;
  }
  return std::string_view::npos;
}

std::string foreign_byte(char byte) {
  return fmt::format("the byte {:02X} is no UTF-8; expected UTF-8; convert the text, for example with iconv",
                     code(byte));
}

std::string in_one_line(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool control = code < 0x20 || code == 0x7F;
    shown += control ? fmt::format("\\x{:02X}", code) : std::string(1, c);
  }
  return shown;
}

}  // namespace tcb
