// Ease: tabled values, its inverse, and its derivatives.
#include "tcb/spline/ease.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(Warp, parts_are_told_at_their_ends_by_the_side) {
  const Warp<double> warp(0.25, 0.5);
  const auto part = [&](double u, Side side) { return warp.part(u, side); };
  EXPECT_EQ(part(0.25, Side::left), EasePart::first);
  EXPECT_EQ(part(0.25, Side::right), EasePart::middle);
  EXPECT_EQ(part(0.5, Side::left), EasePart::middle);
  EXPECT_EQ(part(0.5, Side::right), EasePart::last);
  EXPECT_EQ(Warp<double>(1, 0).part(1.0, Side::right), EasePart::first) << "the end of the segment";
  EXPECT_EQ(Warp<double>(0, 1).part(0.0, Side::left), EasePart::last);
  EXPECT_EQ(Warp<double>(0, 0.5).part(0.0, Side::left), EasePart::middle);
  const double third = 1.0 / 3;  // 3 third is not 1, but the product is exact
  EXPECT_EQ(Warp<double>(third, 0).part(1, 2, 3, Side::left), EasePart::middle);
  EXPECT_EQ(Warp<double>(third, 0).part(DoubleDouble(third) * DoubleDouble(3), 2, 3, Side::left), EasePart::first);
}

TEST(CubicWarp, has_the_values_of_its_polynomial) {
  const auto warp = Warp<double>::cubic(1.5, 0.25);
  EXPECT_EQ(warp.at(0.5, 0.5).u, 0.65625);  // u (a + u (3 - 2a - b + u (a + b - 2)))
  EXPECT_EQ(warp.at(0.25, 0.75).u, 0.25 * (1.5 + 0.25 * (-0.25 - 0.0625)));
  EXPECT_EQ(warp.at(0.875, 0.125).w, -0.125 * (0.25 + 0.125 * (1 - 0.03125)));
  EXPECT_TRUE(Warp<double>::cubic(1, 1).is_identity());
}

TEST(CubicWarp, inverse_and_derivatives_agree_with_it) {
  for (const auto& [first, last] :
       {std::array{1.5, 0.25}, std::array{0., 3.}, std::array{0., 0.}, std::array{3., 3.}}) {
    const auto warp = Warp<double>::cubic(first, last);
    const auto at = [&](double x) { return warp.at(x, DoubleDouble(1) - DoubleDouble(x)); };
    EXPECT_EQ(at(0).u, 0);
    EXPECT_EQ(at(1).w, 0);
    EXPECT_EQ(warp.first_derivative(0), first);
    EXPECT_EQ(warp.first_derivative(1), last);
    for (double u = 0.03125; u < 1; u += 0.0625) {
      EXPECT_NEAR(warp.inverse(at(u)).hi, u, 1e-15 / std::min(1.0, warp.first_derivative(u)));
      const double h = 0x1p-20;
      EXPECT_NEAR(warp.first_derivative(u), (at(u + h).u - at(u - h).u) / (2 * h), 1e-5);
      EXPECT_NEAR(warp.second_derivative(u), (warp.first_derivative(u + h) - warp.first_derivative(u - h)) / (2 * h),
                  1e-5);
      EXPECT_NEAR(warp.third_derivative(), (warp.second_derivative(u + h) - warp.second_derivative(u - h)) / (2 * h),
                  1e-5);
    }
  }
}

TEST(CubicWarp, inverse_is_found_where_the_slope_is_0) {
  const auto warp = Warp<double>::cubic(0, 0);  // 3 u^2 - 2 u^3
  EXPECT_NEAR(warp.inverse({3e-20 - 2e-30, -1}).hi, 1e-10, 1e-24);
  EXPECT_EQ(warp.inverse({0, -1}).hi, 0);
  EXPECT_EQ(warp.inverse({1, 0}).hi, 1);
}

}  // namespace
}  // namespace tcb::spline
