// Euler tracks: angles with keys of their own, so that their curve is one of angles, not of rotations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tcb {

/// Angles that channels of a curve are.
struct EulerTrack {
  struct Turn {
    std::size_t channel = 0;  ///< of its angle
    std::uint8_t axis = 0;    ///< 0 to 2
  };
  std::array<Turn, 3> turns = {};               ///< the first is around an axis of the parent
  bool degrees = false;                         ///< angles are in degrees, else in radians
  std::array<double, 4> before = {0, 0, 0, 1};  ///< a fixed rotation x, y, z, w around the turns
  std::array<double, 4> after = {0, 0, 0, 1};   ///< one within them
};

}  // namespace tcb
