// Dual numbers: derivatives of products, quotients, roots and angles.
#include "tcb/spline/dual.hpp"

#include <gtest/gtest.h>

namespace tcb::spline {
namespace {

using Number = Dual<double>;

const Number x{0.75, 1};  // its derivative by itself is 1

TEST(Dual, a_constant_has_the_derivative_0) {
  EXPECT_EQ(Number(3.0).slope, 0);
  EXPECT_EQ((x + Number(3.0)).slope, 1);
  EXPECT_EQ((-x - x).slope, -2);
}

TEST(Dual, products_and_quotients) {
  EXPECT_EQ((x * x).value, 0.5625);
  EXPECT_EQ((x * x).slope, 1.5);
  EXPECT_DOUBLE_EQ((Number(1.0) / x).slope, -1 / 0.5625);
}

TEST(Dual, roots_and_angles) {
  EXPECT_DOUBLE_EQ(sqrt(x).slope, 0.5 / std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(sine(x).slope, std::cos(0.75));
  EXPECT_DOUBLE_EQ(angle_of(sine(x), Number(0.0)).slope, 0);  // a quarter of a turn whatever its size
  EXPECT_DOUBLE_EQ(angle_of(x, Number(1.0)).slope, 1 / (1 + 0.5625));
}

TEST(Dual, the_value_alone) {
  EXPECT_EQ(value_of(x), 0.75);
  EXPECT_EQ(value_of(0.75), 0.75);
}

}  // namespace
}  // namespace tcb::spline
