// Distance: how far a number is from the computed one, in three measures, and the limits for them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "check/compare_job.hpp"

namespace tcb {

/// The distance of a given number from the computed one; a missing number is NaN.
struct Distance {
  double abs = 0;         ///< |given - computed|; infinite beyond the range of doubles, or if one of them is missing
  double rel = 0;         ///< abs / |computed|; infinite if only the computed number is 0
  std::uint64_t ulp = 0;  ///< number of steps between neighbouring doubles; 0 and -0 are equal
};

/// Two missing numbers are equal.
Distance distance(double given, double computed);

/// Limits of a column: a number is accepted if it is within any of those given.
struct Limits {
  std::optional<double> abs, rel, ulp;

  bool admit(const Distance& distance) const;
};

/// For each measure the column's own tolerance, else the one for all columns. Without any, only equal numbers are
/// accepted.
Limits limits_of(const Comparison& comparison, const std::string& column);

}  // namespace tcb
