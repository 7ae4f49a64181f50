// Invalid numbers: why a cell of delimited text is not a number.
#include "read/csv/invalid_number.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "numbers/parse_number.hpp"
#include "read/csv/errors.hpp"

namespace tcb {
namespace {

/// The text with a point where it has a comma.
std::string with_point(std::string_view text) {
  std::string changed(text);
  std::ranges::replace(changed, ',', '.');
  return changed;
}

/// Marks of numbers in spreadsheets and in texts for people, besides a decimal point alone.
constexpr std::array other_marks{NumberMarks{'.', ','}, NumberMarks{',', 0},    NumberMarks{',', '.'},
                                 NumberMarks{',', ' '}, NumberMarks{'.', '\''}, NumberMarks{'.', ' '},
                                 NumberMarks{',', '\''}};

/// The marks with which the text is a number.
std::optional<NumberMarks> marks_of(std::string_view text) {
  const auto* const found = std::ranges::find_if(
      other_marks, [&](const NumberMarks& marks) { return Decimals(marks).number(text).has_value(); });
  return found == other_marks.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

bool has_thousands_separators(std::string_view text) {
  const std::optional<NumberMarks> marks = marks_of(text);
  return marks && marks->thousands != 0 && !parse_number(text);
}

Error why_not_number(std::string_view column, std::string_view cell, const NumberMarks& marks) {
  if (looks_numeric(cell) || (marks.decimal != '.' && looks_numeric(with_point(cell)))) {
    const bool has_point = marks.decimal != '.' && cell.find('.') != std::string_view::npos;
    return has_point ? number_with_decimal_point(column, cell) : number_beyond_doubles(column, cell);
  }
  if (const std::optional<NumberMarks> other = marks_of(cell); other && *other != marks) {
    const bool is_fraction = Decimals({','}).number(cell).has_value();
    if (other->thousands == 0) return number_with_decimal_comma(column, cell);
    return is_fraction && marks.decimal == '.'
               ? number_with_thousands(column, cell)
               : number_with_marks(column, cell, other->decimal == marks.decimal ? '\0' : other->decimal,
                                   other->thousands);
  }
  const std::size_t blank = cell.find_first_of(" \t");
  const bool several = blank != std::string_view::npos && parse_number(with_point(cell.substr(0, blank)));
  return several ? several_numbers_in_cell(column, cell) : cell_is_not_a_number(column, cell);
}

}  // namespace tcb
