// Double-double arithmetic: sums, products and quotients against 128-bit integers.
#include "tcb/spline/scalar.hpp"

#include <gtest/gtest.h>

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

TEST_F(DoubleDoubleTest, quotients_times_divisors_come_back_to_100_bits) {
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

TEST_F(DoubleDoubleTest, order_looks_at_both_parts) {
  EXPECT_LT(DoubleDouble(0x1p60, -1), DoubleDouble(0x1p60));
  EXPECT_LT(DoubleDouble(0x1p60), DoubleDouble(0x1p60, 1));
}

}  // namespace
}  // namespace tcb::spline
