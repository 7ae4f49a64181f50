// MatchedColumns: which column of someone's samples is which number of a row of ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/table.hpp"
#include "input/input.hpp"

namespace tcb {

/// A column that both have.
struct MatchedColumn {
  std::string name;
  std::size_t theirs;  ///< index into SampleTable::columns
  std::size_t ours;    ///< index into the cells of a row with the chosen fields
};

struct MatchedColumns {
  std::vector<std::size_t> fields;  ///< indices into fields(), whose cells make a row of ours
  std::vector<MatchedColumn> compared;
  std::optional<std::size_t> place;   ///< the column of theirs that says where the samples are, if not the times
  bool by_length = false;             ///< and these are arc lengths
  std::vector<std::string> ignored;   ///< columns that are not compared, with good reason
  std::vector<std::string> problems;  ///< what is missing or not known, in words
};

/// Index into fields(). Requires: a name that is there.
std::size_t field_of(std::string_view name);

/// The fields are the given ones, or where there are none, those whose columns the table names. A table without names
/// has the columns of the given fields, or else the time and the positions.
/// Throws: Error (data) where nothing can be compared.
MatchedColumns match_columns(const SampleTable& table, const Input& keys, const std::vector<std::size_t>& given);

}  // namespace tcb
