// Turn chords: which rotations are near the arc between two rows.
#include "sample/chord.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tcb {
namespace {

using Quaternion = spline::Quaternion<double>;

/// A turn around x or y by an angle in radians.
Quaternion around_x(double angle) { return spline::exponential<double>({angle / 2, 0, 0}); }
Quaternion around_y(double angle) { return spline::exponential<double>({0, angle / 2, 0}); }

/// A segment from time 0 to 1 with one rotation.
CurveSegment segment_with(const spline::RotationSegment<double>& rotation) {
  return {.start = 0, .end = 1, .s_start = 0, .s_end = 0, .cubics = {}, .metric = {}, .rotations = {&rotation, 1}};
}

bool is_near(const CurveSegment& segment, double from, double to, double angle) {
  const auto place = [&](double u) { return TurnPlace{segment, {u, u - 1}, u}; };
  TurnChord chord(angle);
  chord.set(place(from), place(to));
  return chord.departure(segment, from, to, 16) <= 1;
}

TEST(TurnChord, an_arc_is_near_itself) {
  const spline::RotationSegment<double> arc(spline::RotationCurve::slerp,
                                            {around_x(0), around_x(0), around_x(2), around_x(2)});
  EXPECT_TRUE(is_near(segment_with(arc), 0, 1, 1e-14));
  EXPECT_TRUE(is_near(segment_with(arc), 0.2, 0.9, 1e-14));
}

TEST(TurnChord, a_bend_is_as_far_as_it_bends) {
  // From rest to rest: halfway it is turned by y; the arc between the ends is no turn at all.
  const spline::RotationSegment<double> bend(spline::RotationCurve::squad,
                                             {around_y(0), around_y(0.4), around_y(0.4), around_y(0)});
  EXPECT_FALSE(is_near(segment_with(bend), 0, 1, 0.199));  // slerp(0, 0.4, 2 u (1 - u)) is 0.2 in the middle
  EXPECT_TRUE(is_near(segment_with(bend), 0, 1, 0.201));
  EXPECT_TRUE(is_near(segment_with(bend), 0.4, 0.6, 0.01));
}

TEST(TurnChord, takes_the_shorter_way_as_readers_do) {
  const spline::RotationSegment<double> long_way(spline::RotationCurve::slerp,
                                                 {around_x(0), around_x(0), -around_x(6), -around_x(6)});  // stays near
  EXPECT_TRUE(is_near(segment_with(long_way), 0, 1, 1e-14));
  const spline::RotationSegment<double> turns(spline::RotationCurve::slerp,
                                              {around_x(0), around_x(0), around_x(8), around_x(8)}, {4, 0, 0});
  EXPECT_FALSE(is_near(segment_with(turns), 0, 1, 1));
}

}  // namespace
}  // namespace tcb
