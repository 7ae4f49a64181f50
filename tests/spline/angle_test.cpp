// Angles: sine, cosine and the angle of a vector against 50 digits.
#include "tcb/spline/angle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace tcb::spline {
namespace {

using Reference = boost::multiprecision::cpp_bin_float_50;

/// The distance in units in the last place of the reference.
double ulps(double value, const Reference& reference) {
  const double nearest = std::abs(static_cast<double>(reference));
  const double ulp = std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
  return std::abs(static_cast<double>(Reference(value) - reference)) / ulp;
}

TEST(Angle, sine_and_cosine_are_within_an_ulp) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> near(-7, 7), exponent(-60, 20), sign(-1, 1);
  double worst = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double quarter = std::round(near(random)) * 1.5707963267948966;
    const double angle = i % 3 == 0   ? near(random)
                         : i % 3 == 1 ? std::ldexp(sign(random), static_cast<int>(exponent(random)))
                                      : std::nextafter(quarter, sign(random) * 10);
    const auto [sine, cosine] = sine_cosine(angle);
    if (angle != 0) worst = std::max(worst, ulps(sine, sin(Reference(angle))));
    worst = std::max(worst, ulps(cosine, cos(Reference(angle))));
  }
  EXPECT_LT(worst, 1);
  EXPECT_EQ(sine_cosine(0.0).sine, 0);
  EXPECT_EQ(sine_cosine(0.0).cosine, 1);
}

TEST(Angle, sine_and_cosine_of_large_angles_have_all_digits) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> size(1, 2);
  for (int i = 0; i < 2'000; ++i) {
    const double angle = std::ldexp(i % 2 == 0 ? size(random) : -size(random), 20 + i % 70);
    const auto [sine, cosine] = sine_cosine(angle);
    EXPECT_LT(static_cast<double>(abs(Reference(sine) - sin(Reference(angle)))), 0x1p-52) << angle;
    EXPECT_LT(static_cast<double>(abs(Reference(cosine) - cos(Reference(angle)))), 0x1p-52) << angle;
  }
  EXPECT_EQ(sine_cosine(1e22).sine, -0.8522008497671888);
  EXPECT_TRUE(std::isnan(sine_cosine(0x1p90).sine));
}

TEST(Angle, the_angle_of_a_vector_is_within_an_ulp) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> near(-1, 1), exponent(-60, 60);
  double worst = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double y = std::abs(i % 2 == 0 ? near(random) : std::ldexp(near(random), static_cast<int>(exponent(random))));
    const double x = i % 5 == 0 ? y * std::round(16 * near(random)) / 8 : near(random);
    if (x == 0 && y == 0) continue;
    const double angle = angle_of(y, x);
    if (angle != 0) worst = std::max(worst, ulps(angle, atan2(Reference(y), Reference(x))));
  }
  EXPECT_LT(worst, 0.6);
  EXPECT_EQ(angle_of(0.0, 1.0), 0);
  EXPECT_EQ(angle_of(0.0, -1.0), 3.141592653589793);
  EXPECT_EQ(angle_of(1.0, 0.0), 1.5707963267948966);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(angle_of(nan, 1.0)) && std::isnan(angle_of(0.0, nan)));
}

TEST(Angles, are_wrapped_into_a_whole_turn) {
  EXPECT_EQ(wrapped(370.5, true, false), 10.5);
  EXPECT_EQ(wrapped(-0.5, true, false), 359.5);
  EXPECT_EQ(wrapped(-1e-300, true, false), 0);
  EXPECT_EQ(wrapped(360.0, true, false), 0);
  EXPECT_EQ(wrapped(180.0, true, true), -180);
  EXPECT_EQ(wrapped(-180.0, true, true), -180);
  EXPECT_EQ(wrapped(-725.0, true, true), -5);
  EXPECT_NEAR(wrapped(7.0, false, false), 7 - 2 * 3.141592653589793, 4e-16);
  EXPECT_EQ(wrapped(3.0, false, true), 3.0);
  const double far = wrapped(-1e300, true, false);  // a double has no digits of such an angle
  EXPECT_TRUE(far >= 0 && far < 360) << far;
  EXPECT_TRUE(std::isnan(wrapped(HUGE_VAL, true, false)));
  EXPECT_TRUE(std::isnan(wrapped(HUGE_VALF, true, false)));
}

TEST(Angles, have_nearest_whole_turns) {
  EXPECT_EQ(nearest_turns<double>(DoubleDouble(179.0), true).hi, 0);
  EXPECT_EQ(nearest_turns<double>(DoubleDouble(-181.0), true).hi, -360);
  EXPECT_EQ(nearest_turns<double>(DoubleDouble(1000.0), true).hi, 1080);
}

TEST(Angle, double_doubles_have_thirty_digits) {
  using Exact = boost::multiprecision::cpp_bin_float_100;
  const auto exact = [](const DoubleDouble& value) { return Exact(value.hi) + Exact(value.lo); };
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-20, 20), low(-0x1p-54, 0x1p-54), exponent(-80, 3);
  Exact worst_sine = 0, worst_angle = 0;
  for (int i = 0; i < 3000; ++i) {
    const double high = i % 2 == 0 ? any(random) : std::ldexp(any(random), static_cast<int>(exponent(random)));
    const auto angle = DoubleDouble::normalized(high, high * low(random));
    const auto [sine, cosine] = sine_cosine(angle);
    worst_sine = std::max(
        {worst_sine, Exact(abs(exact(sine) - sin(exact(angle)))), Exact(abs(exact(cosine) - cos(exact(angle))))});
    const DoubleDouble y(std::abs(high)), x(any(random));
    worst_angle = std::max(worst_angle, Exact(abs(exact(angle_of(y, x)) / atan2(exact(y), exact(x)) - 1)));
  }
  EXPECT_LT(worst_sine, Exact(0x1p-96));
  EXPECT_LT(worst_angle, Exact(0x1p-98));
  EXPECT_EQ(angle_of(DoubleDouble(0.0), DoubleDouble(1.0)).hi, 0);
}

}  // namespace
}  // namespace tcb::spline
