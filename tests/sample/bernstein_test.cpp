// Bernstein form: coefficients, parts and bounds agree with the polynomial.
#include "sample/bernstein.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tcb {
namespace {

using Powers = std::array<double, 7>;

double value(const Powers& powers, double s) {
  double sum = 0;
  for (std::size_t k = powers.size(); k-- > 0;) sum = sum * s + powers[k];
  return sum;
}

Powers random_powers(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  Powers powers{};
  for (double& power : powers) power = number(random);
  return powers;
}

TEST(Bernstein, parts_have_the_values_of_the_whole_at_their_ends) {
  std::mt19937_64 random(31);
  for (int round = 0; round < 100; ++round) {
    const Powers powers = random_powers(random);
    const auto whole = bernstein(powers);
    for (double s = 0; s <= 1; s += 1.0 / 16) {
      const auto [before, after] = split(whole, s);
      EXPECT_NEAR(before.front(), value(powers, 0), 1e-14);
      EXPECT_NEAR(before.back(), value(powers, s), 1e-14);
      EXPECT_NEAR(after.front(), value(powers, s), 1e-14);
      EXPECT_NEAR(after.back(), value(powers, 1), 1e-14);
    }
  }
}

TEST(Bernstein, the_upper_bound_is_the_maximum) {
  std::mt19937_64 random(32);
  for (int round = 0; round < 1000; ++round) {
    const Powers powers = random_powers(random);
    double largest = 0;  // known
    constexpr int places = 4096;
    for (int i = 0; i <= places; ++i) largest = std::max(largest, value(powers, static_cast<double>(i) / places));
    int parts = 1000;
    const double bound = upper_bound(bernstein(powers), 0, parts);
    EXPECT_GE(bound, largest - 1e-14);
    EXPECT_LE(bound, largest + 1e-6);  // what places miss: |p''| <= 100 here, a quarter of a step away
  }
}

TEST(Bernstein, the_upper_bound_is_a_bound_however_few_parts_are_tried) {
  std::mt19937_64 random(33);
  for (int round = 0; round < 1000; ++round) {
    const Powers powers = random_powers(random);
    int parts = round % 4;
    const double bound = upper_bound(bernstein(powers), 0, parts);
    for (double s = 0; s <= 1; s += 1.0 / 256) EXPECT_GE(bound, value(powers, s) - 1e-14);
  }
}

}  // namespace
}  // namespace tcb
