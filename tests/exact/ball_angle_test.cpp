// Angles of balls: sines, cosines and angles are held by their balls, against 200 digits, and these are small.
#include "exact/ball.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "exact/floats.hpp"

namespace tcb {
namespace {

using ExactAngle = Float<200>;

ExactAngle middle_of_angle(const Ball& ball) { return ExactAngle(ball.middle().hi) + ExactAngle(ball.middle().lo); }

void expect_angle_held(const ExactAngle& number, const Ball& ball, double largest_radius, const char* what) {
  EXPECT_LE(ExactAngle(abs(number - middle_of_angle(ball))), ExactAngle(ball.radius()))
      << what << " " << ball.middle().hi;
  EXPECT_LE(ball.radius(), largest_radius) << what << " " << ball.middle().hi;
}

TEST(BallAngle, holds_sines_and_cosines) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-20, 20), unit(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    // Anywhere, near multiples of pi/16, and near 0.
    const double high = i % 3 == 0   ? number(random)
                        : i % 3 == 1 ? std::round(number(random)) * 0x1.921fb54442d18p-3
                                     : std::ldexp(unit(random), -static_cast<int>(random() % 200));
    const auto middle = spline::DoubleDouble::normalized(high, unit(random) * std::abs(high) * 0x1p-54);
    const double radius = i % 2 == 0 ? 0 : std::abs(high) * 0x1p-90;
    const ExactAngle angle =
        ExactAngle(middle.hi) + ExactAngle(middle.lo) + ExactAngle(unit(random)) * ExactAngle(radius);
    const auto [sine, cosine] = sine_cosine(Ball(middle, radius));
    expect_angle_held(sin(angle), sine, 2 * radius + 0x1p-88 * std::min(1.0, std::abs(high)), "sine");
    expect_angle_held(cos(angle), cosine, 2 * radius + 0x1p-90, "cosine");
    if (HasFailure()) return;
  }
}

TEST(BallAngle, holds_angles_of_vectors) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 100) - 50);
    const double y = i % 4 == 0 ? std::ldexp(1.0, -static_cast<int>(random() % 100)) : std::abs(unit(random));
    const double x = i % 5 == 0 ? unit(random) * 0x1p-60 : unit(random);
    if (y == 0) continue;
    const auto angle = angle_of(Ball(y * scale), Ball(x * scale));
    expect_angle_held(atan2(ExactAngle(y * scale), ExactAngle(x * scale)), angle, 0x1p-90 * angle.middle().hi, "angle");
    if (HasFailure()) return;
  }
}

TEST(BallAngle, has_exact_cases) {
  EXPECT_TRUE(sine_cosine(Ball()).sine.is_zero());
  EXPECT_TRUE(sine_cosine(Ball()).cosine == Ball(1.0));
  EXPECT_TRUE(angle_of(Ball(), Ball(2.0)).is_zero());
  expect_angle_held(atan2(ExactAngle(0), ExactAngle(-1)), angle_of(Ball(), Ball(-1.0)), 0x1p-104, "pi");
}

TEST(BallAngle, refuses_what_it_cannot_bound) {
  EXPECT_THROW((void)sine_cosine(Ball({1, 0}, 0.5)), Undecided);
  EXPECT_THROW((void)angle_of(Ball({1e-3, 0}, 1e-3), Ball({0, 0}, 1e-3)), Undecided);
}

}  // namespace
}  // namespace tcb
