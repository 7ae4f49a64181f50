// Curves of rotations: by which of them rotations move from key to key; rotation.hpp has their formulas.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tcb::spline {

/// The curves of rotations; rotation_curves has a row for each, in this order.
enum class RotationCurve : std::uint8_t { squad, casteljau, components, slerp };

/// A curve of rotations and its description.
struct RotationCurveRow {
  RotationCurve id;
  std::string_view name;
  std::string_view formula;
  std::string_view used_by;
};

/// Every curve of rotations; the first is the default.
inline constexpr std::array rotation_curves{
    RotationCurveRow{RotationCurve::squad, "squad", "slerp(slerp(p, q, u), slerp(a, b, u), 2u(1 - u))",
                     "Eberly's note on quaternion keyframes, the 3ds Max family"},
    RotationCurveRow{RotationCurve::casteljau, "casteljau", "De Casteljau's algorithm for a cubic, with slerp",
                     "the Python package splines, nerfstudio"},
    RotationCurveRow{RotationCurve::components, "components", "the cubics of the four numbers, then normalized",
                     "CUBICSPLINE of glTF"},
    RotationCurveRow{RotationCurve::slerp, "slerp", "slerp(p, q, u), without tangents",
                     "LINEAR of glTF, SciPy's Slerp"},
};

constexpr std::string_view name_of(RotationCurve curve) {
  return rotation_curves[static_cast<std::size_t>(curve)].name;
}

}  // namespace tcb::spline
