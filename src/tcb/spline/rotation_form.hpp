// Forms of rotations: how the numbers of a rotation are written; rotation_notation.hpp converts them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tcb::spline {

/// The numbers that give a rotation: x, y, z, w; an axis and the angle around it; angles around three axes in turn; the
/// nine of a matrix, row after row; or an axis whose length is the angle.
enum class RotationForm : std::uint8_t { quaternion, axis_angle, euler, matrix, rotation_vector };

/// How a rotation is written.
struct RotationNotation {
  RotationForm form = RotationForm::quaternion;
  std::array<std::uint8_t, 3> axes{};  ///< of Euler angles: 0 to 2, in the order of the turns
  bool intrinsic = true;               ///< each turn is around an axis of the frame that was turned before
  bool degrees = false;                ///< angles are in degrees, else in radians

  constexpr std::size_t numbers() const {
    constexpr std::array<std::size_t, 5> counts{4, 4, 3, 9, 3};
    return counts[static_cast<std::size_t>(form)];
  }
  constexpr bool is_quaternion() const { return form == RotationForm::quaternion; }
  constexpr bool has_angles() const { return !is_quaternion() && form != RotationForm::matrix; }
  friend bool operator==(const RotationNotation&, const RotationNotation&) = default;
};

/// The numbers of a rotation in any notation; zeros follow.
template <class S>
using RotationNumbers = std::array<S, 9>;

}  // namespace tcb::spline
