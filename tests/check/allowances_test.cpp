// Allowances: what rounding, printed digits and single precision allow.
#include "check/allowances.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

TEST(Allowances, full_doubles_allow_only_rounding) {
  const auto allowed = allowances(std::vector{0.1234567890123456, 4.0}, 1);
  EXPECT_EQ(allowed[0].rounding, 0x1p-38);
  EXPECT_EQ(allowed[0].most, 0x1p-38);
  EXPECT_EQ(allowances(std::vector{0.1234567890123456}, 8)[0].rounding, 0x1p-37) << "the keys are larger";
}

TEST(Allowances, printed_digits_allow_a_unit_in_the_last_decimal) {
  const auto allowed = allowances(std::vector{123.45678901, 0.25, 0.0}, 1);
  for (const Allowance& one : allowed) EXPECT_NEAR(one.most, 1e-8, 1e-9);
}

TEST(Allowances, printed_digits_allow_a_unit_in_the_last_significant_digit) {
  const auto allowed = allowances(std::vector{1234.56, 0.00123456}, 1);
  EXPECT_NEAR(allowed[0].most, 0.01, 1e-8);
  EXPECT_NEAR(allowances(std::vector{12.3456789012, 0.00123456789012}, 1)[1].most, 1e-14, 2e-11) << "and rounding";
}

TEST(Allowances, nine_digits_or_single_numbers_allow_single_precision) {
  EXPECT_EQ(allowances(std::vector{1.23456789}, 2)[0].most, 0x1p-19);
  EXPECT_EQ(allowances(std::vector{static_cast<double>(1.1F)}, 2)[0].most, 0x1p-19) << "17 digits of a float";
  EXPECT_LT(allowances(std::vector{1.2345678901}, 2)[0].most, 0x1p-30);
}

TEST(Samples, have_an_allowance_for_each_number) {
  ComparisonInputs inputs;
  inputs.kept.schema.channels = {"x"};
  inputs.columns.compared = {{"x", 0, 0}};
  const KeptKeys curve;
  SampleRows rows;
  rows.numbers = {0.1234567890123456, 4};
  rows.lines = {2, 3};
  const std::vector<GivenSamples> samples = samples_of({{&curve, rows}}, inputs);
  ASSERT_EQ(samples.size(), 1U);
  ASSERT_EQ(samples[0].allowances.size(), 2U);
  EXPECT_EQ(samples[0].allowances[1].rounding, 0x1p-38) << "the largest number is 4";
}

}  // namespace
}  // namespace tcb
