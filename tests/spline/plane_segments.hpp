// Segments in the plane with a known length.
#pragma once

#include <array>
#include <cmath>

#include "tcb/spline/segment.hpp"

namespace tcb::spline {

using PlaneSegment = std::array<Cubic<double>, 2>;

inline PlaneSegment segment(std::array<double, 2> p0, std::array<double, 2> p1, std::array<double, 2> out,
                            std::array<double, 2> in) {
  return {cubic<double>(p0[0], p1[0], out[0], in[0]), cubic<double>(p0[1], p1[1], out[1], in[1])};
}

/// y = x^2 for x from 0 to 1.
inline const PlaneSegment parabola = segment({0, 0}, {1, 1}, {1, 0}, {1, 2});
inline const double parabola_length = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;

/// (u^2, u^3): a cusp at the start; its length is (13^1.5 - 8) / 27.
inline const PlaneSegment cusp = segment({0, 0}, {1, 1}, {0, 0}, {2, 3});

}  // namespace tcb::spline
