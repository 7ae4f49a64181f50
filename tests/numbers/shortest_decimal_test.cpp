// Shortest decimals: powers of ten, decimals that read back as the same double, and digits as text.
#include "numbers/shortest_decimal.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cstring>
#include <random>
#include <string>

#include "numbers/doubles.hpp"
#include "numbers/parse_number.hpp"

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
  ASSERT_EQ(parse_number(std::to_string(decimal.digits) + "e" + std::to_string(decimal.exponent)), value);
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

std::string eight(std::uint64_t n) {
  const std::string digits = std::to_string(n);
  return std::string(8 - digits.size(), '0') + digits;
}

TEST(Digits, eight_digits_are_their_text) {
  for (std::uint64_t n = 0; n < 100'000'000; n = n < 200'000 ? n + 1 : n + 997) {
    const std::uint64_t digits = eight_digits(n);
    std::uint64_t expected = 0;
    std::memcpy(&expected, eight(n).data(), sizeof expected);
    ASSERT_EQ(expected, digits | eight_zeros);
  }
}

TEST(Digits, one_of_two_is_chosen) {
  EXPECT_EQ(choose(true, 1, 2), 1U);
  EXPECT_EQ(choose(false, 1, 2), 2U);
}

template <class Sixteen>
class SixteenDigitsOf : public testing::Test {};

using Kinds = testing::Types<SixteenDigitsInWords, SixteenDigits>;
TYPED_TEST_SUITE(SixteenDigitsOf, Kinds);

template <class Sixteen>
void check_sixteen(std::uint64_t n) {
  std::string expected = std::to_string(n);
  expected.insert(0, 16 - expected.size(), '0');
  const Sixteen digits(n);
  std::string text(17, '#');
  digits.write(text.data());
  ASSERT_EQ(text, expected + '#');
  const auto last = expected.find_last_not_of('0');
  ASSERT_EQ(digits.count(false), last == std::string::npos ? 1 : static_cast<int>(last) + 1) << n;
  ASSERT_EQ(digits.count(true), 17) << n;
}

TYPED_TEST(SixteenDigitsOf, numbers_small_and_large_are_their_text) {
  std::uint64_t power = 1;
  for (int i = 0; i <= 16; ++i, power *= 10) {
    for (std::uint64_t digit = 1; digit < 10 && i < 16; ++digit) check_sixteen<TypeParam>(digit * power);
    check_sixteen<TypeParam>(power - 1);
  }
  std::mt19937_64 random(1);
  for (int i = 0; i < 300'000; ++i) check_sixteen<TypeParam>(random() % 10'000'000'000'000'000);
}

TYPED_TEST(SixteenDigitsOf, each_four_are_their_text) {
  for (std::uint64_t n = 0; n < 10'000; ++n) {
    check_sixteen<TypeParam>(n + 10'000 * (9999 - n) + 100'000'000 * n + 1'000'000'000'000 * (9999 - n));
  }
}

using boost::multiprecision::cpp_int;

cpp_int power(int base, int exponent) { return pow(cpp_int(base), static_cast<unsigned>(exponent)); }

/// floor(log2 a/b), for positive a and b.
int floor_log2(const cpp_int& a, const cpp_int& b) {
  const int about = static_cast<int>(msb(a)) - static_cast<int>(msb(b));
  const bool less = about >= 0 ? a < (b << about) : (a << -about) < b;
  return less ? about - 1 : about;
}

TEST(PowersOfTen, each_is_the_exact_power_rounded_up_to_128_bits) {
  for (int p = least_power; p <= most_power; ++p) {
    const cpp_int above = p < 0 ? 1 : power(10, p);
    const cpp_int below = p < 0 ? power(10, -p) : 1;
    const int shift = 127 - floor_log2(above, below);
    const cpp_int dividend = shift > 0 ? above << shift : above;
    const cpp_int divisor = shift < 0 ? below << -shift : below;
    const cpp_int expected = (dividend + divisor - 1) / divisor;
    ASSERT_EQ(cpp_int(power_significand(p)), expected) << p;
  }
}

TEST(PowersOfTen, logarithms_are_rounded_down) {
  for (int p = -400; p <= 400; ++p) {
    const int exact = p < 0 ? floor_log2(1, power(10, -p)) : floor_log2(power(10, p), 1);
    ASSERT_EQ(floor_log2_power_of_ten(p), exact) << p;
  }
  for (int q = -1200; q <= 1200; ++q) {
    // 10^k 2^-q <= 1 or 3/4: no power of ten is a power of two but 1.
    const auto fits = [&](int k, int numerator, int denominator) {
      cpp_int left = denominator * (k >= 0 ? power(10, k) : cpp_int(1)) * (q < 0 ? power(2, -q) : cpp_int(1));
      cpp_int right = numerator * (k < 0 ? power(10, -k) : cpp_int(1)) * (q >= 0 ? power(2, q) : cpp_int(1));
      return left <= right;
    };
    const int k = floor_log10_power_of_two(q);
    ASSERT_TRUE(fits(k, 1, 1) && !fits(k + 1, 1, 1)) << q;
    const int l = floor_log10_of_three_quarters(q);
    ASSERT_TRUE(fits(l, 3, 4) && !fits(l + 1, 3, 4)) << q;
  }
}

TEST(PowersOfTen, a_product_keeps_its_upper_128_bits) {
  const Uint128 g = power_significand(-200);
  for (const std::uint64_t x : {std::uint64_t{1}, std::uint64_t{1} << 63, ~std::uint64_t{0}}) {
    EXPECT_EQ(cpp_int(high_product(x, g)), (cpp_int(g) * x) >> 64);
  }
}

}  // namespace
}  // namespace tcb
