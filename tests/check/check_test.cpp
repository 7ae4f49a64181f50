// Check: distances in three measures, limits, and counts of differences on a curve that is known by hand.
#include "check/check.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "comparing.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/build.hpp"

namespace tcb {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

KeptInput curves_of(const std::vector<std::string>& groups) {
  KeptInput kept;
  kept.schema.groups = {"id"};
  for (const std::string& group : groups) kept.curves.push_back({{group}, nullptr, {}});
  return kept;
}

SampleRows row_of(const std::string& group, double number, std::uint64_t line) {
  return {{group}, {spline::Time<double>(0.0)}, {number}, {line}};
}

SampleTable table_of(std::vector<SampleRows> curves) { return {true, true, "t", {"x"}, {}, std::move(curves)}; }

TEST(Pairs, a_single_curve_takes_all_rows) {
  const KeptInput kept = curves_of({""});
  SampleTable table = table_of({row_of("", 5, 2), row_of("", 4, 9)});
  const Pairs pairs = pair_up(kept, table);
  ASSERT_EQ(pairs.pairs.size(), 1U);
  EXPECT_THAT(pairs.pairs[0].rows.numbers, ElementsAre(5, 4));
  EXPECT_THAT(pairs.pairs[0].rows.lines, ElementsAre(2, 9));
  EXPECT_THAT(pairs.problems, IsEmpty());
}

/// The curve (3t, 4t) for t from 0 to 2, which has the length 10, and a file of rows on it.
class Line {
 public:
  explicit Line(const std::string& rows, const std::optional<Extrapolations>& extrapolate = {})
      : files_("t,x,y\n0,0,0\n1,3,4\n2,6,8\n", rows) {
    Comparison& comparison = files_.comparison;
    comparison.keys.rules.ends = {ends_in("chord"), {}};
    comparison.keys.rules.extrapolate = extrapolate;
    inputs = read_inputs(comparison, {});
    request_.mode = inputs.columns.by_length ? Mode::arc_at : Mode::at;
    const KeptKeys& curve = inputs.kept.curves.at(0);
    CurvePipeline pipeline({request_, comparison.keys.rules, inputs.columns.fields}, inputs.kept.schema,
                           inputs.kept.traits, *curve.curve_info);
    indexed = pipeline.kept(curve.keys());
  }

  Places places(const Limits& limits = {}) const {
    return places_of(inputs.table.curves.at(0), inputs.columns, *indexed, limits);
  }

  ComparisonInputs inputs;
  std::shared_ptr<const KeptCurve> indexed;

 private:
  Comparing files_;
  SamplingRequest request_;
};

TEST(PlacesOfSamples, are_times_on_the_curve) {
  const Line line("t,x\n1,3\n-1,0\n2.5,0\n2,6\n");
  const Places places = line.places();
  EXPECT_THAT(places.rows, ElementsAre(0, 3));
  ASSERT_TRUE(places.off_curve);
  EXPECT_EQ(*places.off_curve,
            "rows outside the curve: 2; the first, in line 3, has time -1; the nearest time of the curve is 0");
}

TEST(PlacesOfSamples, a_missing_arc_length_is_on_no_curve) {
  const Places places = Line("s,x\n,0\n5,3\n").places();
  EXPECT_THAT(places.rows, ElementsAre(1));
  ASSERT_TRUE(places.off_curve);
  EXPECT_THAT(*places.off_curve, testing::StartsWith("rows without a time or arc length: "));
}

TEST(PlacesOfSamples, near_an_end_within_the_limits_are_that_end) {
  const Line line("t,x\n2.001,6\n");
  EXPECT_TRUE(line.places({1e-4, {}, {}}).off_curve);
  const Places near = line.places({1e-2, {}, {}});
  EXPECT_FALSE(near.off_curve);
  EXPECT_EQ(near.places.at(0).hi, 2);
}

TEST(PlacesOfSamples, outside_the_curve_are_allowed_by_extrapolation) {
  const Places places = Line("t,x\n-1,0\n7,6\n", Extrapolations{Extrapolation::hold, Extrapolation::hold}).places();
  EXPECT_THAT(places.rows, ElementsAre(0, 1));
  EXPECT_EQ(places.places[1].hi, 7) << "it stays where it is";
}

TEST(PlacesOfSamples, by_arc_length_end_with_the_length) {
  const Line line("s,x\n5,3\n10.5,6\n");
  const Places places = line.places();
  EXPECT_THAT(places.rows, ElementsAre(0));
  ASSERT_TRUE(places.off_curve);
  EXPECT_THAT(*places.off_curve, testing::HasSubstr("has arc length 10.5;"));
}

/// All cells of the rows that are on the curve, row after row.
std::vector<double> cells_of(const Line& line, std::vector<std::size_t>& rows) {
  std::vector<double> cells;
  for_each_row(line.inputs.table.curves.at(0), line.places(), line.inputs.columns, line.indexed, spline::Side::left, 2,
               [&](std::size_t row, std::span<const Cell> of_row) {
                 rows.push_back(row);
                 for (const Cell& cell : of_row) cells.push_back(cell.hi);
               });
  return cells;
}

TEST(Rows, of_the_curve_are_at_the_places_in_the_order_of_the_file) {
  std::vector<std::size_t> rows;
  const auto cells = cells_of(Line("t,x,y,x_v,y_v\n1.5,0,0,0,0\n9,0,0,0,0\n0.5,0,0,0,0\n"), rows);
  EXPECT_THAT(rows, ElementsAre(0, 2));
  EXPECT_THAT(cells, ElementsAre(4.5, 6, 3, 4, 1.5, 2, 3, 4));
  rows.clear();
  const auto by_length = cells_of(Line("s,x,y\n7.5,0,0\n2.5,0,0\n"), rows);
  EXPECT_THAT(by_length, testing::Pointwise(testing::DoubleNear(1e-14), {4.5, 6.0, 1.5, 2.0}));
}

TEST(Rows, of_many_places_keep_their_order_over_all_blocks) {
  std::string file = "t,x\n";
  constexpr std::size_t count = 3000;
  const auto time = [](std::size_t row) { return static_cast<double>((row * 7) % 2000) / 1000; };
  for (std::size_t i = 0; i < count; ++i) file += std::to_string((i * 7) % 2000) + "e-3,0\n";
  const Line line(file);
  std::size_t next = 0;
  for_each_row(line.inputs.table.curves.at(0), line.places(), line.inputs.columns, line.indexed, spline::Side::left, 2,
               [&](std::size_t row, std::span<const Cell> cells) {
                 EXPECT_EQ(row, next++);
                 EXPECT_NEAR(cells[0].hi, 3 * time(row), 1e-13);
               });
  EXPECT_EQ(next, count);
}

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

TEST(Limits, one_of_the_three_suffices) {
  EXPECT_TRUE((Limits{0.5, {}, {}}.admit(distance(4.5, 4))));
  EXPECT_FALSE((Limits{0.49, {}, {}}.admit(distance(4.5, 4))));
  EXPECT_TRUE((Limits{0.1, 0.125, {}}.admit(distance(4.5, 4))));
  EXPECT_TRUE((Limits{{}, {}, 1}.admit(distance(std::nextafter(4, 5), 4))));
  EXPECT_FALSE((Limits{{}, {}, 1}.admit(distance(std::nextafter(4, 0), std::nextafter(4, 5)))));
  EXPECT_TRUE((Limits{}.admit(distance(4, 4)))) << "equality always does";
  EXPECT_FALSE((Limits{1e300, 1e300, 1e18}.admit(distance(nan, 4))));
}

TEST(Limits, a_tolerance_of_the_column_has_priority) {
  Comparison comparison;
  comparison.abs = {{"x", 3}, {"", 1}};
  comparison.rel = {{"y", 0.5}};
  EXPECT_EQ(limits_of(comparison, "x").abs, 3);
  EXPECT_EQ(limits_of(comparison, "y").abs, 1);
  EXPECT_EQ(limits_of(comparison, "y").rel, 0.5);
  EXPECT_FALSE(limits_of(comparison, "x").rel);
}

/// The curve x = 3t, y = 4t for t from 0 to 2, with end tangents along the chords.
constexpr auto line_keys = "t,x,y\n0,0,0\n1,3,4\n2,6,8\n";

Check check_of(Comparison comparison) {
  comparison.keys.rules.ends = {ends_in("chord"), {}};
  return check(comparison, read_inputs(comparison, comparison.fields));
}

TEST(Check, accepts_numbers_within_the_tolerance_of_their_column) {
  Comparing files(line_keys, "t,x,y\n0.5,1.75,2.25\n");
  files.comparison.abs = {{"x", 0.25}};
  const Check one = check_of(files.comparison);
  EXPECT_EQ(one.columns[0].mismatches, 0U);
  EXPECT_EQ(one.columns[1].mismatches, 1U);
  files.comparison.rel = {{"", 0.125}};
  EXPECT_TRUE(check_of(files.comparison).passed());
}

TEST(Check, a_missing_number_differs) {
  const Comparing files(line_keys, "t,x,y\n0.5,1.5,\n");
  const Check result = check_of(files.comparison);
  EXPECT_EQ(result.mismatches, 1U);
  EXPECT_TRUE(std::isnan(result.first->given));
  EXPECT_EQ(result.columns[1].largest.abs, 0) << "only of rows where both have a number";
}

}  // namespace

}  // namespace tcb
