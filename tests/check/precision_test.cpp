// Precision: what printed digits and single precision allow, and the rows that are compared first of many.
#include <gmock/gmock.h>

#include "check/precision.hpp"

namespace tcb {
namespace {

constexpr std::size_t rounding = 0, printed = 1, single = 2;

TEST(Precision, full_doubles_allow_only_rounding) {
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

TEST(Precision, printed_digits_allow_a_unit_in_the_last_significant_digit) {
  const auto allowed = allowances(std::vector{1234.56, 0.00123456}, 1);
  EXPECT_NEAR(allowed[0][printed], 0.01, 1e-8);
  EXPECT_NEAR(allowed[1][printed], 1e-8, 2e-9);
}

TEST(Precision, nine_digits_or_single_numbers_allow_single_precision) {
  EXPECT_EQ(allowances(std::vector{1.23456789}, 2)[0][single], 0x1p-19);
  EXPECT_EQ(allowances(std::vector{static_cast<double>(1.1F)}, 2)[0][single], 0x1p-19) << "17 digits of a float";
  EXPECT_EQ(allowances(std::vector{1.2345678901}, 2)[0][single], 0);
}

/// A curve of the keys (i, 0) in blocks of 100, and rows at the times 0, 1/2, 1, ... between them.
struct Many {
  explicit Many(std::size_t key_count) {
    inputs.kept.schema.time.is_given = true;
    inputs.kept.schema.channels = {"x"};
    inputs.table.columns = {"x"};
    inputs.columns.compared = {{"x", 0, 0}};
    KeptKeys& curve = inputs.kept.curves.emplace_back();
    for (std::size_t key = 0; key < key_count; ++key) {
      if (key % 100 == 0) curve.blocks.emplace_back().keys.channels = 1;
      KeyBlock& block = curve.blocks.back();
      block.keys.times.emplace_back(static_cast<double>(key));
      block.keys.positions.push_back(0);
      block.text_positions.lines.push_back(key + 2);
    }
    SampleRows rows;
    for (std::size_t row = 0; row + 1 < 2 * key_count; ++row) {
      rows.times.emplace_back(0.5 * static_cast<double>(row));
      rows.numbers.push_back(static_cast<double>(row));
      rows.lines.push_back(row + 2);
    }
    samples = samples_of({{&curve, rows}}, inputs);
  }

  ComparisonInputs inputs;
  std::vector<GivenSamples> samples;
};

TEST(Samples, have_an_allowance_for_each_number) {
  const Many few(3);
  ASSERT_EQ(few.samples.size(), 1U);
  EXPECT_THAT(few.samples[0].numbers, testing::ElementsAre(1, 2, 3, 4, 5));
  ASSERT_EQ(few.samples[0].allowances.size(), 5U);
  EXPECT_EQ(few.samples[0].allowances[4][rounding], 0x1p-38) << "the largest number is 4";
}

TEST(Subset, of_few_rows_is_all_of_them) {
  const Many few(100);
  const Subset subset = subset_of(few.samples, few.inputs, {});
  EXPECT_TRUE(subset.all);
  EXPECT_EQ(count_rows(subset.samples), 199U);
}

TEST(Subset, of_an_open_curve_is_on_its_first_keys) {
  const Many many(1000);
  const Subset subset = subset_of(many.samples, many.inputs, {});
  EXPECT_FALSE(subset.all);
  ASSERT_EQ(subset.curves.size(), 1U);
  EXPECT_EQ(subset.curves[0].key_count(), 256U);
  // The tangent at the last key but one depends on the last: rows up to the third from the end, at the time 253.
  EXPECT_EQ(subset.samples[0].rows.times.back().hi, 253);
  EXPECT_EQ(count_rows(subset.samples), 507U);
}

TEST(Subset, of_a_closed_curve_is_spread_over_all_rows) {
  const Many many(1000);
  const Subset subset = subset_of(many.samples, many.inputs, {.closed = true});
  EXPECT_FALSE(subset.all);
  EXPECT_EQ(subset.samples[0].curve, many.samples[0].curve);
  const GivenSamples& rows = subset.samples[0];
  ASSERT_EQ(rows.rows.size(), 1000U);
  EXPECT_EQ(rows.allowances.size(), 1000U);
  for (std::size_t i = 1; i < 1000; ++i) {
    EXPECT_LE(rows.numbers[i] - rows.numbers[i - 1], 2U) << "of 1999 rows every other one";
  }
}

}  // namespace
}  // namespace tcb
