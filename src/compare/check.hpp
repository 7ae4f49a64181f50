// Check: distances between given and computed numbers, limits for them, and the check of all samples.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/job.hpp"
#include "compare/inputs.hpp"

namespace tcb {

/// The distance of a given number from the computed one; a missing number is NaN.
struct Distance {
  double abs = 0;         ///< |given - computed|; infinite beyond the range of doubles, or where one of them is missing
  double rel = 0;         ///< abs / |computed|; infinite where only the computed number is 0
  std::uint64_t ulp = 0;  ///< number of steps between neighbouring doubles; 0 and -0 are equal
};

/// Two missing numbers are equal.
Distance distance(double given, double computed);

/// Limits of a column: a number is admitted by any of the three that are there.
struct Limits {
  std::optional<double> abs, rel, ulp;

  bool admit(const Distance& distance) const;
};

/// For each measure the column's own tolerance, else the one for all columns. Without any, only equal numbers are
/// admitted.
Limits limits_of(const Comparison& comparison, const std::string& column);

/// A given number that differs from the computed one.
struct Difference {
  std::uint64_t row = 0, line = 0;  ///< among the rows of the curve, from 1; in the file
  std::string column;
  double given = 0, computed = 0;  ///< NaN where missing
  Distance distance;
};

/// The parts of a result that every comparison has.
struct ComparisonSummary {
  std::string file, keys;            ///< names of the files of samples and of keys
  bool by_length = false;            ///< the samples are at arc lengths
  std::vector<std::string> ignored;  ///< names of columns that were not compared, on purpose
  std::vector<Error> problems;       ///< of columns, curves and rows, besides the numbers
};

/// The result of a check for one column.
struct ColumnCheck {
  std::string name;
  std::uint64_t mismatches = 0;
  Distance largest;  ///< in each measure, over all rows where neither number is missing
};

struct Check : ComparisonSummary {
  std::uint64_t rows = 0, values = 0, mismatches = 0;
  std::vector<ColumnCheck> columns = {};
  std::optional<Difference> first = {}, worst = {};  ///< the worst: the largest absolute distance

  bool passed() const { return mismatches == 0 && problems.empty(); }
};

/// Compares every number of the samples with the curve. Throws: Error where the keys make no curve, or there is nothing
/// to compare.
Check check(const Job& job);

}  // namespace tcb
