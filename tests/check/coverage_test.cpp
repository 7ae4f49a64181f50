// Coverage: which rows are the expected ones, and the part of a curve that rows cover.
#include "check/check.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "comparing.hpp"

namespace tcb {
namespace {

using Times = std::vector<Time>;

/// The problem of rows at these places, one on each line from line 2 on.
std::optional<std::string> problem(const Times& expected, const Times& found, const Notation& notation = {}) {
  Places places{std::vector<std::size_t>(found.size()), found, {}};
  std::iota(places.rows.begin(), places.rows.end(), std::size_t{0});
  SampleRows rows;
  rows.lines.resize(found.size());
  std::iota(rows.lines.begin(), rows.lines.end(), std::uint64_t{2});
  return rows_differ(expected, places, rows, notation, Limits{});
}

TEST(RowsDiffer, not_where_every_expected_row_is_there_in_any_order) {
  EXPECT_EQ(problem({0.0, 0.5, 1.0}, {1.0, 0.0, 0.5}), std::nullopt);
  EXPECT_EQ(problem({}, {}), std::nullopt);
}

TEST(RowsDiffer, where_rows_are_missing_at_the_end) {
  EXPECT_EQ(problem({0.0, 1.0, 2.0, 3.0}, {0.0, 1.0}),
            "rows: 4 expected, 2 found; missing: 2, the first at 2; the last row found is at 1");
}

TEST(RowsDiffer, where_a_row_is_not_expected) {
  EXPECT_EQ(problem({0.0, 1.0}, {0.0, 0.5, 1.0}),
            "rows: 2 expected, 3 found; not expected: 1, the first in line 3 at 0.5; the last row found is at 1");
}

TEST(RowsDiffer, not_by_less_than_an_eighth_of_the_way_to_the_next_row) {
  EXPECT_EQ(problem({0.0, 1.0, 2.0}, {0.0, 1.12, 2.0}), std::nullopt);
  EXPECT_NE(problem({0.0, 1.0, 2.0}, {0.0, 1.13, 2.0}), std::nullopt);
}

TEST(RowsDiffer, not_by_the_digits_that_are_printed) {
  Notation notation;
  notation.kind = Notation::Kind::fixed;
  notation.count = 0;
  EXPECT_EQ(problem({0.0, 0.4, 1.4}, {0.0, 0.0, 1.0}, notation), std::nullopt);
  EXPECT_NE(problem({0.0, 0.4, 1.4}, {0.0, 0.0, 1.0}), std::nullopt);
}

TEST(ExpectedPlaces, are_the_times_of_the_request_or_its_arc_lengths) {
  SamplingRequest request;
  request.mode = Mode::count;
  request.count = 3;
  const auto places = [&](const std::string& text, const std::string& rows) {
    const Comparing files(text, rows);
    const ComparisonInputs inputs = read_inputs(files.comparison, {});
    return expected_places({{request, {}}}, files.comparison, inputs, inputs.kept.curves.at(0));
  };
  EXPECT_THAT(places("t,x\n0,0\n4,8\n", "t,x\n0,0\n"), testing::ElementsAre(0.0, 2.0, 4.0));
  request.mode = Mode::arc_count;
  EXPECT_THAT(places("t,x\n0,0\n4,8\n", "s,x\n0,0\n"), testing::ElementsAre(0.0, 4.0, 8.0));
}

}  // namespace
}  // namespace tcb
