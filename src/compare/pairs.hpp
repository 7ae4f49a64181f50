// Pairs: which of someone's rows are samples of which curve.
#pragma once

#include <string>
#include <vector>

#include "compare/kept.hpp"
#include "compare/table.hpp"

namespace tcb::compare {

struct Pair {
  const KeptCurve* curve;
  Rows rows;
};

struct Pairs {
  std::vector<Pair> pairs;
  std::vector<std::string> problems;  ///< curves without rows, rows without a curve
};

/// By what tells the curves apart where both have it, else by their order; all rows for a single curve.
Pairs pair_up(const KeptCurves& kept, Table& table);

}  // namespace tcb::compare
