// Rotations among keys: the checks of quaternions, and their signs.
#pragma once

#include <string>
#include <vector>

#include "input/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The keys of a curve with its quaternions negated where that makes the dot product with the one before positive, so
/// that signs are continuous. A key may lack all four numbers of a rotation.
/// `normalize`: norms need not be 1 within 0.001.
/// Throws: Error (data), at its line, for a quaternion that is zero, not whole or not of that norm, and for half a turn
/// between two.
Source<KeyBlock> with_continuous_signs(Source<KeyBlock> blocks, const std::vector<spline::RotationChannels>& rotations,
                                       const std::vector<std::string>& channels, bool normalize);

}  // namespace tcb
