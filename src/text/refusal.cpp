// What is said of a text that is refused: the text in quotes, what was expected, and the remedy.
#include "text/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/parse_number.hpp"

namespace tcb {
namespace {

unsigned code(char c) { return static_cast<unsigned char>(c); }

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

std::string foreign_byte(char byte) {
  return fmt::format("the byte {:02X} is no UTF-8; expected UTF-8; convert the text, for example with iconv",
                     code(byte));
}

}  // namespace tcb
