// Columns: the role of each cell by name, by number, by position, and errors.
#include "schema/columns.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using Names = std::vector<std::string>;

std::vector<Role> roles(const Columns& columns) {
  std::vector<Role> result;
  for (const auto& cell : columns.cells) result.push_back(cell.role);
  return result;
}

/// Columns of a header where every column holds numbers.
Columns found_columns(const Names& header, std::string_view asked = "") {
  return find_columns(header, std::vector<bool>(header.size(), true),
                      asked.empty() ? std::vector<RoleRequest>{} : parse_roles(asked));
}

Columns find_without_header(std::size_t cells, std::string_view asked = "") {
  return find_columns({}, std::vector<bool>(cells, true),
                      asked.empty() ? std::vector<RoleRequest>{} : parse_roles(asked));
}

TEST(Columns, seconds_and_nanoseconds_of_one_stem_are_the_time) {
  const Columns columns = found_columns({"a.seq", "a.stamp.secs", "b", "a.stamp.nsecs", "x"});
  EXPECT_THAT(roles(columns),
              ElementsAre(Role::ignored, Role::time, Role::position, Role::nanoseconds, Role::position));
  EXPECT_EQ(columns.time, "a.stamp");
  EXPECT_EQ(found_columns({"sec", "nanosec", "x"}).time, "time");
  const Columns requested = found_columns({"clock", "sec", "nanosec", "x"}, "time=clock");
  EXPECT_THAT(roles(requested), ElementsAre(Role::time, Role::ignored, Role::ignored, Role::position));
}

TEST(Columns, two_that_may_be_the_time_are_an_error_with_both_names) {
  const auto error = [](const Names& header) { return error_of([&] { found_columns(header); }); };
  EXPECT_THAT(error({"t", "frame", "x"}), testing::HasSubstr("give --columns time=t or --columns time=frame"));
  EXPECT_THAT(error({"clock", "sec", "nsec", "x"}),
              testing::HasSubstr("give --columns time=clock or --columns time=sec,nanoseconds=nsec"));
}

TEST(Columns, a_header_gives_roles_in_any_order) {
  const Columns columns = found_columns({"x", "tension", "t", "continuity", "y", "bias"});
  EXPECT_THAT(roles(columns),
              ElementsAre(Role::position, Role::tension, Role::time, Role::continuity, Role::position, Role::bias));
  EXPECT_THAT(columns.channels, ElementsAre("x", "y"));
  EXPECT_EQ(columns.cells[0].channel, 0U);
  EXPECT_EQ(columns.cells[4].channel, 1U);
  EXPECT_EQ(columns.time, "t");
  EXPECT_TRUE(columns.named);
  EXPECT_TRUE(columns.has(Role::bias));
  EXPECT_FALSE(found_columns({"t", "x"}).has(Role::bias));
}

TEST(Columns, without_a_header_the_first_is_time_and_the_rest_are_positions) {
  const Columns columns = find_without_header(3);
  EXPECT_THAT(roles(columns), ElementsAre(Role::time, Role::position, Role::position));
  EXPECT_THAT(columns.channels, ElementsAre("x", "y"));
  EXPECT_EQ(columns.time, "t");
  EXPECT_FALSE(columns.named);
}

TEST(Columns, columns_of_text_are_ignored) {
  const Columns columns = find_columns(Names{"label", "t", "x"}, {false, true, true}, {});
  EXPECT_THAT(roles(columns), ElementsAre(Role::ignored, Role::time, Role::position));
}

TEST(Columns, requested_roles_have_priority_over_names) {
  const Columns columns = found_columns({"t", "frame", "a", "b"}, "time=2,position=b:3");
  EXPECT_THAT(roles(columns), ElementsAre(Role::ignored, Role::time, Role::position, Role::position));
  EXPECT_THAT(columns.channels, ElementsAre("b", "a")) << "in the requested order";
  EXPECT_EQ(columns.cells[3].channel, 0U);
  EXPECT_EQ(columns.cells[2].channel, 1U);
  EXPECT_EQ(columns.time, "frame");
}

TEST(Columns, requested_positions_are_all_positions) {
  EXPECT_THAT(found_columns({"t", "x", "y", "z"}, "position=y").channels, ElementsAre("y"));
  EXPECT_THAT(roles(find_without_header(4, "position=3")),
              ElementsAre(Role::time, Role::ignored, Role::position, Role::ignored));
}

TEST(Columns, without_a_header_roles_are_requested_by_number) {
  const Columns columns = find_without_header(4, "time=3,bias=1");
  EXPECT_THAT(roles(columns), ElementsAre(Role::bias, Role::position, Role::time, Role::position));
  EXPECT_THAT(columns.channels, ElementsAre("x", "y"));
}

TEST(Columns, an_exact_name_is_found_before_one_in_other_case_and_both_before_a_number) {
  EXPECT_THAT(found_columns({"t", "A", "a"}, "position=a").cells[2].role, Role::position);
  EXPECT_THAT(found_columns({"t", "A", "b"}, "position=a").cells[1].role, Role::position);
  EXPECT_THAT(found_columns({"t", "3", "b"}, "position=3").cells[1].role, Role::position);
}

TEST(Columns, channels_without_names_are_x_y_z_or_numbered) {
  EXPECT_THAT(default_channel_names(1), ElementsAre("x"));
  EXPECT_THAT(default_channel_names(3), ElementsAre("x", "y", "z"));
  EXPECT_THAT(default_channel_names(4), ElementsAre("p1", "p2", "p3", "p4"));
}

TEST(Columns, missing_and_repeated_columns_are_errors_with_a_remedy) {
  EXPECT_FALSE(found_columns({"a", "x"}).has(Role::time)) << "times may be made from positions";
  EXPECT_EQ(
      error_of([] {
        found_columns({"t", "bias"});
      }),
      "f: error: there is no position column; expected at least one column of numbers besides the time; name it with "
      "--columns position=NAME");
  EXPECT_EQ(
      error_of([] {
        found_columns({"t", "x", "frame"});
      }),
      "f: error: both \"t\" and \"frame\" may be the time; expected one column of times; give --columns time=t or "
      "--columns time=frame");
  EXPECT_EQ(error_of([] {
              found_columns({"t", "x", "y"}, "tension=x:y");
            }),
            "f: error: a second column, \"y\", has the role tension; expected one column with it; choose one with "
            "--columns tension=NAME");
  EXPECT_EQ(error_of([] {
              found_columns({"t", "x"}, "position=x:x");
            }),
            "f: error: column \"x\" has two roles; expected one; correct --columns");
}

TEST(Columns, a_column_that_does_not_exist_is_an_error_with_those_that_do) {
  EXPECT_EQ(error_of([] {
              found_columns({"t", "x"}, "position=y");
            }),
            "f: error: --columns: there is no column \"y\"; expected one of t, x");
  for (const char* number : {"0", "3", "-1", "1x"}) {
    EXPECT_EQ(error_of([&] { find_without_header(2, std::string("position=") + number); }),
              std::string("f: error: --columns: there is no column \"") + number +
                  "\"; the columns have no names; expected a number from 1 to 2");
  }
}

}  // namespace
}  // namespace tcb
