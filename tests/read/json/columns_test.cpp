// Columns of JSON: roles and names, as the first key has them.
#include "read/json/columns.hpp"

#include <gmock/gmock.h>

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
  EXPECT_EQ(channel_tcbs(R"([{"t":0,"x":1,"y":2,"tension":0.5,"continuity_x":0.25,"bias":1,"tension_x":0.5},)"
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
  EXPECT_THAT(velocities(R"([{"t":0,"x":1,"x_v":1},{"t":1,"x":1,"x_v":1,"tension":0}])"),
              HasSubstr("keys[1].tension: the first key has no such number"));
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

TEST(JsonMembers, a_text_is_a_number_if_a_later_key_has_one_or_all_are_signs_of_missing_ones) {
  InputOptions options;
  options.keys.missing = Missing::skip_row;
  EXPECT_EQ(read(R"([{"t":0,"x":"lost"},{"t":1,"x":1}])", options),
            "f:1:13: error: keys[0].x: \"lost\" is not a number; expected a number; correct it");
  EXPECT_EQ(read(R"([{"t":0,"y":0,"x":"N/A"},{"t":1,"y":1,"x":"-"},{"t":2,"y":2,"x":3}])", options),
            "t y x\n1: 2 2 3\n");
  EXPECT_EQ(read(R"([{"t":0,"y":0,"x":"a"},{"t":1,"y":1,"x":"-"}])", options), "t y\n1: 0 0\n1: 1 1\n");
}

TEST(JsonMembers, numbers_in_objects_are_columns_with_their_paths) {
  const std::string stamped =
      R"([{"header":{"stamp":{"sec":1,"nanosec":500},"frame_id":"a"},"pose":{"point":{"x":2}}},)"
      R"({"pose":{"point":{"x":3}},"header":{"stamp":{"nanosec":0,"sec":2},"frame_id":"a"}}])";
  EXPECT_EQ(read(stamped, with_columns("position=pose.point.x,time=header.stamp.sec,ignore=header.stamp.nanosec")),
            "header.stamp.sec pose.point.x\n1: 1 2\n1: 2 3\n");
  EXPECT_THAT(read(stamped), testing::StartsWith("header.stamp pose.point.x\n"));
  EXPECT_EQ(read(R"([{"t":0,"v":[1,[2,3]]},{"t":1,"v":[4,[5,6]]}])", with_columns("position=v[1][1]:v[0]")),
            "t v[1][1] v[0]\n1: 0 3 1\n1: 1 6 4\n");
  EXPECT_THAT(
      read(R"([{"t":0,"a":{"x":1}},{"t":1,"a":{"y":1}}])"),
      testing::AllOf(HasSubstr("keys[1].a.y: the first key has no such number"), HasSubstr("no member \"a.x\"")));
}

TEST(JsonMembers, numbers_of_a_rotation_in_any_form_may_be_named) {
  InputOptions options;
  options.rotation.requests = {
      {.notation = {.form = spline::RotationForm::euler}, .columns = {"rotation.x", "rotation.y", "rotation.z"}}};
  const std::string keys = R"([{"t":0,"v":1,"rotation":{"x":2,"y":3,"z":4}}])";
  EXPECT_THAT(read(keys, options), testing::EndsWith("\n1: 0 1 2 3 4\n"));
  EXPECT_THAT(read(keys), HasSubstr("keys[0].rotation.x: \"rotation\" has members other than x, y, z and w"));
}

TEST(JsonMembers, an_object_or_the_only_array_is_the_position) {
  EXPECT_EQ(read(R"([{"time":0,"position":{"x":0,"y":1}},{"time":10,"position":{"x":1,"y":2}}])"),
            "time x y\n1: 0 0 1\n1: 10 1 2\n");
  EXPECT_EQ(read(R"([{"time":0,"value":[0,1]},{"time":1,"value":[2,3]}])"), "time x y\n1: 0 0 1\n1: 1 2 3\n");
  EXPECT_EQ(read(R"([{"positions":[0,1],"velocities":[5,6],"time_from_start":{"sec":1,"nanosec":0}}])"),
            "time_from_start x y\n1: 1 0 1\n");
  EXPECT_THAT(read(R"([{"t":0,"a":[1],"b":[2]}])"), HasSubstr("keys[0].a: these arrays are not used"));
}

TEST(JsonMembers, many_members_take_linear_time) {
  std::string first = "{\"t\":0", second = "}";
  for (int i = 0; i < 20000; ++i) {
    first += fmt::format(",\"m{}\":[]", i);
    second = fmt::format(",\"m{}\":[]{}", i, second);
  }
  EXPECT_EQ(read("[" + first + ",\"x\":1},{\"t\":1,\"x\":2" + second + "]"), "t x\n1: 0 1\n1: 1 2\n");
}

TEST(JsonMembers, a_text_is_an_error_where_the_name_or_the_text_is_that_of_a_number) {
  EXPECT_EQ(
      read(R"([{"t":"soon","x":1}])"),
      "f:1:7: error: keys[0].t: \"soon\" is not a number; expected a number; correct it, or give --columns ignore=t");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"note":""}])"), "t x\n1: 0 1\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"note":"a"}])"), "t x\n1: 0 1\n");
}

TEST(JsonMembers, a_near_miss_of_a_known_member_is_an_error) {
  const std::string what = "error: column tensoin may be tension";
  EXPECT_THAT(read(R"([{"t":0,"position":[1],"tensoin":0.5}])"), testing::StartsWith("f:1:2: " + what));
  EXPECT_THAT(read(R"([{"t":0,"tensoin":0.5}])"), testing::StartsWith("f:1:2: " + what));
  EXPECT_EQ(read(R"([{"t":0,"tensoin":0.5,"tension":1}])"), "t tensoin\n1: 0 0.5 [1 0 0]\n") << "it is there";
  EXPECT_EQ(read(R"([{"t":0,"position":[1],"weight":0.5,"id":3}])"), "t x\n1: 0 1\n");
}

}  // namespace
}  // namespace tcb
