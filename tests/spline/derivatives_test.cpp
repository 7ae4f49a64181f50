// Derivatives: derivatives, curvature and torsion of curves whose shape is known.
#include "tcb/spline/derivatives.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace tcb::spline {
namespace {

/// The cubics of (p u + q u^2 + r u^3), one per channel.
std::vector<Cubic<double>> polynomial(const std::vector<std::array<double, 3>>& channels) {
  std::vector<Cubic<double>> cubics;
  for (const auto& [p, q, r] : channels) cubics.push_back(cubic<double>(0, p + q + r, p, p + 2 * q + 3 * r));
  return cubics;
}

Derivatives<double> derivatives_at(const std::vector<Cubic<double>>& cubics, double u, double h = 1,
                                   const Warp<double>& warp = {}) {
  Derivatives<double> of;
  set_derivatives<double>(of, cubics, warp.at(u, DoubleDouble(1) - DoubleDouble(u)), warp, u, h);
  return of;
}

TEST(Derivatives, are_per_unit_of_time) {
  const auto of = derivatives_at(polynomial({{1, 2, 3}}), 0.25, 2);  // x' = 1 + 4u + 9u^2, x'' = 4 + 18u, x''' = 18
  EXPECT_DOUBLE_EQ(of.velocity[0], (1 + 1 + 9.0 / 16) / 2);
  EXPECT_DOUBLE_EQ(of.acceleration[0], (4 + 4.5) / 4);
  EXPECT_DOUBLE_EQ(of.jerk[0], 18.0 / 8);
}

TEST(Derivatives, follow_the_warp_of_an_ease) {
  const auto cubics = polynomial({{1, 2, 3}});
  const Warp<double> warp(0.5, 0.25);
  const auto position_at = [&](double u) { return position(cubics[0], warp.at(u, DoubleDouble(1) - DoubleDouble(u))); };
  for (const double u : {0.2, 0.6, 0.9}) {
    const auto of = derivatives_at(cubics, u, 1, warp);
    const double h = 1e-4;
    EXPECT_NEAR(of.velocity[0], (position_at(u + h) - position_at(u - h)) / (2 * h), 1e-5);
    EXPECT_NEAR(of.acceleration[0], (position_at(u + h) - 2 * position_at(u) + position_at(u - h)) / (h * h), 1e-4);
  }
}

TEST(Derivatives, of_all_orders_follow_a_cubic_warp) {
  const auto cubics = polynomial({{1, 2, 3}});
  const double a = 0.5, b = 1.25, h = 2;
  const auto warp = Warp<double>::cubic(a, b);
  std::array<double, 10> composed{}, power{1};  // x(w(v)), and w(v)^n
  const std::array<double, 4> w{0, a, 3 - 2 * a - b, a + b - 2};
  for (const double factor : {0.0, 1.0, 2.0, 3.0}) {
    std::array<double, 10> next{};
    for (std::size_t i = 0; i < composed.size(); ++i) {
      composed[i] += factor * power[i];
      for (std::size_t k = 0; k < w.size() && i + k < next.size(); ++k) next[i + k] += power[i] * w[k];
    }
    power = next;
  }
  for (const double v : {0.0, 0.25, 0.75, 1.0}) {
    for (std::size_t order = 1; order <= 10; ++order) {
      double expected = 0;
      for (std::size_t i = order; i < composed.size(); ++i) {
        double term =
            composed[i] * std::pow(v, static_cast<double>(i - order)) / std::pow(h, static_cast<double>(order));
        for (std::size_t k = 0; k < order; ++k) term *= static_cast<double>(i - k);
        expected += term;
      }
      const double found = time_derivative(order, cubics[0], warp.at(v, 1 - v), warp, v, h);
      EXPECT_NEAR(found, expected, 1e-12 * std::max(1.0, std::abs(expected))) << order << " at " << v;
    }
    const auto of = derivatives_at(cubics, v, h, warp);
    EXPECT_NEAR(of.jerk[0], time_derivative(3, cubics[0], warp.at(v, 1 - v), warp, v, h), 1e-12);
  }
}

TEST(Shape, of_a_parabola) {
  for (const double u : {0.0, 0.3, 0.9}) {  // y = x^2: curvature 2 / (1 + 4 x^2)^1.5
    const auto of = derivatives_at(polynomial({{1, 0, 0}, {0, 1, 0}}), u);
    EXPECT_NEAR(*shape<double>(of, {}).curvature, 2 / std::pow(1 + 4 * u * u, 1.5), 1e-15);
    EXPECT_EQ(*torsion<double>(of, {}), 0);
  }
}

TEST(Shape, of_the_twisted_cubic) {
  // (u, u^2, u^3): torsion 3 / (9 u^4 + 9 u^2 + 1), curvature 2 sqrt(9 u^4 + 9 u^2 + 1) / (1 + 4 u^2 + 9 u^4)^1.5
  for (const double u : {0.0, 0.25, 0.5, 1.0}) {
    const double g = 9 * std::pow(u, 4) + 9 * u * u + 1;
    const auto of = derivatives_at(polynomial({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), u);
    EXPECT_NEAR(*torsion<double>(of, {}), 3 / g, 1e-14);
    EXPECT_NEAR(*shape<double>(of, {}).curvature, 2 * std::sqrt(g) / std::pow(1 + 4 * u * u + 9 * std::pow(u, 4), 1.5),
                1e-14);
    const auto mirrored = derivatives_at(polynomial({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}), u);
    EXPECT_NEAR(*torsion<double>(mirrored, {}), -3 / g, 1e-14);
    const auto in_four = derivatives_at(polynomial({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}}), u);
    EXPECT_NEAR(*torsion<double>(in_four, {}), 3 / g, 1e-14);
  }
}

TEST(Shape, of_a_straight_line_has_no_curvature_and_an_undefined_torsion) {
  const auto of = derivatives_at(polynomial({{0.1, 0.7, -0.2}, {0.3, 2.1, -0.6}, {-0.01, -0.07, 0.02}}), 0.37);
  EXPECT_EQ(shape<double>(of, {}).curvature, 0);
  EXPECT_FALSE(torsion<double>(of, {}));
}

TEST(Shape, scaling_by_a_power_of_two_changes_no_digit) {
  const auto scaled = [](int exponent) {
    const double unit = std::ldexp(1, exponent);
    return derivatives_at(polynomial({{unit, 0.3 * unit, 0}, {0.1 * unit, unit, -0.7 * unit}, {0, 0.2 * unit, unit}}),
                          0.3);
  };
  const auto expected = shape<double>(scaled(0), {});
  for (const int exponent : {-950, -600, -200, -1, 40, 300, 700, 1000}) {
    const auto found = shape<double>(scaled(exponent), {});
    EXPECT_EQ(found.speed, std::ldexp(expected.speed, exponent)) << exponent;
    EXPECT_EQ(found.curvature, std::ldexp(*expected.curvature, -exponent)) << exponent;
    EXPECT_EQ(torsion<double>(scaled(exponent), {}), std::ldexp(*torsion<double>(scaled(0), {}), -exponent))
        << exponent;
  }
}

TEST(Shape, of_zero_velocity_is_undefined) {
  const auto found = shape<double>(derivatives_at(polynomial({{0, 1, 0}, {0, 0, 1}}), 0), {});
  EXPECT_EQ(found.speed, 0);
  EXPECT_FALSE(found.moves);
  EXPECT_FALSE(found.curvature);
}

TEST(Shape, is_that_of_the_metric_channels) {
  const std::array<std::size_t, 2> metric{0, 2};
  const auto found = shape<double>(derivatives_at(polynomial({{3, 0, 0}, {100, 7, 0}, {4, 0, 0}}), 0.5), metric);
  EXPECT_EQ(found.speed, 5);
  EXPECT_EQ(found.curvature, 0);
}

}  // namespace
}  // namespace tcb::spline
