// Ease: tabled values, its inverse, and its derivatives.
#include "tcb/spline/ease.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tcb::spline {
namespace {

double warped(double ease_out, double ease_in, double u) {
  return Warp<double>(ease_out, ease_in).at(u, DoubleDouble(1) - DoubleDouble(u)).u;
}

TEST(Warp, has_the_tabled_values) {
  constexpr std::array<std::array<double, 2>, 4> gentle{
      {{.1, .0222222222}, {.25, .138888889}, {.5, .466666667}, {.9, .966666667}}};
  for (const auto& [u, s] : gentle) EXPECT_NEAR(warped(.3, .2, u), s, 5e-10);
  constexpr std::array<std::array<double, 2>, 3> scaled{{{.1, .01875}, {.5, .46875}, {.9, .978571429}}};
  for (const auto& [u, s] : scaled) EXPECT_NEAR(warped(.8, .7, u), s, 5e-10);
}

TEST(Warp, is_the_identity_without_ease) { EXPECT_EQ(warped(0, 0, .3), .3); }

TEST(Warp, inverse_and_derivatives_agree_with_differences) {
  for (const auto& [out, in] :
       {std::array{.3, .2}, std::array{0., .5}, std::array{1., 0.}, std::array{.8, .7}, std::array{1., 1.}}) {
    const Warp<double> warp(out, in);
    for (double u = 0.03125; u < 1; u += 0.0625) {
      EXPECT_NEAR(warp.inverse(warp.at(u, DoubleDouble(1) - DoubleDouble(u))).hi, u, 1e-15);
      const double h = 0x1p-20;
      const auto at = [&](double x) { return warp.at(x, DoubleDouble(1) - DoubleDouble(x)).u; };
      EXPECT_NEAR(warp.first_derivative(u), (at(u + h) - at(u - h)) / (2 * h), 1e-5);
      EXPECT_NEAR(warp.second_derivative(u), (warp.first_derivative(u + h) - warp.first_derivative(u - h)) / (2 * h),
                  1e-3);
    }
    EXPECT_EQ(warp.at(0, 1).u, 0);
    EXPECT_EQ(warp.at(1, 0).u, 1);
  }
}

}  // namespace
}  // namespace tcb::spline
