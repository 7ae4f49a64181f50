// Errors of delimited text: delimiter, header, records, and cells. A column is shown by its name, or as "column 3".
#include "read/csv/errors.hpp"

#include <fmt/format.h>

#include <string>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// A cell without a number, as the beginning of a sentence shows it.
std::string missing_cell(std::string_view cell) { return cell.empty() ? "an empty cell" : in_quotes(cell); }

}  // namespace

Error decimal_comma_is_delimiter() {
  return {Exit::data,
          fmt::format("the comma is both the decimal mark and the delimiter; expected different characters; "
                      "give another delimiter with {}, or remove {}",
                      option::delimiter, option::decimal)};
}

Error other_delimiter_likely(char delimiter, char likely_delimiter) {
  const bool is_control = likely_delimiter < ' ';
  const std::string argument = likely_delimiter == '|' ? "pipe"
                               : is_control ? fmt::format("$'\\x{:02X}'", static_cast<unsigned>(likely_delimiter))
                                            : fmt::format("'{}'", likely_delimiter);
  return {Exit::data,
          fmt::format("the rows have no delimiter {}, but each has {}; expected cells between delimiters; "
                      "give {} {}",
                      in_quotes({&delimiter, 1}), in_quotes({&likely_delimiter, 1}), option::delimiter, argument)};
}

Error empty_input() {
  return {Exit::data, fmt::format("the input is empty; expected a row for each key; see {}", option::help)};
}

Error empty_samples() { return {Exit::data, "the file is empty; expected samples; give the file that has them"}; }

Error samples_header_unclear(std::string_view text_cell, std::string_view number_cell) {
  return {Exit::data, fmt::format("the first record has both text, {}, and a number, {}; expected only names or only "
                                  "numbers; add a line of names above it, or remove the text",
                                  in_quotes(text_cell), in_quotes(number_cell))};
}

Error header_without_rows() {
  return {Exit::data, fmt::format("no row follows the header; expected a row for each key; see {}", option::help)};
}

Error lines_end_in_carriage_returns() {
  return {Exit::data,
          "the input is a single line that contains carriage returns; expected a line for each key; "
          "change them to line feeds, as in tr '\\r' '\\n'"};
}

Error header_unclear(std::string_view text_cell, std::string_view number_cell) {
  return {Exit::data, fmt::format("the first record has both text, {}, and a number, {}; expected only names or only "
                                  "numbers; give {} if they are names, {} if they are not",
                                  in_quotes(text_cell), in_quotes(number_cell), option::header, option::no_header)};
}

Error row_unlike_header(std::size_t cells, std::size_t names) {
  return {Exit::data, fmt::format("the number of cells in the first row is {}, but {} in the header; expected the same "
                                  "number; correct one of them, or give the delimiter with {}",
                                  cells, names, option::delimiter)};
}

Error column_name_not_utf8(std::string_view name, char byte) {
  return {Exit::data, fmt::format("the column name {} has the byte {:02X}, which is not UTF-8; expected UTF-8; convert "
                                  "the text, for example with iconv -f WINDOWS-1252 -t UTF-8",
                                  in_quotes(name), static_cast<unsigned char>(byte))};
}

Error record_too_long() {
  return {Exit::data,
          "a record has more than 64 MiB; expected a line for each key; break the lines, or close a quote that was "
          "left open"};
}

Error too_many_cells(std::size_t most) {
  return {Exit::data,
          fmt::format("the record has more than {} cells; expected at most {}; correct the row, or give the "
                      "delimiter with {}",
                      most, most, option::delimiter)};
}

Error quote_not_closed() { return {Exit::data, "a quoted cell is not closed; expected \" at its end; add it"}; }

Error text_after_quotes() {
  return {Exit::data,
          "text follows a quoted cell; expected the delimiter or the end of the line; double the quotes inside a cell"};
}

Error wrong_number_of_cells(std::size_t cells, std::size_t expected) {
  return {Exit::data, fmt::format("the number of cells in the row is {}, but {} in the rows above; expected the same "
                                  "number; complete or correct the row, or give the delimiter with {}",
                                  cells, expected, option::delimiter)};
}

Error line_unlike_format(std::size_t cells, std::size_t expected) {
  return {Exit::data, fmt::format("the line has {} numbers; expected {}, as the format has; complete the line, or give "
                                  "another format to {}",
                                  cells, expected, option::input_format)};
}

Error cell_not_utf8(std::string_view cell, char byte) {
  return {Exit::data, fmt::format("{} has the byte {:02X}, which is not UTF-8; expected UTF-8; convert the text, for "
                                  "example with iconv -f WINDOWS-1252 -t UTF-8",
                                  in_quotes(cell), static_cast<unsigned char>(byte))};
}

Error group_is_empty(std::string_view column) {
  return {Exit::data, fmt::format("{}: found an empty cell; expected the name of a curve; fill it in, or give {} "
                                  "skip-row",
                                  column, option::missing)};
}

Error number_in_text_column(std::string_view column, std::string_view cell) {
  return {Exit::data,
          fmt::format("{}: {} is a number in a column of text; expected only numbers or only text; give the "
                      "text that stands for missing numbers to {}, or leave the column out with {} "
                      "position=NAME:NAME",
                      column, in_quotes(cell), option::na, option::columns)};
}

Error number_is_missing(std::string_view column, std::string_view cell) {
  return {Exit::data, fmt::format("{}: found {}; expected a number; fill it in, or give {} skip-row, skip-cell or "
                                  "break",
                                  column, missing_cell(cell), option::missing)};
}

Error number_of_segment_is_missing(std::string_view column, std::string_view cell) {
  return {Exit::data,
          fmt::format("{}: found {}; expected a number, as each row is a whole segment; fill it in, or remove "
                      "the row",
                      column, missing_cell(cell))};
}

Error time_is_missing(std::string_view column, std::string_view cell) {
  return {Exit::data, fmt::format("{}: found {}; expected a time; fill it in, or give {} skip-row or break", column,
                                  missing_cell(cell), option::missing)};
}

Error number_with_decimal_point(std::string_view column, std::string_view cell) {
  return {Exit::data,
          fmt::format("{}: {} has a decimal point; expected a decimal comma; correct the cell, or remove {}", column,
                      in_quotes(cell), option::decimal)};
}

Error number_with_decimal_comma(std::string_view column, std::string_view cell) {
  return {Exit::data, fmt::format("{}: {} is not a number; expected a decimal point; give {} , if this is a decimal "
                                  "comma",
                                  column, in_quotes(cell), option::decimal)};
}

Error number_with_thousands(std::string_view column, std::string_view cell) {
  return {Exit::data, fmt::format("{}: {} is not a number; expected one without thousands separators; remove them, or "
                                  "give {} , if the comma divides thousands, or {} , if it is a decimal comma",
                                  column, in_quotes(cell), option::thousands, option::decimal)};
}

Error number_with_marks(std::string_view column, std::string_view cell, char decimal, char thousands) {
  const bool has_comma = decimal == ',' && cell.find(',') != std::string_view::npos;
  const std::string also = has_comma ? fmt::format("{} , ", option::decimal) : "";
  return {Exit::data,
          fmt::format("{}: {} is not a number; expected one without thousands separators; remove them, or give {}{} {}",
                      column, in_quotes(cell), also, option::thousands,
                      thousands == ' '    ? "space"
                      : thousands == '\'' ? "apostrophe"
                                          : std::string(1, thousands))};
}

Error number_beyond_doubles(std::string_view column, std::string_view cell) {
  return {Exit::data, fmt::format("{}: {} is not a finite double; expected less than 1.8e308 in size; correct "
                                  "the cell",
                                  column, in_quotes(cell))};
}

Error several_numbers_in_cell(std::string_view column, std::string_view cell) {
  return {Exit::data,
          fmt::format("{}: {} is not a number; expected one number in each cell; give the delimiter with {}", column,
                      in_quotes(cell), option::delimiter)};
}

Error cell_is_not_a_number(std::string_view column, std::string_view cell) {
  return {Exit::data, fmt::format("{}: {} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell",
                                  column, in_quotes(cell))};
}

Error word_in_column_of_numbers(std::string_view column, std::string_view cell) {
  return {
      Exit::data,
      fmt::format("{}: {} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell, or give {} {} to "
                  "leave the column out, {} {} to keep it in the rows, or {} {} if it tells curves apart",
                  column, in_quotes(cell), option::columns, in_shell(fmt::format("ignore={}", column)), option::columns,
                  in_shell(fmt::format("carry={}", column)), option::group, in_shell(column))};
}

Error times_in_text_column(std::string_view column, std::string_view cell) {
  return {Exit::data,
          fmt::format("{} has times such as {}, but not the name of a time; give {} {} if they are the times "
                      "of the keys, or {} {} if not",
                      column, in_quotes(cell), option::columns, in_shell(fmt::format("time={}", column)),
                      option::columns, in_shell(fmt::format("ignore={}", column)))};
}

Error in_possible_text_column(const Error& error) {
  return {error.exit(),
          fmt::format("{}; or name the columns to take with {} position=NAME:NAME", error.message(), option::columns)};
}

}  // namespace tcb
