// Distances: three measures, what is missing, and what is admitted.
#include "compare/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tcb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

TEST(Distance, has_three_measures) {
  const Distance found = distance(5, 4);
  EXPECT_EQ(found.abs, 1);
  EXPECT_EQ(found.rel, 0.25);
  EXPECT_EQ(found.ulp, std::uint64_t{1} << 50U) << "a quarter of the 2^52 doubles from 4 to 8";
  EXPECT_EQ(distance(-5, -4).ulp, found.ulp);
}

TEST(Distance, counts_doubles_across_zero) {
  EXPECT_EQ(distance(0.0, -0.0).ulp, 0U);
  EXPECT_EQ(distance(tiny, -tiny).ulp, 2U);
  EXPECT_EQ(distance(tiny, 0).rel, infinity);
  EXPECT_EQ(distance(1e308, -1e308).abs, infinity) << "2e308 is no double";
}

TEST(Distance, of_missing_numbers_is_nothing_or_without_limit) {
  EXPECT_EQ(distance(nan, nan).ulp, 0U);
  EXPECT_EQ(distance(nan, nan).abs, 0);
  EXPECT_EQ(distance(nan, 1).abs, infinity);
  EXPECT_EQ(distance(1, nan).ulp, std::numeric_limits<std::uint64_t>::max());
}

TEST(Limits, any_of_the_three_admits) {
  EXPECT_TRUE((Limits{0.5, {}, {}}.admit(distance(4.5, 4))));
  EXPECT_FALSE((Limits{0.49, {}, {}}.admit(distance(4.5, 4))));
  EXPECT_TRUE((Limits{0.1, 0.125, {}}.admit(distance(4.5, 4))));
  EXPECT_TRUE((Limits{{}, {}, 1}.admit(distance(std::nextafter(4, 5), 4))));
  EXPECT_FALSE((Limits{{}, {}, 1}.admit(distance(std::nextafter(4, 0), std::nextafter(4, 5)))));
  EXPECT_TRUE((Limits{}.admit(distance(4, 4)))) << "equality always does";
  EXPECT_FALSE((Limits{1e300, 1e300, 1e18}.admit(distance(nan, 4))));
}

TEST(Limits, those_of_a_column_go_before_those_of_all) {
  const Comparison comparison{"", false, {{"x", 3}, {"", 1}}, {{"y", 0.5}}, {}};
  EXPECT_EQ(limits_of(comparison, "x").abs, 3);
  EXPECT_EQ(limits_of(comparison, "y").abs, 1);
  EXPECT_EQ(limits_of(comparison, "y").rel, 0.5);
  EXPECT_FALSE(limits_of(comparison, "x").rel);
}

}  // namespace
}  // namespace tcb
