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

/// Half the angle around z of squad from 0 to `turn`, whose other two points are at `first` and `last`. Where these two
/// are half a turn apart from the points between the keys, it goes on around the other side.
double half_angle(double turn, double first, double last, double u, bool is_behind) {
  const double apart = first + (last - first) * u - turn * u;
  return turn * u + 2 * u * (1 - u) * (apart + (is_behind ? 2 * std::acos(-1.0) : 0));
}

TEST(TurnLength, ends_at_places_where_squad_goes_around_the_other_side) {
  const double pi = std::acos(-1.0);
  for (const double place : {0.5 + 3.8e-4, 0.25 - 1e-5, 0.75, 0.31}) {
    // The points are opposite at `place`, and turn by `rate` against each other.
    const double turn = 0.2, rate = -1.5, first = -pi - rate * place, last = first + rate + turn;
    const RotationSegment<double> curve(RotationCurve::squad,
                                        {around_z(0), around_z(2 * first), around_z(2 * last), around_z(2 * turn)});
    ASSERT_EQ(curve.breaks().size(), 1U);
    EXPECT_NEAR(curve.breaks()[0], place, 1e-14);
    TurnLength<double> length;
    length.assign({&curve, 1});
    double expected = 0;
    constexpr int steps = 200'000;  // the half angle is a polynomial on both sides, so the differences have no error
    for (const bool is_behind : {false, true}) {
      const double from = is_behind ? place : 0, to = is_behind ? 1 : place;
      for (int i = 0; i < steps; ++i) {
        const double u = from + (to - from) * i / steps, v = from + (to - from) * (i + 1) / steps;
        expected +=
            2 * std::abs(half_angle(turn, first, last, v, is_behind) - half_angle(turn, first, last, u, is_behind));
      }
    }
    EXPECT_NEAR(length.total().value, expected, 1e-10) << place;
    EXPECT_LT(length.total().error, 1e-11);
  }
}

/// A turn around z that is at rest at `place`, where it turns back: half the angle is (u - place)^2.
TEST(TurnLength, has_no_error_where_a_turn_back_is_next_to_the_end_of_a_panel) {
  for (const double place : {1e-4, 0.5 - 1e-4, 0.5, 0.25 + 1e-5, 1 - 3e-4}) {
    const double start = place * place, end = (1 - place) * (1 - place);
    // With 2u (1 - u) = 2u - 2u^2, squad is a parabola where both points are -1/2 apart: u^2 - u + turn u.
    const RotationSegment<double> curve(
        RotationCurve::squad,
        {around_z(0), around_z(-1), around_z(2 * (end - start) - 1), around_z(2 * (end - start))});
    TurnLength<double> length;
    length.assign({&curve, 1});
    EXPECT_NEAR(length.total().value, 2 * (start + end), 1e-14) << place;
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
