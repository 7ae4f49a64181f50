// Precision: what printed digits and single precision allow.
#include "compare/precision.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

constexpr std::size_t rounding = 0, printed = 1, single = 2;

TEST(Precision, full_doubles_allow_rounding_alone) {
  const auto allowed = allowances(std::vector{0.1234567890123456, 4.0}, 1);
  EXPECT_EQ(allowed[0][rounding], 0x1p-38);
  EXPECT_EQ(allowed[0][printed], 0);
  EXPECT_EQ(allowed[0][single], 0);
  EXPECT_EQ(allowances(std::vector{0.1234567890123456}, 8)[0][rounding], 0x1p-37) << "the keys are larger";
}

TEST(Precision, printed_digits_allow_a_unit_in_the_last_decimal) {
  const auto allowed = allowances(std::vector{123.456789, 0.25, 0.0}, 1);
  for (const Allowance& one : allowed) EXPECT_NEAR(one[printed], 1e-6, 1e-9);
}

TEST(Precision, or_in_the_last_significant_digit) {
  const auto allowed = allowances(std::vector{1234.56, 0.00123456}, 1);
  EXPECT_NEAR(allowed[0][printed], 0.01, 1e-8);
  EXPECT_NEAR(allowed[1][printed], 1e-8, 2e-9);
}

TEST(Precision, nine_digits_or_single_numbers_allow_single_precision) {
  EXPECT_EQ(allowances(std::vector{1.23456789}, 2)[0][single], 0x1p-19);
  EXPECT_EQ(allowances(std::vector{static_cast<double>(1.1F)}, 2)[0][single], 0x1p-19) << "17 digits of a float";
  EXPECT_EQ(allowances(std::vector{1.2345678901}, 2)[0][single], 0);
}

}  // namespace
}  // namespace tcb
