// Problems: why a comparison fails besides the numbers, as lines of its report; one function for each.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

std::string columns_missing(const std::vector<std::string>& names);
std::string columns_of_no_field(const std::vector<std::string>& names);
/// `curve`: NAME=VALUE for each column of its group.
std::string curve_without_rows(const std::vector<std::string>& curve);
std::string rows_without_curve(const std::vector<std::string>& curve, std::uint64_t line);
/// `compared`: of both.
std::string curve_counts_differ(std::uint64_t in_rows, std::uint64_t in_keys, std::uint64_t compared);
std::string rows_without_place(std::uint64_t rows, std::uint64_t first_line);
/// `place`: the time or the arc length of the first of the rows; `nearest`: the end of the curve that is nearest to it.
std::string rows_off_curve(std::uint64_t rows, std::uint64_t first_line, bool by_length, std::string_view place,
                           std::string_view nearest);

/// How the rows of a curve differ from those that are expected.
struct RowCounts {
  std::uint64_t expected = 0, found = 0;
  std::uint64_t missing = 0;       ///< expected, but not found
  std::uint64_t surplus = 0;       ///< found, but not expected
  std::uint64_t surplus_line = 0;  ///< of the first of these
  // Times or arc lengths:
  std::string first_missing = {}, first_surplus = {}, last_found = {};
};

std::string rows_not_as_expected(const RowCounts& counts);

/// A problem, as one of a curve if that has a name.
std::string of_curve(const std::vector<std::string>& curve, const std::string& problem);

}  // namespace tcb
