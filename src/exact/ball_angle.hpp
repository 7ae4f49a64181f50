// Angles of balls: sine, cosine, and the angle of a vector, as tcb/spline/angle.hpp has them for other scalars.
#pragma once

#include "exact/ball.hpp"
#include "tcb/spline/angle.hpp"

namespace tcb {

/// Throws: Undecided for an angle whose ball is not small.
spline::SineCosine<Ball> sine_cosine(const Ball& angle);
spline::SineCosine<RealBall> sine_cosine(const RealBall& angle);
inline Ball sine(const Ball& angle) { return sine_cosine(angle).sine; }
inline RealBall sine(const RealBall& angle) { return sine_cosine(angle).sine; }

/// The angle of the vector (x, y) in [0, pi]. Requires: y >= 0. Throws: Undecided where the ball of the vector is not
/// small beside its distance from 0.
Ball angle_of(const Ball& y, const Ball& x);
RealBall angle_of(const RealBall& y, const RealBall& x);

}  // namespace tcb
