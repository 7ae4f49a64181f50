// Powers of ten: every entry of the table is the exact power rounded up, and the logarithms are exact.
#include "text/power_of_ten.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

namespace tcb {
namespace {

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
