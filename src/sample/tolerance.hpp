// Tolerance: few rows whose polyline stays near the curve.
#pragma once

#include <cstdint>
#include <vector>

#include "sample/build.hpp"
#include "sample/request.hpp"

namespace tcb {

struct ToleranceRows {
  std::vector<Time> times;
  std::uint64_t least = 2;  ///< any polyline within the tolerance has at least so many rows
};

/// The times of few rows whose polyline stays within the tolerance of the curve, from its first key to its last.
/// Corners are rows. `at_keys`: all keys will be added as rows, so the polyline by them stays within the tolerance,
/// too. Throws: Error (usage) for more than max_rows rows.
ToleranceRows rows_within_tolerance(const KeptCurve& curve, const CurveTolerance& tolerance, std::uint64_t max_rows,
                                    bool at_keys = false);

}  // namespace tcb
