// Factor: how much slower a curve has to be, so that all limits hold.
#pragma once

#include "limits/report.hpp"
#include "numbers/rational.hpp"

namespace tcb::limits {

/// The smallest factor of 14 digits by which all limits hold, with a margin for the rounding of times;
/// at least 1 unless it `fits`. Throws: Error for limits that no factor meets.
Rational factor_within(const LimitsReport& report, bool fits);

}  // namespace tcb::limits
