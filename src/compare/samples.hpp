// Samples: someone's rows with the precision of their numbers, all of them or a few that stand for them.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/pairs.hpp"
#include "compare/precision.hpp"
#include "compare/sides.hpp"

namespace tcb {

/// SampleRows of a curve.
struct GivenSamples {
  const KeptCurve* curve;
  SampleRows rows;
  std::vector<std::uint64_t> numbers;  ///< of these rows, from 1
  std::vector<Allowance> allowances;   ///< of each compared column, row after row
};

/// All rows.
std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& sides);

std::uint64_t count_rows(const std::vector<GivenSamples>& samples);

/// SampleRows that stand for all, spread evenly, and where there are many keys, on the first ones alone.
struct Subset {
  std::vector<GivenSamples> samples;
  std::vector<KeptCurve> curves;  ///< the first keys of those that the samples are of
  bool all = false;               ///< they are all there is
};

/// A thousand rows, on 256 keys where the curve is open and has times, so that its beginning is a curve too.
Subset few_of(const std::vector<GivenSamples>& samples, const ComparisonInputs& sides, bool open);

}  // namespace tcb
