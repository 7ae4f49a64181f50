// Problems of comparisons: columns, curves, rows.
#include "check/problems.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"

namespace tcb {

std::string columns_missing(const std::vector<std::string>& names) {
  return fmt::format("columns missing: {}", listed(names));
}

std::string columns_of_no_field(const std::vector<std::string>& names) {
  return fmt::format("columns of no field: {}; give the fields to compare with {}", listed(names), option::fields);
}

std::string curve_without_rows(const std::vector<std::string>& curve) {
  return fmt::format("curve {} has no rows", listed(curve));
}

std::string rows_without_curve(const std::vector<std::string>& curve, std::uint64_t line) {
  return fmt::format("curve {} has no keys; its rows are in line {} and below", listed(curve), line);
}

std::string curve_counts_differ(std::uint64_t in_rows, std::uint64_t in_keys, std::uint64_t compared) {
  return fmt::format("number of curves: {} in the rows, {} in the keys, {} compared", in_rows, in_keys, compared);
}

std::string rows_without_place(std::uint64_t rows, std::uint64_t first_line) {
  return fmt::format("rows without a time or arc length: {}; the first is in line {}", rows, first_line);
}

std::string rows_off_curve(std::uint64_t rows, std::uint64_t first_line, bool by_length, std::string_view place,
                           std::string_view nearest) {
  return by_length ? fmt::format(
                         "rows outside the curve: {}; the first, in line {}, has arc length {}; the nearest "
                         "one of the curve is {}",
                         rows, first_line, place, nearest)
                   : fmt::format(
                         "rows outside the curve: {}; the first, in line {}, has time {}; the nearest time of "
                         "the curve is {}",
                         rows, first_line, place, nearest);
}

std::string rows_not_as_expected(const RowCounts& counts) {
  std::string text = fmt::format("rows: {} expected, {} found", counts.expected, counts.found);
  if (counts.missing > 0) text += fmt::format("; missing: {}, the first at {}", counts.missing, counts.first_missing);
  if (counts.surplus > 0) {
    text += fmt::format("; not expected: {}, the first in line {} at {}", counts.surplus, counts.surplus_line,
                        counts.first_surplus);
  }
  return text + (counts.last_found.empty() ? "" : fmt::format("; the last row found is at {}", counts.last_found));
}

std::string of_curve(const std::vector<std::string>& curve, const std::string& problem) {
  return curve.empty() ? problem : fmt::format("curve {}: {}", listed(curve), problem);
}

}  // namespace tcb
