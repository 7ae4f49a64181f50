// The rows of a curve at the places that someone's samples have.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/curve_pipeline.hpp"
#include "compare/columns.hpp"
#include "compare/distance.hpp"
#include "compare/kept.hpp"
#include "output/layout.hpp"

namespace tcb {

/// The places of some rows, and what is wrong with those that are on no curve.
struct Places {
  std::vector<std::size_t> rows;
  std::vector<Time> places;            ///< of these rows, on the curve
  std::vector<std::size_t> off_curve;  ///< the other rows
  std::string off_in_words;            ///< of the first of them
};

/// Where the rows of a table are on a curve. One outside that `limits` admit of an end stands there.
Places places_of(const SampleRows& rows, const SampleTable& table, const MatchedColumns& columns,
                 const IndexedCurve& whole, const Limits& limits);

/// What is wrong with rows off the curve, in words. Requires: there are some.
std::string off_curve(const Places& places, const SampleRows& rows);

/// Calls `hear` for each of the rows, in order, with its cells. Throws: Error (data) for a number beyond the range.
void for_each_row(const Places& places, const MatchedColumns& columns, const IndexedCurve& whole, bool from_left,
                  unsigned threads, const std::function<void(std::size_t row, std::span<const Cell> cells)>& hear);

}  // namespace tcb
