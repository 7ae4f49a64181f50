// Allowances: how far given numbers may be off by rounding, printing and single precision.
#pragma once

#include <span>
#include <vector>

#include "check/inputs.hpp"
#include "check/pairs.hpp"

namespace tcb {

/// How far a number may be from the exact one.
struct Allowance {
  double rounding = 0;  ///< in any program that computes with doubles
  double most = 0;      ///< also by printed digits and single precision, where these can be the reason
};

/// Allowances for the numbers of one column. Rounding: 2^-40 of the largest number of the column or of the keys,
/// `size`. Printed digits: a unit in the last place that the column shows, in decimals or in significant digits.
/// Single precision: 2^-20 of the largest, if no number has more than nine digits or all are in single precision.
std::vector<Allowance> allowances(std::span<const double> column, double size);

/// Given rows of a curve, and how far their numbers may be off.
struct GivenSamples {
  const KeptKeys* curve;
  SampleRows rows;
  std::vector<Allowance> allowances;  ///< of each compared column, row after row
};

std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& inputs);

}  // namespace tcb
