// Reports: text and JSON of results that were made by hand.
#include "check/ranking.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <utility>

namespace tcb {
namespace {

using spline::EndRule;
using spline::TangentRule;
using testing::HasSubstr;
using testing::Not;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

Check failed_check() {
  Check check;
  check.file = "rows \"1\".csv";
  check.keys = "keys.csv";
  check.ignored = {"note, extra", "b"};
  check.problems = {"problem with y, z"};
  check.rows = 2;
  check.values = 2;
  check.mismatches = 2;
  check.columns = {{"x", 2, {0.5, 0.25, 7}}};
  check.first = Difference{1, 2, "x", 2.5, 2, {0.5, 0.25, 7}};
  check.worst = Difference{2, 3, "x", no_value, 1, distance(no_value, 1)};
  return check;
}

TEST(Report, of_a_check_has_a_line_for_each_fact) {
  EXPECT_EQ(text(failed_check()),
            "check: failed\n"
            "file: rows \"1\".csv\n"
            "keys: keys.csv\n"
            "samples: at its times\n"
            "rows: 2\n"
            "values: 2\n"
            "mismatches: 2\n"
            "first: rows \"1\".csv:2: row 1, x: 2.5 instead of 2; abs 0.5, rel 0.25, ulp 7\n"
            "worst: rows \"1\".csv:3: row 2, x: nothing instead of 1\n"
            "column x: mismatches 2, largest abs 0.5, rel 0.25, ulp 7\n"
            "problem: problem with y, z\n"
            "not compared: note, extra, b\n");
}

TEST(Report, of_a_check_has_the_expected_rows_or_the_part_that_rows_cover) {
  Check check;
  check.coverage = {{{"id=a"}, "t", Time(0.0), Time(4.5), std::pair(Time(0.5), Time(1.75)), 3, 4},
                    {{"id=b"}, "t", Time(0.0), Time(2.0), {}, 0, 5}};
  EXPECT_THAT(text(check), HasSubstr("expected rows: 9\n"));
  EXPECT_THAT(json(check),
              HasSubstr(R"({"curve":["id=a"],"rows":3,"expected_rows":4,"from":0.5,"to":1.75,"first":0,"last":4.5})"));
  check.coverage[0].expected_rows.reset();
  EXPECT_THAT(text(check), HasSubstr("rows of curve id=a cover: t 0.5 to 1.75 of 0 to 4.5\n"
                                     "rows of curve id=b cover: nothing of 0 to 2\n"));
  EXPECT_THAT(text(check), Not(HasSubstr("expected rows")));
  EXPECT_THAT(json(check), HasSubstr(R"("rows":0,"expected_rows":5,"from":null,"to":null,"first":0,"last":2})"));
}

TEST(Report, of_a_check_in_json_has_lists_and_nulls) {
  const std::string report = json(failed_check());
  EXPECT_THAT(report, HasSubstr(R"({"passed":false,"file":"rows \"1\".csv","keys":"keys.csv","samples":"times",)"));
  EXPECT_THAT(report, HasSubstr(R"("first":{"row":1,"line":2,"column":"x","theirs":2.5,"ours":2,"abs":0.5,)"));
  EXPECT_THAT(report, HasSubstr(R"("theirs":null,"ours":1,"abs":null,"rel":null,"ulp":null})"));
  EXPECT_THAT(report, HasSubstr(R"("problems":["problem with y, z"],)"));
  EXPECT_THAT(report, HasSubstr(R"("not_compared":["note, extra","b"]})"));
  EXPECT_THAT(json(Check{}), HasSubstr("\"first\":null,\n\"worst\":null,"));
}

Identification identification(std::size_t fitting) {
  Identification result;
  result.file = "rows.csv";
  result.keys = "keys.csv";
  result.orders = {{{}, {"C,T,B"}}};
  result.rows = 4;
  result.conventions = 126;
  result.by_length = true;
  Ranking& ranking = result.ranking;
  for (const EndRule ends : {EndRule::zero, EndRule::chord}) {
    ranking.candidates.push_back({{TangentRule::interval, ends, ends, false, 0}, 0.5, {}, 3, {}, {}});
  }
  ranking.candidates[0].worst = Difference{1, 2, "x", 2.5, 2, distance(2.5, 2)};
  ranking.fitting = fitting;
  return result;
}

TEST(Report, of_conventions_that_fit_has_all_of_them) {
  const std::string report = text(identification(2));
  EXPECT_THAT(report, testing::StartsWith("identify: tangents interval, ends zero (vtk)\n"
                                          "the same here: tangents interval, ends chord\n"
                                          "the same here: T,C,B from C,T,B\n"
                                          "file: rows.csv\nkeys: keys.csv\nsamples: at its arc lengths\n"
                                          "rows: 4\nconventions: 126\n"));
  EXPECT_THAT(report, HasSubstr("\n2     0.5                     3         tangents interval, ends chord\n"));
}

TEST(Report, of_conventions_that_do_not_fit_has_the_nearest) {
  const std::string report = text(identification(0));
  EXPECT_THAT(report, testing::StartsWith("identify: none fits; the nearest is tangents interval, ends zero (vtk)\n"));
  EXPECT_THAT(report, HasSubstr("departs most: rows.csv:2: row 1, x: 2.5 instead of 2;"));
  EXPECT_THAT(report, Not(HasSubstr("departs first")));
}

TEST(Report, of_conventions_in_json_has_a_row_for_each) {
  const std::string report = json(identification(1));
  EXPECT_THAT(report, HasSubstr(R"({"fits":true,"file":"rows.csv",)"));
  EXPECT_THAT(report, HasSubstr(R"("same_orders":["C,T,B"],)"));
  EXPECT_THAT(report, HasSubstr(R"({"fits":true,"tangents":"interval","ends":"zero","equal_speed":false,)"
                                R"("order":"T,C,B","presets":["vtk"],"largest":0.5,"rows_off":3},)"));
  EXPECT_THAT(report, HasSubstr(R"({"fits":false,"tangents":"interval","ends":"chord",)"));
  Identification closed = identification(0);
  closed.parts.closed = true;
  EXPECT_THAT(json(closed), HasSubstr(R"("ends":null)"));
}

}  // namespace
}  // namespace tcb
