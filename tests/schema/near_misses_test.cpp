// Near misses: misspelt names of roles, and the error that they are.
#include "schema/near_misses.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

TEST(NearMisses, are_of_one_letter) {
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

TEST(NearMisses, other_names_are_none) {
  for (const char* name :
       {"",        "x",      "t",    "T",      "time",     "Tension",   "torsion", "extension", "tensor",
        "version", "bits",   "bins", "tide",   "dime",     "bias_x",    "bias1",   "time2",     "name",
        "game",    "period", "temp", "timer2", "position", "positions", "carry",   "group"}) {
    EXPECT_EQ(near_role(name), std::nullopt) << name;
  }
}

TEST(NearMisses, of_a_channel) {
  EXPECT_EQ(near_channel_role("x_tension", {"x"}), (ChannelRole{Role::channel_tension, "x"}));
  EXPECT_EQ(near_channel_role("Bais_Pos_X", {"y", "pos_x"}), (ChannelRole{Role::channel_bias, "pos_x"}));
  for (const char* name : {"tensor_x", "tensoin_y", "x_T", "x", "x_", "_x", "x_y", "time_x"}) {
    EXPECT_EQ(near_channel_role(name, {"x"}), std::nullopt) << name;
  }
}

}  // namespace
}  // namespace tcb
