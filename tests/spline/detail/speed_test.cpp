// Speed: its square, its minima, and its unit.
#include "tcb/spline/detail/speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "plane_segments.hpp"

namespace tcb::spline {
namespace {

TEST(Speed, of_a_parabola) {
  const Speed<double> speed(parabola, {});  // (1, 2u)
  for (const double u : {0.0, 0.25, 0.5}) {
    EXPECT_DOUBLE_EQ(speed(0, u) * speed.unit(), std::hypot(1, 2 * u));
    EXPECT_DOUBLE_EQ(speed(1, u - 0.5) * speed.unit(), std::hypot(1, 2 * (u + 0.5)));
  }
  EXPECT_FALSE(speed.is_constant());
}

TEST(Speed, its_square_is_a_quartic_about_any_place) {
  const Speed<double> speed(cusp, {});
  const auto q = speed.square_about(0, 0.25, 0.125);
  for (const double z : {-1.0, -0.5, 0.0, 0.75}) {
    const double square = q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * q[4])));
    EXPECT_NEAR(square, std::pow(speed(0, 0.25 + 0.125 * z), 2), 1e-15);
  }
  const auto both = speed.squares_about({0, 1}, {0.25, -0.25}, {0.125, 0.0625});
  EXPECT_EQ(both[3][0], q[3]);
  EXPECT_EQ(both[3][1], speed.square_about(1, -0.25, 0.0625)[3]);
}

TEST(Speed, has_a_minimum_where_growth_changes_its_sign) {
  const PlaneSegment turn = segment({0, 0}, {0, 1}, {4, 1}, {-4, 1});  // x = 4u - 4u^2: slowest at 1/2
  const Speed<double> speed(turn, {});
  EXPECT_TRUE(slowest_places(speed, 0, 0.0, 0.375).empty());
  const auto places = slowest_places(speed, 0, 0.0, 0.75);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(places[0], 0.5, 1e-15);
}

TEST(Speed, its_unit_is_a_power_of_two) {
  for (const int exponent : {-900, 0, 900}) {
    const double size = std::ldexp(1.5, exponent);
    const Speed<double> speed(segment({0, 0}, {size, 0}, {size, 0}, {size, 0}), {});
    int found = 0;
    EXPECT_EQ(std::frexp(speed.unit(), &found), 0.5);
    EXPECT_EQ(speed(0, 0.25) * speed.unit(), size);
    EXPECT_TRUE(speed.is_constant());
  }
  EXPECT_EQ(Speed<double>(segment({1, 2}, {1, 2}, {0, 0}, {0, 0}), {}).unit(), 0);
}

TEST(Speed, an_infinite_coefficient_is_detected) {
  PlaneSegment bad = parabola;
  bad[0].d = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(Speed<double>(bad, {}).is_finite());
  EXPECT_TRUE(Speed<double>(parabola, {}).is_finite());
}

}  // namespace
}  // namespace tcb::spline
