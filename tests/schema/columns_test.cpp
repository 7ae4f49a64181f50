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
Columns find(const Names& header, std::string_view asked = "") {
  return find_columns(header, std::vector<bool>(header.size(), true),
                      asked.empty() ? std::vector<RoleRequest>{} : parse_roles(asked));
}

Columns find_without_header(std::size_t cells, std::string_view asked = "") {
  return find_columns({}, std::vector<bool>(cells, true),
                      asked.empty() ? std::vector<RoleRequest>{} : parse_roles(asked));
}

TEST(Columns, a_header_gives_roles_in_any_order) {
  const Columns columns = find({"x", "T", "t", "C", "y", "B"});
  EXPECT_THAT(roles(columns),
              ElementsAre(Role::position, Role::tension, Role::time, Role::continuity, Role::position, Role::bias));
  EXPECT_THAT(columns.channels, ElementsAre("x", "y"));
  EXPECT_EQ(columns.cells[0].channel, 0U);
  EXPECT_EQ(columns.cells[4].channel, 1U);
  EXPECT_EQ(columns.time, "t");
  EXPECT_TRUE(columns.named);
  EXPECT_TRUE(columns.has(Role::bias));
  EXPECT_FALSE(find({"t", "x"}).has(Role::bias));
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
  const Columns columns = find({"t", "frame", "a", "b"}, "time=2,position=b:3");
  EXPECT_THAT(roles(columns), ElementsAre(Role::ignored, Role::time, Role::position, Role::position));
  EXPECT_THAT(columns.channels, ElementsAre("b", "a")) << "in the requested order";
  EXPECT_EQ(columns.cells[3].channel, 0U);
  EXPECT_EQ(columns.cells[2].channel, 1U);
  EXPECT_EQ(columns.time, "frame");
}

TEST(Columns, requested_positions_are_all_positions) {
  EXPECT_THAT(find({"t", "x", "y", "z"}, "position=y").channels, ElementsAre("y"));
  EXPECT_THAT(roles(find_without_header(4, "position=3")),
              ElementsAre(Role::time, Role::ignored, Role::position, Role::ignored));
}

TEST(Columns, without_a_header_roles_are_requested_by_number) {
  const Columns columns = find_without_header(4, "time=3,bias=1");
  EXPECT_THAT(roles(columns), ElementsAre(Role::bias, Role::position, Role::time, Role::position));
  EXPECT_THAT(columns.channels, ElementsAre("x", "y"));
}

TEST(Columns, an_exact_name_is_found_before_one_in_other_case_and_both_before_a_number) {
  EXPECT_THAT(find({"t", "A", "a"}, "position=a").cells[2].role, Role::position);
  EXPECT_THAT(find({"t", "A", "b"}, "position=a").cells[1].role, Role::position);
  EXPECT_THAT(find({"t", "3", "b"}, "position=3").cells[1].role, Role::position);
}

TEST(Columns, channels_without_names_are_x_y_z_or_numbered) {
  EXPECT_THAT(default_channel_names(1), ElementsAre("x"));
  EXPECT_THAT(default_channel_names(3), ElementsAre("x", "y", "z"));
  EXPECT_THAT(default_channel_names(4), ElementsAre("p1", "p2", "p3", "p4"));
}

TEST(Columns, role_requests_are_parsed) {
  const auto requests = parse_roles("time=frame,position=px:py:3");
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(requests[0].role, Role::time);
  EXPECT_THAT(requests[0].columns, ElementsAre("frame"));
  EXPECT_EQ(requests[1].role, Role::position);
  EXPECT_THAT(requests[1].columns, ElementsAre("px", "py", "3"));
}

TEST(Columns, role_requests_without_a_role_or_columns_are_errors) {
  for (const std::string part : {"time", "time=", "=x", "place=x", ""}) {
    EXPECT_EQ(error_of([&] { parse_roles("bias=b," + part); }),
              "usage: f: error: \"" + part +
                  "\" is not a role with its columns; expected time=NAME, position=NAME:NAME…, tension=, continuity=, "
                  "bias=, tension_NAME=, continuity_NAME=, bias_NAME=, NAME_v=, NAME_vin=, NAME_vout=, ease_in=, "
                  "ease_out=, group=, carry= or ignore=; for example --columns time=frame,position=px:py");
  }
}

TEST(Columns, missing_and_repeated_columns_are_errors_with_a_remedy) {
  EXPECT_FALSE(find({"a", "x"}).has(Role::time)) << "times may be made from positions";
  EXPECT_EQ(
      error_of([] {
        find({"t", "bias"});
      }),
      "f: error: there is no position column; expected at least one column of numbers besides the time; name it with "
      "--columns position=NAME");
  EXPECT_EQ(error_of([] {
              find({"t", "x", "frame"});
            }),
            "f: error: a second column, \"frame\", has the role time; expected one column with it; choose one with "
            "--columns time=NAME");
  EXPECT_EQ(error_of([] {
              find({"t", "x", "y"}, "tension=x:y");
            }),
            "f: error: a second column, \"y\", has the role tension; expected one column with it; choose one with "
            "--columns tension=NAME");
  EXPECT_EQ(error_of([] {
              find({"t", "x"}, "position=x:x");
            }),
            "f: error: column \"x\" has two roles; expected one; correct --columns");
}

TEST(Columns, a_column_that_does_not_exist_is_an_error_with_those_that_do) {
  EXPECT_EQ(error_of([] {
              find({"t", "x"}, "position=y");
            }),
            "f: error: --columns: there is no column \"y\"; expected one of t, x; correct the name");
  for (const char* number : {"0", "3", "-1", "1x"}) {
    EXPECT_EQ(error_of([&] { find_without_header(2, std::string("position=") + number); }),
              std::string("f: error: --columns: there is no column \"") + number +
                  "\"; the columns have no names; expected a number from 1 to 2; correct it");
  }
}

/// Columns of samples whose columns all hold numbers.
Columns find_samples(const Names& header, const SampleNames& names, bool timeless = false) {
  return find_sample_columns(header, std::vector<bool>(header.size(), true), names, timeless);
}

TEST(SampleColumns, all_but_the_time_are_channels) {
  const Columns columns = find_samples({"frame", "T", "bias", "x"}, {"clock"});
  EXPECT_EQ(columns.time, "frame");
  EXPECT_THAT(columns.channels, ElementsAre("T", "bias", "x"));
}

TEST(SampleColumns, the_time_has_the_name_that_it_has_in_the_keys_or_a_usual_one) {
  const Columns columns = find_samples({"t", "clock", "x"}, {"clock"});
  EXPECT_EQ(columns.time, "clock");
  EXPECT_THAT(columns.channels, ElementsAre("t", "x"));
  EXPECT_FALSE(find_samples({"s", "x"}, {"clock"}).has(Role::time));
}

TEST(SampleColumns, groups_are_used_if_all_are_there) {
  EXPECT_THAT(find_samples({"x", "take", "t", "id"}, {"t", {"id", "take"}}).groups, ElementsAre("id", "take"));
  const Columns without = find_samples({"x", "t", "id"}, {"t", {"id", "take"}});
  EXPECT_TRUE(without.groups.empty());
  EXPECT_THAT(without.channels, ElementsAre("x", "id"));
}

TEST(SampleColumns, labels_are_ignored) {
  const Columns columns = find_samples({"t", "x", "pose"}, {"t", {}, {"pose"}});
  EXPECT_THAT(columns.channels, ElementsAre("x"));
  EXPECT_THAT(columns.ignored, ElementsAre("pose"));
}

TEST(SampleColumns, without_names_groups_come_first_then_the_time) {
  const auto find = [](bool timeless) {
    return find_sample_columns({}, std::vector<bool>(4, true), {"t", {"column1"}}, timeless);
  };
  EXPECT_THAT(roles(find(false)), ElementsAre(Role::group, Role::time, Role::position, Role::position));
  EXPECT_THAT(roles(find(true)), ElementsAre(Role::group, Role::position, Role::position, Role::position));
}

TEST(Roles, names_give_roles_and_case_does_not_matter) {
  for (const char* name : {"time", "Time", "TIME", "t", "frame", "Frame", "timestamp", "Timestamp", "seconds"}) {
    EXPECT_EQ(role_of_name(name), Role::time) << name;
  }
  for (const char* name : {"tension", "Tension", "TENSION"}) EXPECT_EQ(role_of_name(name), Role::tension) << name;
  EXPECT_EQ(role_of_name("Continuity"), Role::continuity);
  EXPECT_EQ(role_of_name("bIAS"), Role::bias);
}

TEST(Roles, single_letters_differ_by_case) {
  EXPECT_EQ(role_of_name("t"), Role::time);
  EXPECT_EQ(role_of_name("T"), Role::tension);
  EXPECT_EQ(role_of_name("C"), Role::continuity);
  EXPECT_EQ(role_of_name("B"), Role::bias);
  EXPECT_EQ(role_of_name("c"), Role::position);
  EXPECT_EQ(role_of_name("b"), Role::position);
}

TEST(Roles, every_other_name_is_a_position) {
  for (const char* name : {"", "x", "times", "tt", "bias2", " t"})
    EXPECT_EQ(role_of_name(name), Role::position) << name;
}

TEST(Roles, near_misses_of_names_are_found) {
  for (const char* name :
       {"tme", "tim", "ime", "tmie", "itme", "times", "Timee", "xtime", "tme (s)", "frmae", "fraem"}) {
    EXPECT_EQ(near_role(name), Role::time) << name;
  }
  for (const char* name : {"Tensoin", "tenison", "tensiom", "rension", "tenssion", "ension", "TENSON"}) {
    EXPECT_EQ(near_role(name), Role::tension) << name;
  }
  EXPECT_EQ(near_role("biass"), Role::bias);
  EXPECT_EQ(near_role("easein"), std::nullopt) << "no letter is missing";
  EXPECT_EQ(near_role("ease_im"), Role::ease_in);
}

TEST(Roles, other_names_are_no_near_misses) {
  for (const char* name :
       {"",        "x",      "t",    "T",      "time",     "Tension",   "torsion", "extension", "tensor",
        "version", "bits",   "bins", "tide",   "dime",     "bias_x",    "bias1",   "time2",     "name",
        "game",    "period", "temp", "timer2", "position", "positions", "carry",   "group"}) {
    EXPECT_EQ(near_role(name), std::nullopt) << name;
  }
}

TEST(Roles, each_has_a_name_that_finds_it) {
  for (Role role = Role::time; role < first_channel_role; role = static_cast<Role>(static_cast<int>(role) + 1)) {
    EXPECT_EQ(find_role(role_name(role)), role) << role_name(role);
  }
  EXPECT_EQ(find_role("ignored"), std::nullopt);
}

}  // namespace
}  // namespace tcb
