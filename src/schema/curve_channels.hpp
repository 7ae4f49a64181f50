// Channels of a curve: how rows show the rotations and the angles of a curve.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "numbers/frame_times.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation_form.hpp"

namespace tcb {

/// A rotation of keys, and how rows show it: as quaternion in the cells of its channels, otherwise at its places.
struct RotationColumns : spline::KeyRotation {
  spline::RotationNotation shown = {};
  std::array<std::size_t, 9> places{};  ///< of the cell of each number among those of a position
};

/// An angle of keys, and how rows show it.
struct AngleColumn : spline::AngleChannel {
  bool is_signed = false;  ///< from half a turn below 0 to half a turn, else from 0 to a whole turn
};

/// Angles that channels of a curve are, with keys of their own, so that their curve is one of angles, not of rotations.
struct EulerTrack {
  std::array<std::size_t, 3> channels = {};  ///< in the order of the turns
  spline::RotationNotation notation = {};
};

/// The channels of a curve as rows show them, and its times.
struct CurveChannels {
  std::vector<std::size_t> metric;  ///< of lengths and speeds; empty: all
  std::vector<RotationColumns> rotations = {};
  std::vector<AngleColumn> angles = {};
  std::optional<FrameTimes> frames = {};  ///< where times are frames in seconds
};

}  // namespace tcb
