// Names of parameters: sets of columns with the same rest, clear ones and those in doubt.
#include "schema/parameter_names.hpp"

#include <gmock/gmock.h>

#include "text/suggest.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

/// The roles that columns have by names that are not the words, as a value of --columns.
std::string roles(const std::vector<std::string>& names) {
  std::string text;
  for (const RoleRequest& request : parameters_by_name(names, std::vector<bool>(names.size(), true), {})) {
    const std::string role = request.channel.empty() ? std::string(role_name(request.role))
                                                     : role_name(ChannelRole{request.role, request.channel});
    text += (text.empty() ? "" : ",") + role + "=" + request.columns[0];
  }
  return text;
}

bool has_doubt(const std::vector<std::string>& names) {
  return std::ranges::any_of(parameter_sets(names, std::vector<bool>(names.size(), true), {}),
                             &ParameterSet::is_doubtful);
}

TEST(ParameterNames, words_are_separated_by_punctuation_and_capitals) {
  EXPECT_THAT(words_of("tcb_t"), ElementsAre("tcb", "t"));
  EXPECT_THAT(words_of("tcbT"), ElementsAre("tcb", "t"));
  EXPECT_THAT(words_of("TCBTension"), ElementsAre("tcb", "tension"));
  EXPECT_THAT(words_of("tcb[0]"), ElementsAre("tcb", "0"));
  EXPECT_THAT(words_of("x2_C."), ElementsAre("x", "2", "c"));
  EXPECT_THAT(words_of(""), ElementsAre());
}

TEST(ParameterNames, three_columns_with_the_same_rest_are_parameters) {
  EXPECT_EQ(roles({"time", "x", "t", "c", "b"}), "tension=t,continuity=c,bias=b");
  EXPECT_EQ(roles({"time", "bias", "tens", "con"}), "tension=tens,continuity=con");
  EXPECT_EQ(roles({"t", "T", "C", "B"}), "tension=T,continuity=C,bias=B");
  EXPECT_EQ(roles({"t", "t", "c", "b"}), "tension=2,continuity=c,bias=b");
  EXPECT_EQ(roles({"time", "kT", "kC", "kB"}), "tension=kT,continuity=kC,bias=kB");
  EXPECT_EQ(roles({"time", "tbc[0]", "tbc[1]", "tbc[2]"}), "tension=tbc[0],continuity=tbc[2],bias=tbc[1]");
  EXPECT_EQ(roles({"time", "x", "x_t", "x_c", "x_b"}), "tension_x=x_t,continuity_x=x_c,bias_x=x_b");
  EXPECT_EQ(roles({"time", "tcb.t"}), "tension=tcb.t");
}

TEST(ParameterNames, others_are_not) {
  for (const std::vector<std::string>& names : {std::vector<std::string>{"time", "a", "b", "c"},
                                                {"t", "c", "b", "x"},
                                                {"time", "content", "contact", "tenant"},
                                                {"time", "cable_tension", "gyro_bias"},
                                                {"time", "tension [N]", "bias (V)", "continuity [ohm]"}}) {
    EXPECT_EQ(roles(names), "") << names[1];
    EXPECT_FALSE(has_doubt(names)) << names[1];
  }
}

TEST(ParameterNames, fewer_in_short_and_letters_beside_others_are_in_doubt) {
  EXPECT_TRUE(has_doubt({"time", "x", "tens"}));
  EXPECT_TRUE(has_doubt({"time", "x", "key_tension"}));
  EXPECT_TRUE(has_doubt({"time", "x", "x_tens"}));
  EXPECT_TRUE(has_doubt({"time", "r", "g", "b", "t", "c"}));
  EXPECT_TRUE(has_doubt({"time", "tns", "cnt", "bs"}));
}

}  // namespace
}  // namespace tcb
