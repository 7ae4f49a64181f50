// Scalars: sums, products and quotients of double-doubles against 128-bit integers, and powers by square roots.
#include "tcb/spline/scalar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tcb::spline {
namespace {

__extension__ using Int128 = __int128;

/// A DoubleDouble with whole parts as an integer.
Int128 whole(const DoubleDouble& value) { return static_cast<Int128>(value.hi) + static_cast<Int128>(value.lo); }

class DoubleDoubleTest : public testing::Test {
 protected:
  double draw() { return static_cast<double>(static_cast<std::int64_t>(random_() >> 12) - (std::int64_t{1} << 51)); }
  std::mt19937_64 random_{7};
};

TEST_F(DoubleDoubleTest, sums_and_products_of_53_bit_integers_are_exact) {
  for (int i = 0; i < 100'000; ++i) {
    const double a = draw(), b = draw();
    ASSERT_EQ(whole(DoubleDouble(a) + DoubleDouble(b)), static_cast<Int128>(a) + static_cast<Int128>(b));
    ASSERT_EQ(whole(DoubleDouble(a) * DoubleDouble(b)), static_cast<Int128>(a) * static_cast<Int128>(b));
  }
}

TEST_F(DoubleDoubleTest, quotients_times_divisors_give_the_dividends_to_100_bits) {
  for (int i = 0; i < 100'000; ++i) {
    const DoubleDouble a(draw()), b(draw());
    const DoubleDouble back = a / b * b - a;
    ASSERT_LE(std::abs(back.hi), std::abs(a.hi) * 0x1p-100);
  }
}

TEST_F(DoubleDoubleTest, products_do_not_overflow_before_the_result_does) {
  const DoubleDouble product = DoubleDouble(0x1p1000) * DoubleDouble(0x1.5p23);
  EXPECT_EQ(product.hi, 0x1.5p1023);
  EXPECT_EQ(product.lo, 0);
}

TEST_F(DoubleDoubleTest, comparisons_use_both_parts) {
  EXPECT_LT(DoubleDouble(0x1p60, -1), DoubleDouble(0x1p60));
  EXPECT_LT(DoubleDouble(0x1p60), DoubleDouble(0x1p60, 1));
}

TEST_F(DoubleDoubleTest, whole_numbers_below_and_powers_of_two) {
  EXPECT_EQ(floor(DoubleDouble(3, -0x1p-60)).hi, 2);
  EXPECT_EQ(floor(DoubleDouble(-2.5)).hi, -3);
  EXPECT_EQ(floor(DoubleDouble(0x1p60, 1.5)), DoubleDouble(0x1p60, 1));
  int exponent = 0;
  EXPECT_EQ(frexp(DoubleDouble(12, 0x1p-60), &exponent), DoubleDouble(0.75, 0x1p-64));
  EXPECT_EQ(exponent, 4);
  EXPECT_EQ(abs(DoubleDouble(-1, 0x1p-60)), DoubleDouble(1, -0x1p-60));
}

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
