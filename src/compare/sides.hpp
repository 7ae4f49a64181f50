// The two sides of a comparison: keys, and someone's samples of their curves.
#pragma once

#include <string>
#include <vector>

#include "compare/columns.hpp"
#include "compare/kept.hpp"
#include "compare/table.hpp"
#include "error.hpp"

namespace tcb {

struct ComparisonInputs {
  KeptCurves kept;
  SampleTable table;
  MatchedColumns columns;
  std::string keys, file;  ///< their names for messages
  unsigned threads = 1;

  /// The column that says where the samples are.
  std::string place_name() const { return columns.by_length ? "s" : kept.input.time; }
};

/// Reads both, and finds which columns are the same; `fields` as match_columns takes them.
/// Throws: Error, naming the file that is not as it should be.
ComparisonInputs read_sides(const Job& plan, const std::vector<std::size_t>& fields);

}  // namespace tcb
