// Reports of limits: decimals around numbers and roots.
#include "limits/report.hpp"

#include <gmock/gmock.h>

#include "exact/rounding.hpp"

namespace tcb::limits {
namespace {

using testing::Pair;

auto bounds(const Rational& low, const Rational& high, bool root) {
  const auto [below, above] = decimal_bounds(low, high, root);
  return std::pair(digits_text(below, 20), digits_text(above, 20));
}

TEST(DecimalBounds, are_a_unit_of_the_last_of_15_digits_apart) {
  const Rational third = Rational(1) / 3, large = Rational(20'000'000'000'000'000);
  EXPECT_THAT(bounds(2, 2, true), Pair("1.41421356237309", "1.4142135623731"));
  EXPECT_THAT(bounds(third, third, false), Pair("0.333333333333333", "0.333333333333334"));
  EXPECT_THAT(bounds(-third, -third, false), Pair("-0.333333333333334", "-0.333333333333333"));
  EXPECT_THAT(bounds(large, large + 1, false), Pair("20000000000000000", "20000000000000100"));
}

TEST(DecimalBounds, of_a_short_decimal_are_that_decimal) {
  EXPECT_THAT(bounds(Rational(9) / 4, Rational(9) / 4, true), Pair("1.5", "1.5"));
  EXPECT_THAT(bounds(Rational(-1) / 8, Rational(-1) / 8, false), Pair("-0.125", "-0.125"));
  EXPECT_THAT(bounds(0, 0, true), Pair("0", "0"));
}

TEST(DecimalBounds, have_the_digits_that_the_numbers_allow) {
  EXPECT_THAT(bounds(Rational(1234) / 1000, Rational(1238) / 1000, false), Pair("1.23", "1.24"));
}

TEST(DecimalBounds, are_those_of_numbers_beyond_the_range_of_doubles) {
  const Rational huge = Rational(0x1p1000) * Rational(0x1p1000);  // 1.148...e602
  EXPECT_THAT(bounds(huge, huge, false), Pair("1.14813069527425e+602", "1.14813069527426e+602"));
  EXPECT_THAT(bounds(1 / huge, 1 / huge, false), Pair("8.70980981621721e-603", "8.70980981621722e-603"));
  EXPECT_THAT(bounds(huge * huge, huge * huge, true), Pair("1.14813069527425e+602", "1.14813069527426e+602"));
}

}  // namespace
}  // namespace tcb::limits
