// Closed curves: where the period comes from, and keys that come round again.
#pragma once

#include "curve/curve_plan.hpp"
#include "curve/segment_blocks.hpp"
#include "keys/key_store.hpp"

namespace tcb {

/// When a closed curve is back at its first key. A last key that repeats the first one's position is dropped:
/// it only says when that is. `timed`: the keys came with times of their own.
/// Throws: Error (data) where nothing says when, where the repeated key has another tension, continuity or
/// bias, or where there are fewer than two distinct keys.
spline::Time<double> close(KeyStore& keys, const CurvePlan& plan, bool timed);

/// The keys followed by the first two once more, with the last one as context before them.
LinkedKeys going_round(const KeyStore& keys, const spline::Time<double>& end);

}  // namespace tcb
