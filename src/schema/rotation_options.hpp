// Rotation options: which columns are rotations and angles, how keys give them, and how rows show them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tcb/spline/rotation_form.hpp"
#include "text/suggest.hpp"

namespace tcb {

inline constexpr auto rotation_forms =
    std::to_array<Named<spline::RotationForm>>({{"quaternion", spline::RotationForm::quaternion},
                                                {"axis-angle", spline::RotationForm::axis_angle},
                                                {"euler", spline::RotationForm::euler},
                                                {"matrix", spline::RotationForm::matrix},
                                                {"rotation-vector", spline::RotationForm::rotation_vector}});

/// The units of angles, and whether they are degrees.
inline constexpr auto angle_units = std::to_array<Named<bool>>({{"radians", false}, {"degrees", true}});

/// How keys give a rotation.
struct GivenRotation {
  spline::RotationNotation notation = {};
  bool relative = false;                   ///< to the rotation of the key before
  std::vector<std::string> columns = {};   ///< names of those of its numbers
  std::vector<std::size_t> channels = {};  ///< those of its numbers, in keys as they are read
  bool normalize = false;                  ///< a quaternion of any norm, or the rotation nearest to a matrix
  bool in_parent = false;                  ///< if relative, in the frame outside that of the key before
};

struct NamedAngle {
  std::string channel;
  bool degrees = false;
};

/// Which columns are rotations, and how rows show them.
struct RotationOptions {
  bool none = false;                 ///< their numbers are plain channels
  bool normalize = false;            ///< quaternions may have any norm
  std::optional<bool> degrees = {};  ///< their angles are in degrees, not in radians; nothing: in radians by default
  std::vector<GivenRotation> requests = {};
  std::vector<NamedAngle> angles = {};
  std::optional<spline::RotationNotation> shown = {};  ///< nothing: as they are given
  bool shown_by_format = false;  ///< the format of the output decides how they are shown, if there are any
  bool as_curves = false;        ///< all as quaternions, whose curves are drawn
};

}  // namespace tcb
