// Samples: someone's rows with the precision of their numbers, all of them or a few that stand for them.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/pairs.hpp"
#include "compare/precision.hpp"
#include "compare/sides.hpp"

namespace tcb::compare {

/// Rows of a curve.
struct Sample {
  const KeptCurve* curve;
  Rows rows;
  std::vector<std::uint64_t> numbers;  ///< of these rows, from 1
  std::vector<Allowance> allowances;   ///< of each compared column, row after row
};

/// All rows.
std::vector<Sample> samples_of(std::vector<Pair> pairs, const Sides& sides);

std::uint64_t count_rows(const std::vector<Sample>& samples);

/// Rows that stand for all, spread evenly, and where there are many keys, on the first ones alone.
struct Few {
  std::vector<Sample> samples;
  std::vector<KeptCurve> curves;  ///< the first keys of those that the samples are of
  bool all = false;               ///< they are all there is
};

/// A thousand rows, on 256 keys where the curve is open and has times, so that its beginning is a curve too.
Few few_of(const std::vector<Sample>& samples, const Sides& sides, bool open);

}  // namespace tcb::compare
