// Near turns: the turns between points that are nearly opposite, which floats of many digits determine; and conversions
// between balls of these and of double-doubles.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "exact/ball.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

/// A ball of double-doubles that holds a ball, and the other way round. Throws: Undecided for one beyond their range.
inline const Ball& ball_of(const Ball& ball) { return ball; }
Ball ball_of(const RealBall& ball);
template <class B>
B from_ball(const Ball& ball);

/// The turn between two points that a rotation's curve joins, next to a place at which they are nearly opposite. It
/// changes fast there, and balls around the points do not determine it.
struct NearTurn {
  static constexpr std::size_t nodes = 11;
  static constexpr double step = 0x1p-16, reach = 5 * step;

  std::size_t rotation, pair;
  double place;
  double nearest = 0;  ///< the distance from the place at which the points are nearest to opposite
  double width = 0;    ///< of the part in which the turn changes most
  /// The vector of the turn by the distance from the place, as a polynomial in Newton's form at the nodes.
  std::array<spline::Vector3<Ball>, nodes> coefficients = {};

  /// 0, 1, -1, 2, -2 and so on steps.
  static double node(std::size_t i) {
    const double distance = step * static_cast<double>((i + 1) / 2);
    return i % 2 == 0 ? -distance : distance;
  }
};
/// All near turns of the rotations of a segment. Double-doubles have too few digits to compute any.
std::vector<NearTurn> near_turns(std::span<const spline::RotationSegment<RealBall>> rotations);
inline std::vector<NearTurn> near_turns(std::span<const spline::RotationSegment<Ball>>) { return {}; }

template <class B>
spline::RotationSegment<double> in_doubles(const spline::RotationSegment<B>& rotation) {
  return rotation.template converted<double>([](const B& number) { return number.rough(); });
}

/// A rotation in double-doubles, in the frame of its first point, so that small turns keep their digits.
spline::RotationSegment<Ball> from_start(const spline::RotationSegment<RealBall>& rotation);
inline const spline::RotationSegment<Ball>& from_start(const spline::RotationSegment<Ball>& rotation) {
  return rotation;
}

}  // namespace tcb
