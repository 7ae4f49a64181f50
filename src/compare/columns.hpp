// Columns: which column of someone's samples is which number of a row of ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/table.hpp"
#include "format/input.hpp"

namespace tcb::compare {

/// A column that both have.
struct Column {
  std::string name;
  std::size_t theirs;  ///< index into Table::columns
  std::size_t ours;    ///< index into the cells of a row with the chosen fields
};

struct Columns {
  std::vector<std::size_t> fields;  ///< indices into fields(), whose cells make a row of ours
  std::vector<Column> compared;
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
Columns match_columns(const Table& table, const format::Input& keys, const std::vector<std::size_t>& given);

}  // namespace tcb::compare
