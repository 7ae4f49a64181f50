// Matched columns: which columns of a file of samples are compared with which cells of the curve's rows.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check/sample_table.hpp"
#include "sample/fields.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// A column of the samples that is also one of the curve's rows.
struct MatchedColumn {
  std::string name;
  std::size_t given;     ///< index into SampleTable::columns
  std::size_t computed;  ///< index into the cells of a row with the chosen fields
};

struct MatchedColumns {
  std::vector<std::size_t> fields;  ///< indices into fields(), whose cells make a row of the curve
  std::vector<MatchedColumn> compared;
  std::vector<std::array<std::size_t, 4>> rotations = {};  ///< indices into compared, of the numbers of each
  std::vector<std::pair<std::size_t, bool>> angles = {};   ///< index into compared, and whether it is in degrees
  std::optional<std::size_t> place;   ///< index into SampleTable::columns: the places of the samples, if not the times
  bool by_length = false;             ///< the places are arc lengths
  std::vector<std::string> ignored;   ///< names of columns that are intentionally not compared
  std::vector<std::string> problems;  ///< of columns that are missing or unknown

  /// Negates computed quaternions and turns computed angles by whole turns where that is nearer to the given row, as
  /// these are the same.
  void align(std::span<Cell> computed, std::span<const double> given_row) const;
};

/// Matches columns with the given fields, or if none are given, with all fields whose columns the table names. A
/// table without names has the columns of the given fields, or else the time and the positions.
/// Throws: Error (data) if nothing can be compared.
MatchedColumns match_columns(const SampleTable& table, const Schema& keys, const std::vector<std::size_t>& given);

/// How many columns the fields have before the time; nothing: the time is not among them.
std::optional<std::size_t> columns_before_time(const std::vector<std::size_t>& fields, const Schema& keys);

}  // namespace tcb
