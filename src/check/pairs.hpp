// Pairs: the rows of each curve, where they lie on it, and the numbers that it has there.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/distance.hpp"
#include "check/inputs.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

class KeptCurve;

struct Pair {
  const KeptKeys* curve;
  SampleRows rows;
};

struct Pairs {
  std::vector<Pair> pairs;
  std::vector<std::string> problems;  ///< curves without rows, rows without a curve
};

/// Pairs curves and rows by their groups if both have them, else by their order; a single curve takes all rows.
Pairs pair_up(const KeptInput& kept, SampleTable& table);

/// The places of rows on a curve.
struct Places {
  Time first, last;                           ///< of the curve
  std::vector<std::size_t> rows = {};         ///< that are on it
  std::vector<Time> places = {};              ///< of these rows
  std::optional<std::string> off_curve = {};  ///< if other rows are not on the curve: how many, and the first of them
};

/// Where rows lie on a curve. A place before or after the curve, but within `limits` of its end, counts as that end.
Places places_of(const SampleRows& rows, const MatchedColumns& columns, const KeptCurve& curve, const Limits& limits);

/// Calls `use` for each of the rows, in order, with its cells. They are aligned with the given row. Throws: Error
/// (data) for a number beyond the range.
void for_each_row(const SampleRows& given, const Places& places, const MatchedColumns& columns,
                  const std::shared_ptr<const KeptCurve>& curve, spline::Side side, unsigned threads,
                  const std::function<void(std::size_t row, std::span<const Cell> cells)>& use);

}  // namespace tcb
