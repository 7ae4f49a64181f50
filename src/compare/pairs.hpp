// Pairs: which of someone's rows are samples of which curve.
#pragma once

#include <string>
#include <vector>

#include "compare/kept.hpp"
#include "compare/sides.hpp"
#include "compare/table.hpp"

namespace tcb {

struct Pair {
  const KeptCurve* curve;
  SampleRows rows;
};

struct Pairs {
  std::vector<Pair> pairs;
  std::vector<std::string> problems;  ///< curves without rows, rows without a curve
};

/// By what tells the curves apart where both have it, else by their order; all rows for a single curve.
Pairs pair_up(const KeptCurves& kept, SampleTable& table);

/// What every comparison tells of its two sides.
struct Compared {
  std::string file, keys;
  bool by_length = false;             ///< the samples are at arc lengths
  std::vector<std::string> ignored;   ///< columns that were not compared, with good reason
  std::vector<std::string> problems;  ///< what is not as it should be beside the numbers
};

Compared compared(const ComparisonInputs& sides, const Pairs& pairs);

}  // namespace tcb
