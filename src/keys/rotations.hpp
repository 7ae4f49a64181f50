// Rotations and angles of keys: the quaternions of rotations in other forms, checks, and signs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "schema/key_block.hpp"
#include "schema/rotation_options.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"
#include "tcb/spline/rotation_curve.hpp"

namespace tcb {

/// The rotations and angles of the keys of an input.
struct TurnsOfKeys {
  std::vector<RotationSchema> rotations;
  std::vector<std::size_t> sources = {};  ///< as in Schema; empty: the channels are those that are read
  spline::RotationCurve curve = spline::RotationCurve::squad;
  bool in_parent = false;  ///< a relative rotation turns in the frame outside that of the key before
  bool closed = false;     ///< the first key follows the last one
  std::vector<AngleColumn> angles = {};
  std::vector<std::string> channels = {};  ///< names
};

/// How keys give a rotation that is no quaternion.
struct ConvertedRotation {
  RotationColumns columns;
  spline::RotationNotation notation;
  bool relative;  ///< to the rotation of the key before
  bool in_parent;
};

/// The rotations that are converted, in the order of KeyBlock::given_rotations.
std::vector<ConvertedRotation> converted_rotations(const TurnsOfKeys& turns);

/// The keys of a curve with the quaternions of all rotations, in blocks that have a channel for each of their numbers;
/// those in other forms are converted. A key may lack all numbers of a rotation. A quaternion is negated where that
/// makes its dot product with the one before positive, so that signs are continuous.
/// Throws: Error (data), at its line, for a rotation that is not whole, an angle beyond what its unit allows, an axis
/// of zero, a matrix that is no rotation, a quaternion that is zero or not of the norm 1, half a turn between two, and
/// velocities of some numbers alone, of a rotation in another form, or with the curve slerp. The same for an angle that
/// is missing or beyond what its unit allows, and for half a turn between two.
Source<KeyBlock> with_clear_turns(Source<KeyBlock> blocks, const TurnsOfKeys& turns);

}  // namespace tcb
