// Segments: cubics at both ends, parts of them, and places side by side.
#include "tcb/spline/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tcb::spline {
namespace {

TEST(Segment, two_places_as_a_pair_have_the_bits_of_each) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 10'000; ++i) {
    const auto x = cubic<double>(uniform(random), uniform(random), uniform(random), uniform(random));
    const auto place = [&] { return from_start<double>(DoubleDouble(std::abs(uniform(random)))); };
    const auto a = place(), b = place();
    if (!can_pair(a, b)) continue;
    const DoublePair both = positions(x, a, b);
    ASSERT_EQ(both[0], position(x, a));
    ASSERT_EQ(both[1], position(x, b));
  }
  const LocalParameter<double> start{0, -1}, inside{0.25, -0.75}, late{0.75, -0.25}, end{1, 0};
  EXPECT_TRUE(can_pair(inside, inside));
  EXPECT_FALSE(can_pair(inside, late) || can_pair(start, inside) || can_pair(late, end));
}

TEST(Segment, both_ends_are_exact) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double p0 = uniform(random), p1 = uniform(random);
    const auto x = cubic<double>(p0, p1, uniform(random), uniform(random));
    EXPECT_EQ(position(x, from_start<double>(DoubleDouble(0))), p0);
    EXPECT_EQ(position(x, from_end<double>(DoubleDouble(0))), p1);
  }
}

TEST(Segment, has_the_hermite_form) {
  const auto x = cubic<double>(1, 3, DoubleDouble(2), DoubleDouble(-1));
  for (const double u : {0.125, 0.25, 0.5, 0.75, 0.875}) {
    const double h1 = u * u * (3 - 2 * u), h2 = u * (u - 1) * (u - 1), h3 = u * u * (u - 1);
    const auto at = from_start<double>(DoubleDouble(u));
    EXPECT_NEAR(position(x, at), 1 - h1 + 3 * h1 + 2 * h2 - h3, 1e-15);
    EXPECT_NEAR(first_derivative(x, at), 2 * 6 * u * (1 - u) + 2 * (1 - u) * (1 - 3 * u) - u * (3 * u - 2), 4e-15);
  }
}

TEST(Segment, a_straight_segment_has_no_curvature_at_all) {
  const auto x = cubic<double>(0.1, 0.7, exact_difference(0.7, 0.1), exact_difference(0.7, 0.1));
  EXPECT_EQ(x.c, 0);
  EXPECT_EQ(x.e, 0);
  EXPECT_EQ(x.d, 0);
}

TEST(Segment, a_part_has_the_positions_of_the_whole) {
  const auto x = cubic<double>(1, 3, DoubleDouble(2), DoubleDouble(-1));
  const auto middle = part<double>(x, 0.0, 4.0, 1.0, 3.0);
  for (const double u : {0.0, 0.25, 0.5, 1.0}) {
    const auto of_whole = from_start<double>(DoubleDouble((1 + 2 * u) / 4));
    EXPECT_NEAR(position(middle, from_start<double>(DoubleDouble(u))), position(x, of_whole), 1e-15);
  }
  EXPECT_EQ(part<double>(x, 0.0, 4.0, 0.0, 4.0).c, x.c);
}

TEST(Segment, an_expanded_part_has_the_derivatives_of_the_whole_where_it_is_short) {
  const auto x = cubic<double>(1e6, 1e6 + 1, DoubleDouble(0.5), DoubleDouble(0.25));  // c = 1.75, d = -1.25
  const double size = 0x1p-22;
  const auto near_start = expanded_part<double>(x, 0.0, 4.0, 1.0, 1 + 4 * size);
  EXPECT_EQ(near_start.out, 1.140625 * size);  // 0.5 + u (3.5 - 3.75 u), u = 1/4
  EXPECT_EQ(near_start.c, 0.8125 * size * size);
  EXPECT_EQ(near_start.d, -1.25 * size * size * size);
  const auto near_end = expanded_part<double>(x, 0.0, 4.0, 3.0, 3 + 4 * size);
  EXPECT_EQ(near_end.out, 1.015625 * size);  // the same with u = 3/4
  EXPECT_EQ(near_end.c, -1.0625 * size * size);
  const auto fitted = part<double>(x, 0.0, 4.0, 1.0, 1 + 4 * size);
  EXPECT_EQ(near_start.p0, fitted.p0);
  EXPECT_EQ(near_start.p1, fitted.p1);
  EXPECT_EQ(expanded_part<double>(x, 0.0, 4.0, 0.0, 4.0).c, x.c);
}

}  // namespace
}  // namespace tcb::spline
