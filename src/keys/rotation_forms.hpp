// Rotations of keys in other forms than quaternions: their checks, and their quaternions.
#pragma once

#include <cstddef>
#include <vector>

#include "schema/key_block.hpp"
#include "schema/rotation_options.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

/// The rounding of the cosine of half the angle of a turn.
inline constexpr double half_turn_rounding = 0x1p-50;

/// What the keys of an input have for rotations.
struct RotationsOfKeys {
  std::vector<RotationSchema> rotations;
  std::vector<std::size_t> sources = {};  ///< as in Schema; empty: the channels are those that are read
  spline::RotationCurve curve = spline::RotationCurve::squad;
  bool in_parent = false;  ///< a relative rotation turns in the frame outside that of the key before
  bool closed = false;     ///< the first key follows the last one
};

/// How keys give a rotation that is no quaternion.
struct ConvertedRotation {
  RotationColumns columns;
  spline::RotationNotation notation;
  bool relative;  ///< to the rotation of the key before
  bool in_parent;
};

/// The rotations that are converted, in the order of KeyBlock::given_rotations.
std::vector<ConvertedRotation> converted_rotations(const RotationsOfKeys& rotations);

/// The keys of a curve with the quaternions of rotations that keys give in another form, in blocks that have a channel
/// for each of their numbers. A key may lack all numbers of a rotation.
/// Throws: Error (data), at its line, for one that is not whole, for an angle beyond what its unit allows, for an axis
/// of zero, for a matrix that is no rotation, and for velocities.
Source<KeyBlock> with_converted_rotations(Source<KeyBlock> blocks, const RotationsOfKeys& rotations);

}  // namespace tcb
