// Invalid numbers: why a cell of delimited text is not a number.
#include "read/csv/invalid_number.hpp"

#include <algorithm>
#include <string>

#include "numbers/parse_number.hpp"
#include "read/csv/errors.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// The text with a point where it has a comma.
std::string with_point(std::string_view text) {
  std::string changed(text);
  std::ranges::replace(changed, ',', '.');
  return changed;
}

/// The text with a point for each comma, and the other way round, without blanks between digits.
std::string with_marks_exchanged(std::string_view text) {
  std::string changed(text);
  for (char& c : changed) c = c == ',' ? '.' : c == '.' || c == ' ' ? ',' : c;
  return changed;
}

}  // namespace

bool has_thousands_separators(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  const auto groups = split(text.substr(0, text.find('.')), ',');
  const bool is_fraction = text.starts_with('0');  // as in 0,125
  if (groups.size() < 2 || groups[0].empty() || groups[0].size() > 3 || is_fraction) return false;
  if (std::any_of(groups.begin() + 1, groups.end(), [](std::string_view group) { return group.size() != 3; }))
    return false;
  std::string digits(text);
  std::erase(digits, ',');
  return digits.find_first_not_of(".0123456789") == std::string::npos && parse_number(digits);
}

Error why_not_number(std::string_view column, std::string_view cell, char decimal) {
  if (looks_numeric(cell) || (decimal != '.' && looks_numeric(with_point(cell)))) {
    const bool has_point = decimal != '.' && cell.find('.') != std::string_view::npos;
    return has_point ? number_with_decimal_point(column, cell) : number_beyond_doubles(column, cell);
  }
  const bool has_comma = decimal == '.' && cell.find(',') != std::string_view::npos;
  if (decimal == ',' && has_thousands_separators(with_marks_exchanged(cell))) {
    return number_with_thousands_points(column, cell);
  }
  if (has_comma && has_thousands_separators(cell)) return number_with_thousands(column, cell);
  if (has_comma && parse_number(with_point(cell))) return number_with_decimal_comma(column, cell);
  const std::size_t blank = cell.find_first_of(" \t");
  const bool several = blank != std::string_view::npos && parse_number(with_point(cell.substr(0, blank)));
  return several ? several_numbers_in_cell(column, cell) : cell_is_not_a_number(column, cell);
}

}  // namespace tcb
