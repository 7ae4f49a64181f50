// Errors of comparisons, in the order of the work.
#include "check/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error samples_have_same_column(std::string_view name) {
  return {Exit::data, fmt::format("two columns are called \"{}\"; expected different names; rename one", name)};
}

Error samples_without_places(const std::vector<std::string>& columns, std::string_view time) {
  return {Exit::data, fmt::format("there is no column of times or arc lengths: the columns are {}; expected \"{}\", or "
                                  "\"s\" for arc lengths; add such a column, or rename one",
                                  listed(columns), time)};
}

Error nothing_to_compare(const std::vector<std::string>& columns, const std::vector<std::string>& known) {
  return {Exit::data, fmt::format("there is nothing to compare: the columns are {}; expected some of {}; rename the "
                                  "columns",
                                  listed(columns), listed(known))};
}

Error unnamed_sample_columns(std::size_t columns, const std::vector<std::string>& expected) {
  return {Exit::data, fmt::format("there are {} columns without names; expected {}: {}; name the columns in a first "
                                  "row, or list their fields with {}",
                                  columns, expected.size(), listed(expected), option::fields)};
}

Error fields_without_places() {
  return {Exit::usage,
          "the fields give no times or arc lengths; expected the field time or s; add it at the position of its "
          "column"};
}

Error tolerance_of_unknown_column(std::string_view column, const std::vector<std::string>& compared) {
  return {Exit::usage, fmt::format("no column {} is compared; expected one of {}{}", in_quotes(column),
                                   listed(compared), did_you_mean(column, compared))};
}

Error no_position_column(const std::vector<std::string>& channels) {
  return {Exit::data, fmt::format("there is no column of positions; expected at least one of {}; rename a column, or "
                                  "add one",
                                  listed(channels))};
}

Error no_row_on_curve(std::span<const std::string> problems) {
  Error error(Exit::data,
              "no row is on the curve of the keys; expected at least one row; give samples of the same curve");
  for (const std::string& problem : problems) error.add({Exit::data, problem});
  return error;
}

Error no_number_in_samples() {
  return {Exit::data, "no row has a number to compare; expected at least one; give other samples"};
}

}  // namespace tcb
