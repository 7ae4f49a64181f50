// Comparisons: tolerances, and the exact refusal of what means nothing there.
#include "cli/comparison.hpp"

#include <gmock/gmock.h>

#include "cli/plan.hpp"
#include "error.hpp"

namespace tcb {
namespace {

TypedOptions checking(std::string TypedOptions::*option = &TypedOptions::check,
                      const std::string& value = "theirs.csv") {
  TypedOptions typed;
  typed.check = "theirs.csv";
  typed.files = {"keys.csv"};
  typed.*option = value;
  return typed;
}

std::string refusal(const TypedOptions& typed) {
  try {
    make_plan(typed);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.what();
  }
  return "no error";
}

TEST(Comparison, is_none_without_its_options) { EXPECT_FALSE(make_comparison(TypedOptions{})); }

TEST(Comparison, compares_all_columns_unless_fields_are_given) {
  EXPECT_TRUE(make_plan(checking()).fields.empty());
  EXPECT_FALSE(make_plan(checking()).sampling.from_left);
  EXPECT_EQ(make_plan(checking(&TypedOptions::fields, "position")).fields.size(), 1U);
  EXPECT_TRUE(make_plan(checking(&TypedOptions::side, "left")).sampling.from_left);
}

TEST(Comparison, tolerances_are_for_all_columns_or_for_one) {
  const auto comparison = make_comparison(checking(&TypedOptions::abs, "1e-9,x=0.5,a=b=2"));
  ASSERT_TRUE(comparison);
  EXPECT_FALSE(comparison->identify);
  ASSERT_EQ(comparison->abs.size(), 3U);
  EXPECT_EQ(comparison->abs[0].column, "");
  EXPECT_EQ(comparison->abs[0].most, 1e-9);
  EXPECT_EQ(comparison->abs[1].column, "x");
  EXPECT_EQ(comparison->abs[2].column, "a=b") << "a name may have the sign in it";
  EXPECT_EQ(comparison->abs[2].most, 2);
}

TEST(Comparison, tolerances_that_are_none_are_refused) {
  for (const char* value : {"-1", "x", "=1", "1,", "x=", "nan"}) {
    EXPECT_THAT(refusal(checking(&TypedOptions::ulp, value)), testing::StartsWith("--ulp \"")) << value;
  }
}

TEST(Comparison, options_that_place_samples_or_rows_are_refused) {
  for (const auto option : {&TypedOptions::step, &TypedOptions::count, &TypedOptions::at, &TypedOptions::arc_at,
                            &TypedOptions::tolerance, &TypedOptions::from, &TypedOptions::end, &TypedOptions::max_rows,
                            &TypedOptions::output_dir, &TypedOptions::list}) {
    EXPECT_THAT(refusal(checking(option, "1")), testing::HasSubstr("has no effect with --check"));
  }
}

TEST(Comparison, identify_takes_no_rules) {
  TypedOptions typed = checking(&TypedOptions::check, "");
  typed.identify = "theirs.csv";
  EXPECT_TRUE(make_comparison(typed)->identify);
  typed.curve.ends = "zero";
  EXPECT_THAT(refusal(typed), testing::HasSubstr("no effect with --identify"));
}

}  // namespace
}  // namespace tcb
