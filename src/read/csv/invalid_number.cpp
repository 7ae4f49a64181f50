// Invalid numbers: why a cell of delimited text is not a number.
#include "read/csv/invalid_number.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "numbers/parse_number.hpp"
#include "option_names.hpp"
#include "schema/usual_names.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error number_with_marks(std::string_view column, std::string_view cell, char decimal, char thousands) {
  const bool has_comma = decimal == ',' && cell.find(',') != std::string_view::npos;
  const std::string also = has_comma ? fmt::format("{} , ", option::decimal) : "";
  return {Exit::data,
          fmt::format("{}: {} is not a number; expected one without thousands separators; remove them, or give {}{} {}",
                      column, in_quotes(cell), also, option::thousands,
                      thousands == ' '    ? "space"
                      : thousands == '\'' ? "apostrophe"
                      : thousands == '_'  ? "underscore"
                                          : std::string(1, thousands))};
}

/// The text with a point where it has a comma.
std::string with_point(std::string_view text) {
  std::string changed(text);
  std::ranges::replace(changed, ',', '.');
  return changed;
}

/// Marks of numbers in spreadsheets and in texts for people, besides a decimal point alone.
constexpr std::array other_marks{NumberMarks{'.', ','},  NumberMarks{',', 0},    NumberMarks{',', '.'},
                                 NumberMarks{',', ' '},  NumberMarks{'.', '\''}, NumberMarks{'.', ' '},
                                 NumberMarks{',', '\''}, NumberMarks{'.', '_'},  NumberMarks{',', '_'}};

/// The marks with which the text is a number.
std::optional<NumberMarks> marks_of(std::string_view text) {
  const auto* const found = std::ranges::find_if(
      other_marks, [&](const NumberMarks& marks) { return Decimals(marks).number(text).has_value(); });
  return found == other_marks.end() ? std::nullopt : std::optional(*found);
}

/// Whether a text begins with a date such as 31.12.24 or 1/2/24.
bool has_short_year(std::string_view text) {
  std::array<std::size_t, 3> sizes{};
  char mark = 0;
  std::size_t part = 0;
  for (const char c : text) {
    const bool is_mark = c == '.' || c == '/' || c == '-';
    if (c >= '0' && c <= '9') {
      ++sizes[part];
    } else if (is_mark && part < 2 && (mark == 0 || c == mark)) {
      mark = c;
      ++part;
    } else {
      break;
    }
  }
  return part == 2 && sizes[0] > 0 && sizes[0] <= 2 && sizes[1] > 0 && sizes[1] <= 2 && sizes[2] == 2;
}

/// Whether a number is followed by the letter of a hemisphere, which is no unit: 26.9W is -26.9.
bool has_hemisphere(std::string_view cell) {
  const std::size_t end = cell.find_first_not_of("0123456789.,+- ");
  return end > 0 && end != std::string_view::npos && end + 1 == cell.size() &&
         std::string_view("NSEW").find(cell[end]) != std::string_view::npos;
}

}  // namespace

bool has_thousands_separators(std::string_view text) {
  if (text.find_first_of("0123456789") == std::string_view::npos) return false;
  const std::optional<NumberMarks> marks = marks_of(text);
  return marks && marks->thousands != 0 && !parse_number(text);
}

std::string_view without_unit_of_number(std::string_view cell) {
  if (has_hemisphere(cell)) return cell;
  const std::size_t last = cell.find_last_of("0123456789.");
  // The digit of a unit such as m/s2 is no part of the number.
  const std::size_t end = cell.find_first_not_of("0123456789.,+-eE'_ ");
  if (last == std::string_view::npos || end == std::string_view::npos || end == 0) return cell;
  std::size_t size = end;
  while (size > 0 && (cell[size - 1] == ' ' || cell[size - 1] == '\t')) --size;
  return size > 0 && is_unit(cell.substr(end)) ? cell.substr(0, size) : cell;
}

Error why_not_number(std::string_view column, std::string_view cell, const NumberMarks& marks) {
  if (looks_numeric(cell) || (marks.decimal != '.' && looks_numeric(with_point(cell)))) {
    const bool has_point = marks.decimal != '.' && cell.find('.') != std::string_view::npos;
    if (has_point && Decimals({',', '.'}).number(cell)) {
      return data_error(
          "{}: {} has a decimal point; expected a decimal comma; correct the cell, give {} . if the point divides "
          "thousands, or remove {}",
          column, in_quotes(cell), option::thousands, option::decimal);
    }
    return has_point
               ? data_error("{}: {} has a decimal point; expected a decimal comma; correct the cell, or remove {}",
                            column, in_quotes(cell), option::decimal)
               : number_beyond_doubles(column, cell);
  }
  if (const std::optional<NumberMarks> other = marks_of(cell); other && *other != marks) {
    const bool is_fraction = Decimals({','}).number(cell).has_value();
    if (other->thousands == 0)
      return data_error(
          "{}: {} is not a number; expected a decimal point; give {} , if this is a decimal "
          "comma",
          column, in_quotes(cell), option::decimal);
    return is_fraction && marks.decimal == '.'
               ? data_error(
                     "{}: {} is not a number; expected one without thousands separators; remove them, or "
                     "give {} , if the comma divides thousands, or {} , if it is a decimal comma",
                     column, in_quotes(cell), option::thousands, option::decimal)
               : number_with_marks(column, cell, other->decimal == marks.decimal ? '\0' : other->decimal,
                                   other->thousands);
  }
  if (has_short_year(cell)) {
    return data_error(
        "{}: {} is a date with a year of two digits, whose century is unknown; expected a year of four digits; write "
        "the years in full",
        column, in_quotes(cell));
  }
  if (has_hemisphere(cell)) {
    return data_error(
        "{}: {} is a number with the letter of a hemisphere or of a unit; expected a number alone; remove the letter, "
        "and write south and west as negative numbers",
        column, in_quotes(cell));
  }
  const std::string_view number = without_unit_of_number(cell);
  if (number.size() < cell.size() && (Decimals(marks).number(number) || marks_of(number))) {
    return data_error("{}: {} is a number with a unit; expected a number alone; remove the unit, or give {} strip",
                      column, in_quotes(cell), option::units);
  }
  const bool may_be_time = cell.find(':') != std::string_view::npos && cell[0] >= '0' && cell[0] <= '9';
  if (may_be_time) {
    return data_error(
        "{}: {} is no number, and no time in a known notation; expected a number, or a time such as "
        "2024-03-01T13:00:00Z or 13:00:00, with hours from 0 to 23; convert the cells",
        column, in_quotes(cell));
  }
  const std::size_t blank = cell.find_first_of(" \t");
  const bool several = blank != std::string_view::npos && parse_number(with_point(cell.substr(0, blank)));
  return several ? data_error("{}: {} is not a number; expected one number in each cell; give the delimiter with {}",
                              column, in_quotes(cell), option::delimiter)
                 : data_error("{}: {} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell",
                              column, in_quotes(cell));
}

Error number_beyond_doubles(std::string_view column, std::string_view cell) {
  return data_error(
      "{}: {} is not a finite double; expected less than 1.8e308 in size; correct "
      "the cell",
      column, in_quotes(cell));
}

}  // namespace tcb
