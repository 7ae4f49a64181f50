// Match: pairs of curves and rows, the places of rows, and the rows of a curve that is known by hand.
#include "compare/match.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "comparing.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

KeptCurves curves_of(const std::vector<std::string>& groups) {
  KeptCurves kept;
  kept.input.groups = {"id"};
  for (const std::string& group : groups) kept.curves.push_back({{group}, nullptr, {}});
  return kept;
}

SampleRows row_of(const std::string& group, double number, std::uint64_t line) {
  return {{group}, {spline::Time<double>(0.0)}, {number}, {line}};
}

SampleTable table_of(std::vector<SampleRows> curves) { return {true, true, "t", {"x"}, {}, std::move(curves)}; }

TEST(Pairs, go_by_group_whatever_the_format_of_its_text) {
  const KeptCurves kept = curves_of({"\"1", "\"b"});
  SampleTable table = table_of({row_of("\"b", 5, 2), row_of("1", 4, 3)});
  const Pairs pairs = pair_up(kept, table);
  ASSERT_EQ(pairs.pairs.size(), 2U);
  EXPECT_EQ(pairs.pairs[0].curve, &kept.curves[0]);
  EXPECT_THAT(pairs.pairs[0].rows.numbers, ElementsAre(4));
  EXPECT_THAT(pairs.pairs[1].rows.numbers, ElementsAre(5));
  EXPECT_THAT(pairs.problems, IsEmpty());
}

TEST(Pairs, curves_of_one_file_only_are_problems) {
  const KeptCurves kept = curves_of({"\"a", "\"b"});
  SampleTable table = table_of({row_of("\"b", 5, 2), row_of("\"c", 4, 7)});
  const Pairs pairs = pair_up(kept, table);
  EXPECT_EQ(pairs.pairs.size(), 1U);
  ASSERT_EQ(pairs.problems.size(), 2U);
  EXPECT_EQ(pairs.problems[0].code(), ErrorCode::curve_without_rows);
  EXPECT_THAT(names_in(pairs.problems[0], 0), ElementsAre("id=a"));
  EXPECT_EQ(pairs.problems[1].code(), ErrorCode::rows_without_keys);
  EXPECT_THAT(names_in(pairs.problems[1], 0), ElementsAre("id=c"));
  EXPECT_EQ(std::get<std::uint64_t>(pairs.problems[1].values().at(1)), 7U);
}

TEST(Pairs, go_by_order_where_a_file_has_no_groups) {
  const KeptCurves kept = curves_of({"\"a", "\"b", "\"c"});
  SampleTable table = table_of({row_of("", 5, 2), row_of("", 4, 3)});
  const Pairs pairs = pair_up(kept, table);
  ASSERT_EQ(pairs.pairs.size(), 2U);
  EXPECT_THAT(pairs.pairs[1].rows.numbers, ElementsAre(4));
  ASSERT_EQ(pairs.problems.size(), 1U);
  EXPECT_EQ(pairs.problems[0].code(), ErrorCode::curve_counts);
  std::vector<std::uint64_t> counts;
  for (const ErrorValue& value : pairs.problems[0].values()) counts.push_back(std::get<std::uint64_t>(value));
  EXPECT_THAT(counts, ElementsAre(2, 3, 2));
}

TEST(Pairs, a_single_curve_takes_all_rows) {
  const KeptCurves kept = curves_of({""});
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
  explicit Line(const std::string& rows, const std::optional<std::string>& extrapolate = {})
      : files_("t,x,y\n0,0,0\n1,3,4\n2,6,8\n", rows) {
    Job& job = files_.job;
    job.curve.ends = "chord";
    job.curve.extrapolate = extrapolate;
    inputs = read_inputs(job, {});
    request_.mode = inputs.columns.by_length ? Mode::arc_at : Mode::at;
    const KeptCurve& curve = inputs.kept.curves.at(0);
    const CurvePipeline pipeline(request_, job.curve, inputs.columns.fields, std::nullopt, inputs.kept.input,
                                 *curve.curve_info);
    indexed = pipeline.whole(curve.keys());
  }

  Places places(const Limits& limits = {}) const {
    return places_of(inputs.table.curves.at(0), inputs.table, inputs.columns, indexed, limits);
  }

  ComparisonInputs inputs;
  IndexedCurve indexed;

 private:
  Comparing files_;
  SamplingRequest request_;
};

TEST(Places, are_times_on_the_curve) {
  const Line line("t,x\n1,3\n-1,0\n2.5,0\n2,6\n");
  const Places places = line.places();
  EXPECT_THAT(places.rows, ElementsAre(0, 3));
  ASSERT_TRUE(places.off_curve);
  EXPECT_EQ(places.off_curve->code(), ErrorCode::times_off_curve);
  EXPECT_EQ(std::get<std::uint64_t>(places.off_curve->values().at(0)), 2U);
  EXPECT_EQ(std::get<std::uint64_t>(places.off_curve->values().at(1)), 3U) << "line of the first";
  EXPECT_EQ(std::get<std::string>(places.off_curve->values().at(2)), "-1");
  EXPECT_EQ(std::get<std::string>(places.off_curve->values().at(3)), "0");
}

TEST(Places, a_missing_arc_length_is_on_no_curve) {
  const Places places = Line("s,x\n,0\n5,3\n").places();
  EXPECT_THAT(places.rows, ElementsAre(1));
  ASSERT_TRUE(places.off_curve);
  EXPECT_EQ(places.off_curve->code(), ErrorCode::rows_without_place);
}

TEST(Places, near_an_end_within_the_limits_are_that_end) {
  const Line line("t,x\n2.001,6\n");
  EXPECT_TRUE(line.places({1e-4, {}, {}}).off_curve);
  const Places near = line.places({1e-2, {}, {}});
  EXPECT_FALSE(near.off_curve);
  EXPECT_EQ(near.places.at(0).hi, 2);
}

TEST(Places, outside_the_curve_are_admitted_by_extrapolation) {
  const Places places = Line("t,x\n-1,0\n7,6\n", "hold").places();
  EXPECT_THAT(places.rows, ElementsAre(0, 1));
  EXPECT_EQ(places.places[1].hi, 7) << "it stays where it is";
}

TEST(Places, by_arc_length_end_with_the_length) {
  const Line line("s,x\n5,3\n10.5,6\n");
  const Places places = line.places();
  EXPECT_THAT(places.rows, ElementsAre(0));
  ASSERT_TRUE(places.off_curve);
  EXPECT_EQ(places.off_curve->code(), ErrorCode::lengths_off_curve);
  EXPECT_EQ(std::get<std::string>(places.off_curve->values().at(2)), "10.5");
}

/// All cells of the rows that are on the curve, row after row.
std::vector<double> cells_of(const Line& line, std::vector<std::size_t>& rows) {
  std::vector<double> cells;
  for_each_row(line.places(), line.inputs.columns, line.indexed, true, 2,
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
  for_each_row(line.places(), line.inputs.columns, line.indexed, true, 2,
               [&](std::size_t row, std::span<const Cell> cells) {
                 EXPECT_EQ(row, next++);
                 EXPECT_NEAR(cells[0].hi, 3 * time(row), 1e-13);
               });
  EXPECT_EQ(next, count);
}

}  // namespace
}  // namespace tcb
