// Gauss-Legendre rules: exact for polynomials, and the known nodes of small rules.
#include "tcb/spline/detail/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tcb::spline {
namespace {

TEST(GaussRule, three_nodes_agree_with_the_textbook) {
  const auto& rule = gauss_rule<double, 3>();
  EXPECT_DOUBLE_EQ(rule.node[0], 0.5 - std::sqrt(0.15));
  EXPECT_DOUBLE_EQ(rule.node[1], 0.5);
  EXPECT_DOUBLE_EQ(rule.weight[0], 5.0 / 18);
  EXPECT_DOUBLE_EQ(rule.weight[1], 4.0 / 9);
}

TEST(GaussRule, sixteen_nodes_integrate_powers_up_to_31) {
  const auto& rule = gauss_rule<double, 16>();
  for (int power = 0; power <= 31; ++power) {
    double sum = 0;
    for (std::size_t i = 0; i < 16; ++i) sum += rule.weight[i] * std::pow(rule.node[i], power);
    EXPECT_NEAR(sum * (power + 1), 1, 4e-15) << power;
  }
  double beyond = 0;
  for (std::size_t i = 0; i < 3; ++i)
    beyond += gauss_rule<double, 3>().weight[i] * std::pow(gauss_rule<double, 3>().node[i], 6);
  EXPECT_GT(std::abs(beyond * 7 - 1), 1e-4) << "three nodes cannot integrate a sixth power";
}

}  // namespace
}  // namespace tcb::spline
