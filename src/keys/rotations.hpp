// Rotations among keys: checks of quaternions, and their signs.
#pragma once

#include "keys/rotation_forms.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The keys of a curve with the quaternions of all rotations: of those in other forms as with_converted_rotations()
/// makes them, of the others as keys give them. A quaternion is negated where that makes its dot product with the one
/// before positive, so that signs are continuous.
/// Throws: Error (data), at its line, as with_converted_rotations(), for a quaternion that is zero or not of the norm
/// 1, for half a turn between two, and for velocities of some numbers alone or with the curve slerp.
Source<KeyBlock> with_quaternions(Source<KeyBlock> blocks, const RotationsOfKeys& rotations);

}  // namespace tcb
