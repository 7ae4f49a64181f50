// Roles: which names give which role, and which are slips.
#include "input/roles.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

TEST(Roles, names_give_roles_and_case_does_not_matter) {
  for (const char* name : {"time", "Time", "TIME", "t", "frame", "Frame", "timestamp", "Timestamp", "seconds"}) {
    EXPECT_EQ(role_of_name(name), Role::time) << name;
  }
  for (const char* name : {"tension", "Tension", "TENSION"}) EXPECT_EQ(role_of_name(name), Role::tension) << name;
  EXPECT_EQ(role_of_name("Continuity"), Role::continuity);
  EXPECT_EQ(role_of_name("bIAS"), Role::bias);
}

TEST(Roles, single_letters_are_told_apart_by_case) {
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

TEST(Roles, a_name_that_misses_one_by_a_slip_is_known) {
  for (const char* name :
       {"tme", "tim", "ime", "tmie", "itme", "times", "Timee", "xtime", "tme (s)", "frmae", "fraem"}) {
    EXPECT_EQ(role_missed(name), Role::time) << name;
  }
  for (const char* name : {"Tensoin", "tenison", "tensiom", "rension", "tenssion", "ension", "TENSON"}) {
    EXPECT_EQ(role_missed(name), Role::tension) << name;
  }
  EXPECT_EQ(role_missed("biass"), Role::bias);
  EXPECT_EQ(role_missed("easein"), std::nullopt) << "no letter is missing";
  EXPECT_EQ(role_missed("ease_im"), Role::ease_in);
}

TEST(Roles, other_names_are_no_slips) {
  for (const char* name :
       {"",        "x",      "t",    "T",      "time",     "Tension",   "torsion", "extension", "tensor",
        "version", "bits",   "bins", "tide",   "dime",     "bias_x",    "bias1",   "time2",     "name",
        "game",    "period", "temp", "timer2", "position", "positions", "carry",   "group"}) {
    EXPECT_EQ(role_missed(name), std::nullopt) << name;
  }
}

TEST(Roles, each_has_a_name_that_finds_it) {
  for (std::size_t i = 1; i < role_count; ++i) {
    const Role role = static_cast<Role>(i);
    EXPECT_EQ(find_role(role_name(role)), role) << role_name(role);
  }
  EXPECT_EQ(find_role("left_out"), std::nullopt);
}

}  // namespace
}  // namespace tcb
