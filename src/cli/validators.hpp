// Validators: from the text of an option's value to its type, or the error that says what was expected.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "app/job.hpp"
#include "error.hpp"

namespace tcb {

/// All throw Error (usage) for other texts; the caller adds the option.

/// Above 0: a decimal or a ratio of two.
Rational positive_ratio(const std::string& text);
/// The step of a rate.
Rational step_of_rate(const std::string& text);
/// A decimal or a ratio of two.
Rational ratio(const std::string& text);
/// Numbers separated by commas.
std::vector<Rational> ratios(const std::string& text);
/// The same, or for @FILE the numbers in that file, as one text separated by commas.
std::string listed_numbers(const std::string& text);
/// In digits, from 1 to 2^63 - 1.
std::uint64_t positive_count(const std::string& text);
/// A whole number from `least` to `most`, also as 1e9.
std::uint64_t count_between(const std::string& text, std::uint64_t least, std::uint64_t most);
/// In digits alone.
int digit_count(const std::string& text, int least);
double positive_distance(const std::string& text);
/// "1e-9", "x=1e-6", or several separated by commas.
std::vector<Tolerance> tolerances(const std::string& text);
char delimiter(const std::string& text);
char decimal_mark(const std::string& text);
spline::Tcb<double> tcb_values(const std::string& text);
/// Columns by name or number, separated by commas.
std::vector<std::string> column_list(const std::string& text);
/// Indices into fields(), each once.
std::vector<std::size_t> field_list(const std::string& text);
/// A part of a file's name.
std::string name_part(const std::string& text);
FormatId input_format(const std::string& text);
FormatId output_format(const std::string& text);

/// The names of a table's rows, of the formats that can be read or written, and of the fields.
template <const auto& table>
std::vector<std::string_view> names_in() {
  std::vector<std::string_view> names;
  std::ranges::transform(table, std::back_inserter(names), [](const auto& row) { return row.name; });
  return names;
}
std::vector<std::string_view> input_format_names();
std::vector<std::string_view> output_format_names();
std::vector<std::string_view> field_names();

/// The row of a table by its name. Throws: Error (usage) with the nearest known name.
template <class Table>
const auto& named_row(const Table& table, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.name == name; });
  if (found != std::ranges::end(table)) return *found;
  std::vector<std::string> known;
  for (const auto& row : table) known.emplace_back(row.name);
  throw Error(Exit::usage, ErrorCode::unknown_name, {std::string(name), known});
}

}  // namespace tcb
