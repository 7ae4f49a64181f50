// The rows of a curve at the places that someone's samples have.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compare/columns.hpp"
#include "compare/distance.hpp"
#include "compare/kept.hpp"
#include "format/layout.hpp"
#include "path.hpp"

namespace tcb::compare {

/// The places of some rows, and what is wrong with those that are on no curve.
struct Places {
  std::vector<std::size_t> rows;
  std::vector<sampler::Time> places;   ///< of these rows, on the curve
  std::vector<std::size_t> off_curve;  ///< the other rows
  std::string off_in_words;            ///< of the first of them
};

/// Where the rows of a table are on a curve. One outside that `limits` admit of an end stands there.
Places places_of(const Rows& rows, const Table& table, const Columns& columns, const Whole& whole,
                 const Limits& limits);

/// What is wrong with rows off the curve, in words. Requires: there are some.
std::string off_curve(const Places& places, const Rows& rows);

/// Calls `hear` for each of the rows, in order, with its cells. Throws: Error (data) for a number beyond the range.
void for_each_row(const Places& places, const Columns& columns, const Whole& whole, bool from_left, unsigned threads,
                  const std::function<void(std::size_t row, std::span<const format::Cell> cells)>& hear);

}  // namespace tcb::compare
