// The fewest rows whose polyline stays near the curve.
//
// From each row the next one is taken as far along as the chord between them keeps every point of the curve
// within the tolerance. The points within D of a chord form a convex set, so a piece of the curve lies in it
// if its Bezier control points do; pieces that cannot be told so are halved. That is a bound, not a sample.
// Where a single channel counts, the polyline is its graph over time, and the distance is taken at equal times.
#pragma once

#include <functional>
#include <vector>

#include "sampling/sampler.hpp"

namespace tcb {

/// The pieces of a whole curve by number, each as often as it is asked for.
struct CurveSegments {
  std::function<CurveSegment(std::uint64_t)> piece;
  std::uint64_t count = 0;
};

/// The times of the rows, from the curve's first key to its last, each the time of a point from which and to
/// which the chords keep within the tolerance. Corners are rows.
/// Throws: Error (usage) for more than max_rows rows.
std::vector<Time> times_within_tolerance(const CurveSegments& pieces, double tolerance, std::uint64_t max_rows);

}  // namespace tcb
