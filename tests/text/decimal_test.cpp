// Decimals: the shortest one is read back as the same double, by the easy way and by the careful one alike.
#include "text/decimal.hpp"

#include <gtest/gtest.h>

#include "text/doubles.hpp"

namespace tcb {
namespace {

bool operator==(const Decimal& a, const Decimal& b) { return a.digits == b.digits && a.exponent == b.exponent; }

Decimal trimmed(Decimal decimal) {
  for (; decimal.digits % 10 == 0; ++decimal.exponent) decimal.digits /= 10;
  return decimal;
}

void check(double value) {
  if (value <= 0) return;
  const Decimal decimal = shortest(value);
  ASSERT_GE(decimal.digits, 10'000'000'000'000'000U) << value;
  ASSERT_LT(decimal.digits, 100'000'000'000'000'000U) << value;
  if (const auto split = shortest_if_easy(value)) {
    ASSERT_LT(split->last, 10U) << value;
    ASSERT_GE(split->tens, 100'000'000'000'000U) << value;
    ASSERT_LT(split->tens, 10'000'000'000'000'000U) << value;
    ASSERT_TRUE(trimmed({split->tens * 10 + split->last, split->exponent}) == trimmed(decimal)) << value;
  }
  if (value >= std::numeric_limits<double>::min()) {
    ASSERT_EQ(nearest(decimal), value);
  } else {
    ASSERT_TRUE(std::isnan(nearest(decimal)));
  }
}

TEST(Decimals, the_shortest_one_is_read_back) {
  for_all_edges(check);
  for_hard_ones(check);
  RandomDoubles random(1);
  for (int i = 0; i < 300'000; ++i) {
    check(std::abs(random.any()));
    check(random.near());
    check(random.short_decimal());
  }
}

TEST(Decimals, most_are_easy) {
  RandomDoubles random(2);
  int easy = 0;
  for (int i = 0; i < 10'000; ++i) easy += shortest_if_easy(std::abs(random.any())) ? 1 : 0;
  EXPECT_GT(easy, 9'950);
  EXPECT_TRUE(shortest_if_easy(0.1));
  EXPECT_TRUE(shortest_if_easy(3));
  for (const double value : {0.0, 0.25, 2.0, 5e-324, 2251799813685248.25, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(shortest_if_easy(value)) << value;
  }
}

TEST(Decimals, numbers_are_widened_to_17_digits) {
  for (int n = 0; n < 17; ++n) {
    for (const std::uint64_t digits : {whole_power_of_ten(n), whole_power_of_ten(n + 1) - 1}) {
      const Decimal wide = widened({digits, 5});
      EXPECT_EQ(wide.digits, digits * whole_power_of_ten(16 - n));
      EXPECT_EQ(wide.exponent, 5 - (16 - n));
    }
  }
}

TEST(Decimals, integers_are_rounded_half_to_even) {
  EXPECT_EQ(rounded(0.5, 0), 0U);
  EXPECT_EQ(rounded(1.5, 0), 2U);
  EXPECT_EQ(rounded(2.5, 0), 2U);
  EXPECT_EQ(rounded(0.125, 2), 12U);
  EXPECT_EQ(rounded(0.375, 2), 38U);
  EXPECT_EQ(rounded(0.1, 17), 10'000'000'000'000'001U);
  EXPECT_EQ(rounded(2.675, 2), 267U) << "the double is below 2.675";
  EXPECT_EQ(rounded(1e22, -20), 100U);
  EXPECT_EQ(rounded(1e-300, 0), 0U);
  EXPECT_EQ(rounded(0.49999999999999994, 0), 0U);
  EXPECT_EQ(rounded(0.50000000000000011, 0), 1U);
}

TEST(Decimals, the_nearest_double_is_unknown_beyond_the_normal_ones) {
  EXPECT_EQ(nearest({17976931348623157, 292}), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isnan(nearest({17976931348623159, 292})));
  EXPECT_TRUE(std::isnan(nearest({1, 309})));
  EXPECT_TRUE(std::isnan(nearest({1, -400})));
  EXPECT_EQ(nearest({22250738585072014, -324}), std::numeric_limits<double>::min());
  EXPECT_EQ(nearest({9007199254740993, 0}), 9007199254740992.0) << "half to even";
  EXPECT_EQ(nearest({9007199254740995, 0}), 9007199254740996.0) << "half to even";
}

}  // namespace
}  // namespace tcb
