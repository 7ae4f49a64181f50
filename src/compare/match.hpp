// Match: which rows are samples of which curve, and the rows of the curve at the same places.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/curve_pipeline.hpp"
#include "compare/check.hpp"
#include "compare/inputs.hpp"
#include "output/layout.hpp"

namespace tcb {

/// A curve and the rows that are given of it.
struct Pair {
  const KeptCurve* curve;
  SampleRows rows;
};

struct Pairs {
  std::vector<Pair> pairs;
  std::vector<Error> problems;  ///< curves without rows, rows without a curve
};

/// Pairs curves and rows by their groups where both have them, else by their order; a single curve takes all rows.
Pairs pair_up(const KeptCurves& kept, SampleTable& table);

/// The parts of a result that every comparison has.
ComparisonSummary summary(const ComparisonInputs& inputs, const Pairs& pairs);

/// The places of some rows on a curve.
struct Places {
  std::vector<std::size_t> rows;
  std::vector<Time> places;        ///< of these rows
  std::optional<Error> off_curve;  ///< where other rows are not on the curve: how many, and the first of them
};

/// Where rows lie on a curve. A place before or after the curve, but within `limits` of its end, counts as that end.
Places places_of(const SampleRows& rows, const SampleTable& table, const MatchedColumns& columns,
                 const IndexedCurve& curve, const Limits& limits);

/// Calls `use` for each of the rows, in order, with its cells. Throws: Error (data) for a number beyond the range.
void for_each_row(const Places& places, const MatchedColumns& columns, const IndexedCurve& curve, bool from_left,
                  unsigned threads, const std::function<void(std::size_t row, std::span<const Cell> cells)>& use);

}  // namespace tcb
