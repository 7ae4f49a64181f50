// Rotations among keys: quaternions from other forms, their checks, and their signs.
#pragma once

#include <string>
#include <vector>

#include "input/input.hpp"
#include "stream/source.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

/// What the keys of an input have for rotations.
struct RotationsOfKeys {
  std::vector<spline::RotationColumns> columns;
  std::vector<GivenRotation> given;  ///< how keys give each
  std::size_t channels;              ///< with those that keys do not have yet
  bool normalize = false;            ///< norms need not be 1 within 0.001
  spline::RotationCurve curve = spline::RotationCurve::squad;
  bool in_parent = false;  ///< a relative rotation turns in the frame outside that of the key before
  bool closed = false;     ///< the first key follows the last one
};

/// How keys give a rotation that is no quaternion.
struct ConvertedRotation {
  spline::RotationColumns columns;
  spline::RotationNotation notation;
  bool relative;  ///< to the rotation of the key before
  bool in_parent;
};

/// Those of KeyBlock::given_rotations, in their order.
std::vector<ConvertedRotation> converted_rotations(const RotationsOfKeys& rotations);

/// The keys of a curve with the quaternions of their rotations, in blocks that have a channel for each of its numbers.
/// They are negated where that makes the dot product with the one before positive, so that signs are continuous. A key
/// may lack all numbers of a rotation.
/// Throws: Error (data), at its line, for a quaternion that is zero, not whole or not of the norm 1, for an angle
/// beyond what its unit allows, for an axis of zero, for half a turn between two, and for velocities of some numbers
/// alone or with the curve slerp.
Source<KeyBlock> with_quaternions(Source<KeyBlock> blocks, const RotationsOfKeys& rotations);

}  // namespace tcb
