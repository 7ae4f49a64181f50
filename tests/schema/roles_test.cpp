// Roles: the names that give them, with and without a channel, and requests.
#include "schema/roles.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

TEST(Roles, names_give_roles_and_case_does_not_matter) {
  for (const char* name : {"time", "Time", "TIME", "t", "frame", "Frame", "timestamp", "Timestamp", "seconds"}) {
    EXPECT_EQ(role_of_name(name), Role::time) << name;
  }
  for (const char* name : {"tension", "Tension", "TENSION"}) EXPECT_EQ(role_of_name(name), Role::tension) << name;
  EXPECT_EQ(role_of_name("Continuity"), Role::continuity);
  EXPECT_EQ(role_of_name("bIAS"), Role::bias);
}

TEST(Roles, of_single_letters_only_t_has_one) {
  EXPECT_EQ(role_of_name("t"), Role::time);
  for (const char* name : {"T", "C", "B", "c", "b"}) EXPECT_EQ(role_of_name(name), Role::position) << name;
}

TEST(Roles, ease_has_one_spelling) {
  EXPECT_EQ(role_of_name("ease_in"), Role::ease_in);
  EXPECT_EQ(role_of_name("ease_out"), Role::ease_out);
  for (const char* name : {"easeIn", "Ease_In", "ease in", "ease_to"}) {
    EXPECT_EQ(role_of_name(name), Role::position) << name;
  }
}

TEST(Roles, every_other_name_is_a_position) {
  for (const char* name : {"", "x", "times", "tt", "bias2", " t"})
    EXPECT_EQ(role_of_name(name), Role::position) << name;
}

TEST(Roles, each_has_a_name_that_finds_it) {
  for (Role role = Role::time; role < first_channel_role; role = static_cast<Role>(static_cast<int>(role) + 1)) {
    EXPECT_EQ(find_role(role_name(role)), role) << role_name(role);
  }
  EXPECT_EQ(find_role("ignored"), std::nullopt);
}

TEST(Roles, a_name_has_the_role_and_the_channel) {
  EXPECT_EQ(channel_role_of("tension_x"), (ChannelRole{Role::channel_tension, "x"}));
  EXPECT_EQ(channel_role_of("Continuity_Pos Y"), (ChannelRole{Role::channel_continuity, "Pos Y"}));
  EXPECT_EQ(channel_role_of("BIAS_p1_a"), (ChannelRole{Role::channel_bias, "p1_a"}));
  for (const char* name : {"tension_", "tension", "x_tension", "tensionx", "bias", "x", ""}) {
    EXPECT_EQ(channel_role_of(name), std::nullopt) << name;
  }
  EXPECT_EQ(role_name(ChannelRole{Role::channel_bias, "p1"}), "bias_p1");
}

TEST(RoleRequests, are_parsed) {
  const auto requests = parse_roles("time=frame,position=px:py:3");
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(requests[0].role, Role::time);
  EXPECT_THAT(requests[0].columns, ElementsAre("frame"));
  EXPECT_EQ(requests[1].role, Role::position);
  EXPECT_THAT(requests[1].columns, ElementsAre("px", "py", "3"));
}

TEST(RoleRequests, without_a_role_or_columns_are_errors) {
  EXPECT_EQ(error_of([] { parse_roles("bias=b,time="); }),
            "usage: f: error: \"time=\" has no column; expected its name or number; give it, as in time=NAME");
  for (const std::string part : {"time", "=x", "place=x", ""}) {
    EXPECT_EQ(error_of([&] { parse_roles("bias=b," + part); }),
              "usage: f: error: \"" + part +
                  "\" is not a role with its columns; expected time=NAME, position=NAME:NAME…, tension=, continuity=, "
                  "bias=, tension_NAME=, continuity_NAME=, bias_NAME=, NAME_v=, NAME_vin=, NAME_vout=, ease_in=, "
                  "ease_out=, group=, carry=, ignore=, nanoseconds= or clock=; for example --columns "
                  "time=frame,position=px:py");
  }
}

}  // namespace
}  // namespace tcb
