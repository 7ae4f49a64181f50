// Check: distances in three measures, limits, and counts of differences on a curve that is known by hand.
#include "compare/check.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "comparing.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

TEST(Distance, has_three_measures) {
  const Distance found = distance(5, 4);
  EXPECT_EQ(found.abs, 1);
  EXPECT_EQ(found.rel, 0.25);
  EXPECT_EQ(found.ulp, std::uint64_t{1} << 50U) << "a quarter of the 2^52 doubles from 4 to 8";
  EXPECT_EQ(distance(-5, -4).ulp, found.ulp);
}

TEST(Distance, counts_doubles_across_zero) {
  EXPECT_EQ(distance(0.0, -0.0).ulp, 0U);
  EXPECT_EQ(distance(tiny, -tiny).ulp, 2U);
  EXPECT_EQ(distance(tiny, 0).rel, infinity);
  EXPECT_EQ(distance(1e308, -1e308).abs, infinity) << "2e308 is beyond the doubles";
}

TEST(Distance, of_missing_numbers_is_zero_or_infinite) {
  EXPECT_EQ(distance(nan, nan).ulp, 0U);
  EXPECT_EQ(distance(nan, nan).abs, 0);
  EXPECT_EQ(distance(nan, 1).abs, infinity);
  EXPECT_EQ(distance(1, nan).ulp, std::numeric_limits<std::uint64_t>::max());
}

TEST(Limits, any_of_the_three_admits) {
  EXPECT_TRUE((Limits{0.5, {}, {}}.admit(distance(4.5, 4))));
  EXPECT_FALSE((Limits{0.49, {}, {}}.admit(distance(4.5, 4))));
  EXPECT_TRUE((Limits{0.1, 0.125, {}}.admit(distance(4.5, 4))));
  EXPECT_TRUE((Limits{{}, {}, 1}.admit(distance(std::nextafter(4, 5), 4))));
  EXPECT_FALSE((Limits{{}, {}, 1}.admit(distance(std::nextafter(4, 0), std::nextafter(4, 5)))));
  EXPECT_TRUE((Limits{}.admit(distance(4, 4)))) << "equality always does";
  EXPECT_FALSE((Limits{1e300, 1e300, 1e18}.admit(distance(nan, 4))));
}

TEST(Limits, a_tolerance_of_the_column_has_priority) {
  const Comparison comparison{"", false, {{"x", 3}, {"", 1}}, {{"y", 0.5}}, {}};
  EXPECT_EQ(limits_of(comparison, "x").abs, 3);
  EXPECT_EQ(limits_of(comparison, "y").abs, 1);
  EXPECT_EQ(limits_of(comparison, "y").rel, 0.5);
  EXPECT_FALSE(limits_of(comparison, "x").rel);
}

/// The curve x = 3t, y = 4t for t from 0 to 2, with end tangents along the chords.
constexpr auto line_keys = "t,x,y\n0,0,0\n1,3,4\n2,6,8\n";

Check check_of(Job job) {
  job.curve.ends = "chord";
  return check(job);
}

TEST(Check, passes_where_all_numbers_are_equal) {
  const Comparing files(line_keys, "t,x,y\n0.5,1.5,2\n2,6,8\n");
  const Check result = check_of(files.job);
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.rows, 2U);
  EXPECT_EQ(result.values, 4U);
  EXPECT_FALSE(result.first);
}

TEST(Check, counts_differences_and_finds_the_first_and_the_largest) {
  const Comparing files(line_keys, "t,x,y\n1.5,4.75,7\n0.5,1.5,1\n1,3,4.5\n");
  const Check result = check_of(files.job);
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(result.mismatches, 4U);
  ASSERT_EQ(result.columns.size(), 2U);
  EXPECT_EQ(result.columns[0].mismatches, 1U);
  EXPECT_EQ(result.columns[1].mismatches, 3U);
  EXPECT_EQ(result.columns[1].largest.abs, 1);
  EXPECT_EQ(result.columns[1].largest.rel, 0.5);
  EXPECT_EQ(result.first->line, 2U);
  EXPECT_EQ(result.first->column, "x");
  EXPECT_EQ(result.first->distance.abs, 0.25);
  EXPECT_EQ(result.worst->row, 1U);
  EXPECT_EQ(result.worst->column, "y");
  EXPECT_EQ(result.worst->given, 7);
  EXPECT_EQ(result.worst->computed, 6);
}

TEST(Check, admits_what_the_tolerance_of_a_column_admits) {
  Comparing files(line_keys, "t,x,y\n0.5,1.75,2.25\n");
  files.job.comparison->abs = {{"x", 0.25}};
  const Check one = check_of(files.job);
  EXPECT_EQ(one.columns[0].mismatches, 0U);
  EXPECT_EQ(one.columns[1].mismatches, 1U);
  files.job.comparison->rel = {{"", 0.125}};
  EXPECT_TRUE(check_of(files.job).passed());
}

TEST(Check, a_missing_number_differs) {
  const Comparing files(line_keys, "t,x,y\n0.5,1.5,\n");
  const Check result = check_of(files.job);
  EXPECT_EQ(result.mismatches, 1U);
  EXPECT_TRUE(std::isnan(result.first->given));
  EXPECT_EQ(result.columns[1].largest.abs, 0) << "only of rows where both have a number";
}

TEST(Check, fails_for_rows_off_the_curve) {
  const Comparing files(line_keys, "t,x,y\n0.5,1.5,2\n3,9,12\n");
  const Check result = check_of(files.job);
  EXPECT_EQ(result.mismatches, 0U);
  EXPECT_EQ(result.rows, 1U);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].code(), ErrorCode::times_off_curve);
  EXPECT_FALSE(result.passed());
}

TEST(Check, a_tolerance_needs_a_column_that_is_compared) {
  Comparing files(line_keys, "t,x\n0.5,1.5\n");
  files.job.comparison->ulp = {{"y", 1}};
  const Error error = error_of([&] { check(files.job); });
  EXPECT_EQ(error.code(), ErrorCode::tolerance_of_other_column);
  EXPECT_EQ(error.option(), Option::ulp);
  EXPECT_THAT(names_in(error, 1), ElementsAre("t", "x"));
  files.job.comparison->ulp = {{"t", 1}};
  EXPECT_THAT(check_of(files.job).problems, testing::SizeIs(1)) << "the column y is missing";
}

}  // namespace
}  // namespace tcb
