// Double pairs: each operation has the bits of the operation on one double.
#include "tcb/spline/double_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tcb/spline/scalar.hpp"

namespace tcb::spline {
namespace {

TEST(DoublePair, operations_have_the_bits_of_one_double) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (int i = 0; i < 1000; ++i) {
    const double a0 = uniform(random), a1 = uniform(random), b0 = uniform(random), b1 = uniform(random);
    const DoublePair a(a0, a1), b(b0, b1);
    const auto expect = [](const DoublePair& found, double first, double second) {
      EXPECT_EQ(found[0], first);
      EXPECT_EQ(found[1], second);
    };
    expect(a + b, a0 + b0, a1 + b1);
    expect(a - b, a0 - b0, a1 - b1);
    expect(a * b, a0 * b0, a1 * b1);
    expect(a / b, a0 / b0, a1 / b1);
    expect(-a, -a0, -a1);
    expect(abs(a), std::abs(a0), std::abs(a1));
    expect(sqrt(abs(a)), std::sqrt(std::abs(a0)), std::sqrt(std::abs(a1)));
    expect(min(a, b), std::min(a0, b0), std::min(a1, b1));
    expect(max(a, b), std::max(a0, b0), std::max(a1, b1));
    expect(upper_half(a), upper_half(a0), upper_half(a1));
    expect(if_positive(a, b, DoublePair(7.0)), a0 > 0 ? b0 : 7, a1 > 0 ? b1 : 7);
  }
}

TEST(DoublePair, double_doubles_have_the_bits_of_one) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> uniform(0, 4);
  const auto number = [&] { return DoubleDouble::normalized(uniform(random), 0x1p-54 * uniform(random)); };
  for (int i = 0; i < 1000; ++i) {
    const DoubleDouble a0 = number(), a1 = i % 8 == 0 ? DoubleDouble() : number(), b0 = number(), b1 = number();
    const DoubleDoublePair a = pair_of(a0, a1), b = pair_of(b0, b1);
    const auto expect = [](const DoubleDoublePair& found, const DoubleDouble& first, const DoubleDouble& second) {
      EXPECT_EQ(one_of(found, 0), first);
      EXPECT_EQ(one_of(found, 1), second);
    };
    expect(a + b, a0 + b0, a1 + b1);
    expect(a - b, a0 - b0, a1 - b1);
    expect(a * b, a0 * b0, a1 * b1);
    expect(a / b, a0 / b0, a1 / b1);
    expect(sqrt(a), sqrt(a0), sqrt(a1));
  }
}

}  // namespace
}  // namespace tcb::spline
