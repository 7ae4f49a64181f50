// Matched columns: by name, by order, and the column of the places.
#include "check/inputs.hpp"

#include <gmock/gmock.h>

#include "comparing.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Schema keys_with(std::vector<std::string> channels) {
  Schema schema;
  schema.time.is_given = true;
  schema.channels = std::move(channels);
  return schema;
}

SampleTable named(bool timed, std::vector<std::string> columns) {
  return {true, timed, timed ? "t" : "", std::move(columns), {}, {}};
}

SampleTable nameless(bool timed, std::size_t columns) {
  return {false, timed, "", std::vector<std::string>(columns), {}, {}};
}

TEST(MatchedColumns, are_found_by_name) {
  const MatchedColumns match = match_columns(named(true, {"y_v", "x"}), keys_with({"x", "y"}), {});
  EXPECT_THAT(match.fields, ElementsAre(field_of("position"), field_of("velocity")));
  ASSERT_EQ(match.compared.size(), 2U);
  EXPECT_EQ(match.compared[0].name, "x");
  EXPECT_EQ(match.compared[0].given, 1U);
  EXPECT_EQ(match.compared[0].computed, 0U);
  EXPECT_EQ(match.compared[1].name, "y_v");
  EXPECT_EQ(match.compared[1].given, 0U);
  EXPECT_EQ(match.compared[1].computed, 3U) << "a row of the curve is x, y, x_v, y_v";
  EXPECT_THAT(match.problems, ElementsAre("columns missing: y", "columns missing: x_v"));
}

TEST(MatchedColumns, others_are_a_problem_unless_fields_are_given) {
  SampleTable table = named(true, {"x", "a, b", "speed"});
  table.ignored = {"note, extra"};
  const MatchedColumns all = match_columns(table, keys_with({"x"}), {});
  EXPECT_THAT(all.problems, ElementsAre("columns of no field: a, b; give the fields to compare with --fields"));
  EXPECT_THAT(all.ignored, ElementsAre("note, extra"));
  const MatchedColumns one = match_columns(table, keys_with({"x"}), {field_of("position")});
  EXPECT_THAT(one.problems, IsEmpty());
  EXPECT_THAT(one.ignored, ElementsAre("note, extra", "a, b", "speed"));
}

TEST(MatchedColumns, s_is_the_place_without_times_or_if_no_time_is_requested) {
  const MatchedColumns alone = match_columns(named(false, {"x", "s"}), keys_with({"x"}), {});
  EXPECT_TRUE(alone.by_length);
  EXPECT_EQ(alone.place, 1U);
  EXPECT_EQ(alone.compared.size(), 1U);
  const auto both = named(true, {"x", "s"});
  EXPECT_FALSE(match_columns(both, keys_with({"x"}), {}).by_length);
  EXPECT_TRUE(match_columns(both, keys_with({"x"}), {field_of("position"), field_of("s")}).by_length);
}

TEST(MatchedColumns, a_channel_called_s_is_no_place) {
  const Error error = error_of([] { match_columns(named(false, {"s"}), keys_with({"s"}), {}); });
  EXPECT_THAT(error.message(), HasSubstr("no column of times or arc lengths: the columns are s; expected \"t\""));
}

TEST(MatchedColumns, names_are_distinct_and_some_are_known) {
  const Error repeated = error_of([] { match_columns(named(true, {"x", "x"}), keys_with({"x"}), {}); });
  EXPECT_THAT(repeated.message(), HasSubstr("two columns are called \"x\""));
  const Error unknown = error_of([] {
    match_columns(named(true, {"q"}), keys_with({"x"}), {field_of("time"), field_of("position")});
  });
  EXPECT_THAT(unknown.message(), HasSubstr("the columns are q; expected some of t, x"));
}

TEST(MatchedColumns, without_names_are_found_by_order) {
  const MatchedColumns usual = match_columns(nameless(true, 2), keys_with({"x", "y"}), {});
  ASSERT_EQ(usual.compared.size(), 2U);
  EXPECT_EQ(usual.compared[1].name, "y");
  EXPECT_EQ(usual.compared[1].given, 1U);
  EXPECT_EQ(usual.compared[1].computed, 2U) << "a row of the curve is t, x, y";
  const MatchedColumns by_length =
      match_columns(nameless(false, 3), keys_with({"x", "y"}), {field_of("position"), field_of("s")});
  EXPECT_TRUE(by_length.by_length);
  EXPECT_EQ(by_length.place, 2U);
  EXPECT_EQ(by_length.compared.size(), 2U);
}

TEST(MatchedColumns, without_names_are_as_many_as_the_fields_have_and_one_is_the_place) {
  const Error few = error_of([] { match_columns(nameless(true, 1), keys_with({"x", "y"}), {}); });
  EXPECT_THAT(few.message(), HasSubstr("there are 2 columns without names; expected 3: t, x, y"));
}

}  // namespace

}  // namespace tcb
