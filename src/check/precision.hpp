// Precision: the errors of rounding and printing, and the choice of rows that represent many.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "check/check.hpp"
#include "check/conventions.hpp"
#include "check/inputs.hpp"

namespace tcb {

/// Why a number may differ from the exact one, from the finest to the coarsest.
enum class Precision : std::uint8_t { rounding, printed_digits, single };
inline constexpr std::size_t precisions = 3;

/// How far a number may be off for each precision; 0 if that cannot be the reason.
using Allowance = std::array<double, precisions>;

/// Allowances for the numbers of one column. Rounding: 2^-40 of the largest number of the column or of the keys,
/// `size`. Printed digits: a unit in the last place that the column shows, in decimals or in significant digits.
/// Single: 2^-20 of the largest, if no number has more than nine digits or all are in single precision.
std::vector<Allowance> allowances(std::span<const double> column, double size);

/// Given rows of a curve, and the precision of their numbers.
struct GivenSamples {
  const KeptKeys* curve;
  SampleRows rows;
  std::vector<std::uint64_t> numbers;  ///< of these rows, from 1
  std::vector<Allowance> allowances;   ///< of each compared column, row after row
};

std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& inputs);

std::uint64_t count_rows(const std::vector<GivenSamples>& samples);

/// An evenly spread subset of all rows; if there are many keys, of the rows on the first keys.
struct Subset {
  std::vector<GivenSamples> samples;
  std::vector<KeptKeys> curves;  ///< the first keys of the curves that were cut
  bool all = false;              ///< it has all rows
};

/// At most 1,000 rows, fewer if several curves of rotations are tried, on 256 keys if the curve is open and has times,
/// so that its beginning is also a curve.
Subset subset_of(const std::vector<GivenSamples>& samples, const ComparisonInputs& inputs, const ComparedParts& parts);

}  // namespace tcb
