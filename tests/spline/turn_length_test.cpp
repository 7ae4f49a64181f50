// Turn length: the angle of a constant turn, of a curve by fine steps, its inverse, and rotations at rest.
#include "tcb/spline/turn_length.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tcb::spline {
namespace {

Quaternion<double> around_z(double angle) { return {0, 0, std::sin(angle / 2), std::cos(angle / 2)}; }

TEST(TurnLength, of_a_constant_turn_is_its_angle) {
  const RotationSegment<double> turn(RotationCurve::slerp, {around_z(0), around_z(0), around_z(2), around_z(2)});
  TurnLength<double> length;
  length.assign({&turn, 1});
  EXPECT_NEAR(length.total().value, 2, 1e-15);
  EXPECT_NEAR(length.to({0.25, -0.75}).value, 0.5, 1e-15);
  std::array<LocalParameter<double>, 3> places;
  length.places(10.0, std::array<DoubleDouble, 3>{10.0, 10.5, 12.5}, places);
  EXPECT_EQ(places[0].u, 0);
  EXPECT_NEAR(places[1].u, 0.25, 1e-15);
  EXPECT_EQ(places[2].w, 0);
}

TEST(TurnLength, of_a_curve_is_the_sum_of_fine_steps) {
  const Quaternion<double> a{0, 0, 0, 1}, b{0.5, 0.5, -0.5, 0.5};
  const RotationSegment<double> curve(RotationCurve::squad, {a, around_z(1), around_z(-2) * b, b});
  TurnLength<double> length;
  length.assign({&curve, 1});
  double sum = 0;
  constexpr int steps = 10'000;
  for (int i = 0; i < steps; ++i) {
    const double u = static_cast<double>(i) / steps, v = static_cast<double>(i + 1) / steps;
    const auto turn = logarithm(conjugate(curve.at({u, u - 1})) * curve.at({v, v - 1}));
    sum += 2 * std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
  }
  EXPECT_NEAR(length.total().value, sum, 1e-6);
  for (int i = 1; i < 10; ++i) {
    const DoubleDouble wanted(length.total().value * i / 10);
    LocalParameter<double> place;
    length.places(0.0, {&wanted, 1}, {&place, 1});
    EXPECT_NEAR(length.to(place).value, wanted.hi, 2e-15);
  }
}

TEST(TurnLength, of_rest_is_zero) {
  const RotationSegment<double> rest(RotationCurve::slerp, {around_z(1), around_z(1), around_z(1), around_z(1)});
  TurnLength<double> length;
  length.assign({&rest, 1});
  EXPECT_LE(length.total().value, 1e-15);
}

}  // namespace
}  // namespace tcb::spline
