// Channel columns: names such as "tension_x", requests of them, and errors.
#include "schema/columns.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Names = std::vector<std::string>;

/// The columns of a header where every column holds numbers.
Columns find(const Names& header, std::string_view asked = "") {
  return find_columns(header, std::vector<bool>(header.size(), true),
                      asked.empty() ? std::vector<RoleRequest>{} : parse_roles(asked));
}

std::string error_in(const Names& header, std::string_view asked = "") {
  return error_of([&] { (void)find(header, asked); });
}

TEST(ChannelColumns, columns_are_for_their_channel_in_any_order_and_case) {
  const Columns columns = find({"tension_y", "t", "x", "BIAS_X", "Y", "continuity_x", "tension"});
  EXPECT_THAT(columns.channels, ElementsAre("x", "Y"));
  EXPECT_EQ(columns.cells[0].role, Role::channel_tension);
  EXPECT_EQ(columns.cells[0].channel, 1U);
  EXPECT_EQ(columns.cells[3].role, Role::channel_bias);
  EXPECT_EQ(columns.cells[3].channel, 0U);
  EXPECT_THAT(columns.shape_roles(), ElementsAre("tension", "tension_Y", "bias_x", "continuity_x"));
  EXPECT_TRUE(columns.ignored.empty());
}

TEST(ChannelColumns, an_exact_name_has_priority_over_one_in_another_case) {
  const Columns columns = find({"t", "X", "x", "tension_x"});
  EXPECT_EQ(columns.cells[3].channel, 1U);
  EXPECT_EQ(find({"t", "x", "X", "tension_X"}).cells[3].channel, 1U);
}

TEST(ChannelColumns, velocities_are_for_one_side_or_both) {
  const Columns columns = find({"t", "x_v", "x", "y", "Y_vout", "y_VIN", "z", "tension"});
  EXPECT_THAT(columns.channels, ElementsAre("x", "y", "z"));
  EXPECT_EQ(columns.cells[1].role, Role::velocity);
  EXPECT_EQ(columns.cells[4].role, Role::velocity_out);
  EXPECT_EQ(columns.cells[5].role, Role::velocity_in);
  EXPECT_EQ(columns.cells[5].channel, 1U);
  EXPECT_EQ(role_name(ChannelRole{Role::velocity_out, "x"}), "x_vout");
}

TEST(ChannelColumns, a_velocity_of_no_channel_is_a_channel) {
  const Columns columns = find({"t", "q_v", "x", "x_v", "x_v_v", "t_v"});
  EXPECT_THAT(columns.channels, ElementsAre("q_v", "x", "x_v_v", "t_v"));
  EXPECT_THAT(find({"t", "q_v", "tension_q_v"}).channels, ElementsAre("q_v"));
  EXPECT_THAT(find({"t", "x", "x_v"}, "position=x:x_v").channels, ElementsAre("x", "x_v"));
  EXPECT_THAT(error_in({"t", "x", "q_vin"}), HasSubstr("column \"q_vin\" names a channel \"q\""));
}

TEST(ChannelColumns, velocities_are_whole_and_without_tension) {
  EXPECT_THAT(error_in({"t", "x", "x_vin"}), HasSubstr("there is no \"x_vout\" for the other side"));
  EXPECT_THAT(error_in({"t", "x", "x_vout"}), HasSubstr("there is no \"x_vin\" for the other side"));
  EXPECT_THAT(error_in({"t", "x", "x_v", "x_vin"}), HasSubstr("\"x_v\" and \"x_vin\" both give the velocity"));
  EXPECT_THAT(error_in({"t", "x", "y", "x_v", "bias_x"}),
              HasSubstr("\"x_v\" gives velocities, so \"bias_x\" has no effect"));
  EXPECT_THAT(error_in({"t", "x", "x_v", "continuity"}), HasSubstr("the column of continuity has no effect"));
  EXPECT_THAT(find({"t", "x", "y", "x_v", "continuity", "bias_y"}).channels, ElementsAre("x", "y"));
}

TEST(ChannelColumns, columns_can_be_ignored) {
  const Columns columns = find({"t", "x", "x_v", "x_vin", "tension", "y"}, "ignore=x_v:x_vin,ignore=tension");
  EXPECT_THAT(columns.channels, ElementsAre("x", "y"));
  EXPECT_TRUE(columns.ignored.empty()) << "the request is known";
  EXPECT_THAT(columns.cells[2].role, Role::ignored);
  EXPECT_THAT(find({"time", "stamp", "x"}, "ignore=time").time, "stamp");
  EXPECT_EQ(find_columns({}, {true, true, true}, parse_roles("ignore=1")).cells[1].role, Role::time);
}

TEST(ChannelColumns, requests_name_them) {
  const Columns columns = find({"t", "x", "y", "k"}, "tension_y=k");
  EXPECT_EQ(columns.cells[3].role, Role::channel_tension);
  EXPECT_EQ(columns.cells[3].channel, 1U);
  const Columns other = find({"t", "x", "k", "tension_x"}, "tension_x=k");
  EXPECT_EQ(other.cells[2].role, Role::channel_tension);
  EXPECT_THAT(other.ignored, ElementsAre("tension_x")) << "the requested one has priority";
  const Columns unnamed = find_columns({}, {true, true, true, true}, parse_roles("bias_y=4"));
  EXPECT_EQ(unnamed.cells[3].role, Role::channel_bias);
  EXPECT_EQ(unnamed.cells[3].channel, 1U);
  const Columns chosen = find({"t", "x", "y", "tension_x", "tension_y"}, "position=y");
  EXPECT_EQ(chosen.cells[4].role, Role::channel_tension);
  EXPECT_THAT(chosen.ignored, ElementsAre("x", "tension_x"));
}

TEST(ChannelColumns, a_channel_may_have_such_a_name_where_it_is_requested) {
  EXPECT_THAT(find({"t", "x", "tension_x"}, "position=x:tension_x").channels, ElementsAre("x", "tension_x"));
}

TEST(ChannelColumns, an_unknown_channel_is_an_error) {
  EXPECT_THAT(error_in({"t", "x", "y", "tension_q"}),
              HasSubstr("column \"tension_q\" names a channel \"q\", which does not exist; expected one of x, y"));
  EXPECT_THAT(error_in({"t", "x", "tension_t"}), HasSubstr("a channel \"t\""));
  EXPECT_THAT(error_in({"t", "x", "k"}, "bias_q=k"),
              HasSubstr("the role bias_q names a channel \"q\", which does not exist"));
  EXPECT_THAT(error_in({"t", "x", "a", "b"}, "tension_x=a:b"),
              HasSubstr("a second column, \"b\", has the role tension_x"));
  EXPECT_THAT(error_in({"t", "x", "tension_x", "Tension_X"}), HasSubstr("has the role tension_x"));
}

}  // namespace
}  // namespace tcb
