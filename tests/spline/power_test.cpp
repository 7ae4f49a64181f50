// Powers by square roots: against products and roots that are known.
#include "tcb/spline/scalar.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tcb::spline {
namespace {

TEST(Power, of_whole_halves_and_quarters) {
  EXPECT_EQ(power(3, 0).hi, 1);
  EXPECT_EQ(power(3, 1).hi, 3);
  EXPECT_EQ(power(3, 2).hi, 9);
  EXPECT_EQ(power(9, 0.5).hi, 3);
  EXPECT_EQ(power(16, 0.75).hi, 8);
  EXPECT_EQ(power(2, 0.5).hi, std::sqrt(2.0));
}

TEST(Power, of_any_exponent) {
  for (double exponent = 0.013; exponent < 3; exponent += 0.0371) {
    for (const double x : {1e-200, 0.7, 1.0, 123.456, 1e200}) {
      if (std::abs(std::log10(x) * exponent) > 290) continue;
      EXPECT_NEAR(power(x, exponent).hi / std::pow(x, exponent), 1, 4e-16);
    }
  }
}

}  // namespace
}  // namespace tcb::spline
