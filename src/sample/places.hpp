// Places: rows in any order on a kept curve, at times that may be outside it, or at arc lengths.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "numbers/rational.hpp"
#include "sample/build.hpp"
#include "sample/table.hpp"
#include "stream/source.hpp"

namespace tcb {

class Locator;
struct SampleBlock;

/// Where the rows of a request lie, in their order: times or arc lengths.
struct RowPlaces {
  std::vector<Time> places;
  std::vector<Rational> exact = {};                        ///< the same, if they do not follow from the rows; or none
  std::optional<std::uint64_t> least_rows = std::nullopt;  ///< of any polyline within a distance
  Rational zero = 0;                                       ///< as in the request
  std::vector<Motion> motions = {};                        ///< of rows at a pace, whose places are arc lengths
  std::optional<Rational> remainder = std::nullopt;        ///< as Sampler::remainder(), of rows at a pace
};

// tolerance.cpp

struct ToleranceRows {
  std::vector<Time> times;
  std::uint64_t least = 2;  ///< any polyline within the tolerance has at least so many rows
};

/// The times of few rows whose polyline stays within the tolerance of the curve, from its first key to its last.
/// Corners are rows. `at_keys`: all keys will be added as rows, so the polyline by them stays within the tolerance,
/// too. Throws: Error (usage) for more than max_rows rows.
ToleranceRows rows_within_tolerance(const KeptCurve& curve, const CurveTolerance& tolerance, std::uint64_t max_rows,
                                    bool at_keys = false);

// places.cpp

/// Requires: a mode whose rows are in any order, or a curve that is extended. `exact`: places are decimals as written.
/// Throws: Error (usage) for a place outside the curve where nothing extends it.
RowPlaces row_places(const SamplingRequest& request, const KeptCurve& curve, bool exact);

/// Throws: Error (usage) about an option, for a time outside the keys where nothing extends the curve.
void require_extended_to(std::string_view option, const Rational& time, const Extrapolations& rules,
                         const Rational& first, const Rational& last);

/// Rows in blocks, and what locates them.
struct FoundRows {
  Source<SampleBlock> blocks;
  std::shared_ptr<const Locator> locator;
};

/// Finds the segments of rows at these places. `side`: of a key, the segment on which a row there is.
/// The blocks throw: Error (usage) for a place outside the curve where nothing extends it.
FoundRows find_rows(const std::shared_ptr<const KeptCurve>& curve, RowPlaces places, bool by_length, spline::Side side);

}  // namespace tcb
