// Key numbers: velocities, or tension, continuity and bias, that give keys their slopes, in few digits.
//
// With the chord velocities v0, v1 of a channel before and after a key, the default tangent rule has the slopes
//   in  = (1-T)((1-C)(1+B) v0 + (1+C)(1-B) v1)/2
//   out = (1-T)((1+C)(1+B) v0 + (1-C)(1-B) v1)/2
// For one slope S, C = 0, and B = 0, T = 1 - 2S/(v0+v1), or T = 0, B = (2S-v0-v1)/(v0-v1), the one nearer to 0.
// For a corner with C = -1, P = (1-T)(1+B)/2 = in/(2 v0) and Q = (1-T)(1-B)/2 = out/(2 v1): 1-T = P+Q, B = (P-Q)/(P+Q).
// Source: the table of tangent rules, solved for the three numbers.
#pragma once

#include <optional>
#include <vector>

#include "fit/fit.hpp"

namespace tcb {

/// A key with the slopes of the segments before and after it.
struct CornerKey {
  std::size_t sample = 0;
  std::vector<double> position, incoming, outgoing;
};

/// The keys with numbers rounded to decimals that move the curve by thousandths of the tolerances. A slope that no
/// tension, continuity and bias give is replaced by 0. Rotations have the tension, continuity and bias, the same in
/// their four channels, whose tangents are nearest to the slopes.
Keys numbered_keys(const std::vector<CornerKey>& keys, const Recording& recording, const std::vector<Time>& times,
                   const FitRules& rules);

}  // namespace tcb
