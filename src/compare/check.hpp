// The check: someone's samples against the curve, number by number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/job.hpp"
#include "compare/distance.hpp"
#include "compare/pairs.hpp"

namespace tcb {

/// Two numbers that should be one.
struct Difference {
  std::uint64_t row = 0, line = 0;  ///< of the curve's rows in the file, from 1; and in the file
  std::string column;
  double theirs = 0, ours = 0;  ///< not a number where there is none
  Distance distance;
};

/// What the comparison of a column came to.
struct ColumnCheck {
  std::string name;
  std::uint64_t mismatches = 0;
  Distance largest;  ///< in each measure, over all numbers that both have
};

struct Check : Compared {
  std::uint64_t rows = 0, values = 0, mismatches = 0;
  std::vector<ColumnCheck> columns = {};
  std::optional<Difference> first = {}, worst = {};  ///< the worst: the largest absolute distance

  bool passed() const { return mismatches == 0 && problems.empty(); }
};

/// Compares. Throws: Error where the keys make no curve, or there is nothing to compare.
Check check(const Job& plan);

}  // namespace tcb
