// Distances between two numbers in three measures, and what is admitted of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/job.hpp"

namespace tcb {

/// How far a number is from ours; a missing number is not a number.
struct Distance {
  double abs = 0;         ///< |theirs - ours|; infinite beyond the range of doubles, or where one of them is missing
  double rel = 0;         ///< abs / |ours|; infinite where ours alone is 0
  std::uint64_t ulp = 0;  ///< how many doubles further it is; 0 and -0 are one
};

/// Two missing numbers are equal.
Distance distance(double theirs, double ours);

/// What is admitted in a column: any of the three that are there.
struct Limits {
  std::optional<double> abs, rel, ulp;

  bool admit(const Distance& distance) const;
};

/// The limits of a column: for each measure its own, else the one for all columns; equality where there is none.
Limits limits_of(const Comparison& comparison, const std::string& column);

}  // namespace tcb
