// Paces: the ramps at places that are known by hand.
#include "sample/pace.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

void expect_part(const PacePart<Rational>& part, const Rational& distance, const Rational& speed,
                 const Rational& acceleration) {
  EXPECT_EQ(part.distance, distance);
  EXPECT_EQ(part.speed, speed);
  EXPECT_EQ(part.acceleration, acceleration);
}

TEST(Pace, IsConstantWithoutRamps) {
  const Pace pace;
  expect_part(pace.at<Rational>(0, 0, 1), 0, 1, 0);
  expect_part(pace.at<Rational>(Rational(2, 7), 0, 1), Rational(2, 7), 1, 0);
  expect_part(pace.at<Rational>(1, 0, 1), 1, 1, 0);
}

TEST(Pace, RisesAndFallsSmoothly) {
  const Pace pace{.rise = Rational(1, 4), .fall = Rational(1, 4)};
  EXPECT_EQ(pace.top_speed(), Rational(4, 3));
  expect_part(pace.at<Rational>(0, 0, 1), 0, 0, 0);
  expect_part(pace.at<Rational>(Rational(1, 8), 0, 1), Rational(1, 32), Rational(2, 3), 8);
  expect_part(pace.at<Rational>(Rational(1, 4), 0, 1), Rational(1, 6), Rational(4, 3), 0);
  expect_part(pace.at<Rational>(Rational(1, 2), 0, 1), Rational(1, 2), Rational(4, 3), 0);
  expect_part(pace.at<Rational>(Rational(7, 8), 0, 1), Rational(31, 32), Rational(2, 3), -8);
  expect_part(pace.at<Rational>(1, 0, 1), 1, 0, 0);
}

TEST(Pace, IsNearlyTheSameInDoubleDoubles) {
  const Pace pace{.rise = Rational(1, 3), .fall = Rational(1, 7)};
  for (int i = 0; i <= 100; ++i) {
    const PacePart<Rational> exact = pace.at<Rational>(Rational(i, 50), 0, 2);
    const PacePart<Time> near = pace.at<Time>(Rational(i, 50), 0, 2);
    EXPECT_EQ(near.distance.hi, nearest_double(exact.distance));
    EXPECT_LT(abs(exact.distance - Rational(near.distance.hi) - Rational(near.distance.lo)), Rational(0x1p-98));
    EXPECT_NEAR(near.speed.hi, nearest_double(exact.speed), 1e-15);
    EXPECT_NEAR(near.acceleration.hi, nearest_double(exact.acceleration), 1e-14);
  }
}

TEST(Pace, HasOneRampAlone) {
  const Pace rises{.rise = 1};
  EXPECT_EQ(rises.top_speed(), 2);
  expect_part(rises.at<Rational>(Rational(1, 2), 0, 1), Rational(3, 16), 1, 3);
  expect_part(rises.at<Rational>(1, 0, 1), 1, 2, 0);
  expect_part(Pace{.fall = 1}.at<Rational>(0, 0, 1), 0, 2, 0);
}

}  // namespace
}  // namespace tcb
