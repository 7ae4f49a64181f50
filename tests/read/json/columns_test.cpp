// Members of JSON keys: roles and names, as the first key has them.
#include "read/json/members.hpp"

#include <gmock/gmock.h>

#include "read/json/key_reader.hpp"
#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

TEST(JsonMembers, channels_name_the_positions_before_or_after_the_keys) {
  const std::string expected = "t a b\n1: 0 1 2\n";
  EXPECT_EQ(read(R"({"channels":["a","b"],"keys":[{"t":0,"position":[1,2]}]})"), expected);
  EXPECT_EQ(read(R"({"keys":[{"t":0,"position":[1,2]}],"channels":["a","b"]})"), expected);
  EXPECT_EQ(read(R"({"channels":["a","b","c"],"keys":[{"t":0,"position":[1,2]}]})"),
            "f:1:35: error: \"channels\" has 3 names; expected 2, one for each number of \"position\"; correct it");
}

TEST(JsonMembers, requested_columns_have_priority) {
  EXPECT_EQ(read(R"([{"t":9,"when":0,"a":1,"b":2}])", with_columns("time=when,position=b")), "when b\n1: 0 2\n");
  EXPECT_EQ(read(R"([{"t":0,"position":[1,2]}])", with_columns("position=y")), "t y\n1: 0 2\n");
}

TEST(JsonMembers, members_without_a_meaning_are_ignored) {
  EXPECT_EQ(read(R"([{"id":7,"t":0,"position":[1],"name":"a","tags":[1,"b",[2]],"more":{"x":[3]},"ok":true},)"
                 R"({"t":1,"position":[2],"name":null}])"),
            "t x\n1: 0 1\n1: 1 2\n");
}

/// The tension, continuity and bias of each channel of each key.
std::string channel_tcbs(const std::string& text) {
  std::string shown;
  const std::string error = error_of([&] {
    const auto keys = without_faults(open_input("f", pieces(text), {}).keys.blocks, false);
    while (const auto block = keys()) {
      for (const auto& [tension, continuity, bias] : block->keys.tcbs) {
        shown += fmt::format("[{} {} {}]", tension, continuity, bias);
      }
    }
  });
  return error == "no error" ? shown : error;
}

TEST(JsonMembers, channels_may_have_tension_of_their_own) {
  const std::string expected = "[0.5 0.25 1][0.5 0 1][0 0 0][0 0 0][-1 0 0][0 0 0]";
  EXPECT_EQ(channel_tcbs(R"([{"t":0,"position":[1,2],"tcb":{"x":[0.5,0.25,1],"y":[0.5,0,1]}},)"
                         R"({"t":1,"position":[3,4]},{"t":2,"position":[3,4],"tcb":{"x":[-1,0,0]}}])"),
            expected);
  EXPECT_EQ(channel_tcbs(R"([{"t":0,"x":1,"y":2,"T":0.5,"continuity_x":0.25,"bias":1,"tension_x":0.5},)"
                         R"({"t":1,"x":3,"y":4},{"t":2,"x":3,"y":4,"tension_x":-1}])"),
            expected);
  EXPECT_EQ(channel_tcbs(R"([{"t":0,"position":[1,2],"tension_y":1},{"t":1,"position":[1,2],"tcb":[0,0.5,0]}])"),
            "[0 0 0][1 0 0][0 0.5 0][0 0.5 0]");
}

/// The velocities in each channel of each key, or the error.
std::string velocities(const std::string& text) {
  std::string shown;
  const std::string error = error_of([&] {
    const auto keys = without_faults(open_input("f", pieces(text), {}).keys.blocks, false);
    while (const auto block = keys()) {
      for (const auto& [in, out] : block->keys.velocities) shown += fmt::format("[{} {}]", in, out);
      for (const bool given : block->keys.given) shown += given ? "+" : "-";
    }
  });
  return error == "no error" ? shown : error;
}

TEST(JsonMembers, keys_may_have_velocities) {
  EXPECT_EQ(velocities(R"([{"t":0,"position":[1,2],"velocity":[3,4]},{"t":1,"position":[1,2],"velocity":[5,6]}])"),
            "[3 3][4 4][5 5][6 6]++");
  EXPECT_EQ(velocities(R"([{"t":0,"velocity_in":[null,null],"velocity_out":[7,8],"position":[1,2]},)"
                       R"({"t":1,"position":[1,2],"velocity_in":[3,4]}])"),
            "[nan 7][nan 8][3 nan][4 nan]++");
  EXPECT_EQ(velocities(R"([{"t":0,"x":1,"y":2,"y_v":3},{"t":1,"x":1,"y":2,"y_v":4}])"),
            "[nan nan][3 3][nan nan][4 4]-+");
  EXPECT_EQ(velocities(R"([{"t":0,"position":[1,2],"x_v":3,"q_v":5},{"t":1,"position":[1,2],"x_v":4,"q_v":5}])"),
            "[3 3][nan nan][4 4][nan nan]+-");
  EXPECT_THAT(
      velocities(R"([{"t":0,"position":[1,2],"velocity":[3]}])"),
      HasSubstr("f:1:26: error: keys[0].velocity: the array has 1 number; expected 2, as in the array of positions"));
  EXPECT_THAT(velocities(R"([{"t":0,"x":1,"x_v":1},{"t":1,"x":1,"x_v":1,"T":0}])"),
              HasSubstr("keys[1].T: the first key has no such number"));
}

TEST(JsonMembers, tension_of_channels_has_errors_of_its_own) {
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"position":[1,2],"tcb":{"q":[1,0,0]}}])"),
              HasSubstr("f:1:2: error: column \"tension_q\" names a channel \"q\", which does not exist"));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1,"tcb":{"x":[1,0,0]},"tension_x":1}])"),
              HasSubstr("has the role tension_x"));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1,"tcb":{"x":1}}])"),
              HasSubstr("keys[0].tcb.x: this is not an array; expected [T,C,B]; correct it"));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1,"tcb":{"x":[1,0,0]}},{"t":1,"x":2,"tcb":{"x":[1,0]}}])"),
              HasSubstr("keys[1].tcb.x: "));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1},{"t":1,"x":2,"tcb":{"x":[1,0,0]}}])"),
              HasSubstr("keys[1].tcb.x[0]: the first key has no such number"));
  EXPECT_THAT(channel_tcbs(R"({"tension_x":1,"keys":[{"t":0,"x":1},{"t":1,"x":2}]})"),
              HasSubstr("tension_x: this member is outside the keys"));
}

TEST(JsonMembers, a_repeated_member_in_the_first_key_is_an_error) {
  EXPECT_THAT(read(R"([{"t":0,"x":1,"x":2}])"),
              HasSubstr("keys[0].x: the key has this member twice; expected it once; remove one"));
}

TEST(JsonMembers, the_first_key_determines_the_members) {
  const JsonPart part{JsonPart::Kind::elements, {R"({"t":0,"position":[1,2],"name":"a","T":1})"}};
  const JsonColumns columns = find_members(part, {}, {"a", "b"});
  ASSERT_GE(columns.members.size(), 4U);
  EXPECT_TRUE(columns.members[1].array);
  EXPECT_EQ(columns.members[1].cells, 2U);
  EXPECT_EQ(columns.columns.cells[columns.members[2].cell].role, Role::ignored);
  EXPECT_TRUE(columns.members[0].required && columns.members[1].required);
  EXPECT_FALSE(columns.members[2].required || columns.members[3].required);
  EXPECT_EQ(shown_key(parse_json(part, columns), 0), "1: 0 1 2 [1 0 0]\n");
}

TEST(JsonMembers, a_text_is_an_error_where_the_name_or_the_text_is_that_of_a_number) {
  EXPECT_EQ(read(R"([{"t":"soon","x":1}])"),
            "f:1:7: error: keys[0].t: \"soon\" is not a number; expected a number without quotes; correct it");
  EXPECT_EQ(read(R"([{"t":0,"x":"1.5"}])"),
            "f:1:13: error: keys[0].x: \"1.5\" is not a number; expected a number without quotes; correct it");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"note":""}])"), "t x\n1: 0 1\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"note":"a"}])"), "t x\n1: 0 1\n");
}

TEST(JsonMembers, a_near_miss_of_a_known_member_is_an_error) {
  const std::string what =
      ": this name is close to \"tension\", but makes the member a channel; expected \"tension\" or a name unlike it; "
      "rename it";
  EXPECT_THAT(read(R"([{"t":0,"position":[1],"tensoin":0.5}])"),
              testing::StartsWith("f:1:24: error: keys[0].tensoin" + what));
  EXPECT_THAT(read(R"([{"t":0,"tensoin":0.5}])"), testing::StartsWith("f:1:9: error: keys[0].tensoin" + what));
  EXPECT_EQ(read(R"([{"t":0,"tensoin":0.5,"tension":1}])"), "t tensoin\n1: 0 0.5 [1 0 0]\n") << "it is there";
  EXPECT_EQ(read(R"([{"t":0,"position":[1],"weight":0.5,"id":3}])"), "t x\n1: 0 1\n");
}

}  // namespace
}  // namespace tcb
