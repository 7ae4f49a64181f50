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

template <std::size_t N>
void expect_computed() {
  const auto &rule = gauss_rule<double, N>(), computed = make_gauss_rule<double, N>();
  EXPECT_EQ(rule.node, computed.node);
  EXPECT_EQ(rule.weight, computed.weight);
}

TEST(GaussRule, tables_have_the_computed_numbers) {
  expect_computed<8>();
  expect_computed<12>();
  expect_computed<16>();
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
