// Cells of JSON: roles and names of members, numbers, texts, missing values, and every error with its position.
#include "read/json/cells.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

/// The error of an array whose first key is right, and whose second is on line 2.
std::string second(const std::string& first, const std::string& key) { return read("[" + first + ",\n" + key + "]"); }

TEST(JsonKeys, tension_continuity_and_bias_are_members_or_one_array) {
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tension":0.1,"Continuity":0.2,"BIAS":3}])"), "t x\n1: 0 1 [0.1 0.2 3]\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tcb":[1,2,3]}])"), "t x\n1: 0 1 [1 2 3]\n");
}

TEST(JsonKeys, keys_without_tcb_have_the_given_one) {
  InputOptions options;
  options.keys.tcb = {1, 2, 3};
  EXPECT_EQ(read(R"([{"t":0,"x":1,"bias":0},{"t":1,"x":1}])", options), "t x\n1: 0 1 [1 2 0]\n1: 1 1 [1 2 3]\n");
}

TEST(JsonKeys, whole_numbers_are_exact_times_and_rounded_positions) {
  EXPECT_EQ(read(R"([{"t":1403636579763555585,"x":9007199254740993},{"t":18446744073709551615,"x":-1}])"),
            "t x\n1: 1403636579763555585 9007199254740992\n1: 1.8446744073709552e+19 -1\n");
}

TEST(JsonKeys, members_may_come_in_another_order_in_every_key) {
  EXPECT_EQ(read(R"([{"t":0,"x":1,"y":2},{"y":4,"t":1,"x":3},{"x":5,"y":6,"t":2}])"),
            "t x y\n1: 0 1 2\n1: 1 3 4\n1: 2 5 6\n");
  EXPECT_EQ(read(R"([{"t":0,"tension":1,"x":2},{"x":4,"t":1,"tension":3}])", with_columns("position=tension:x")),
            "t tension x\n1: 0 1 2\n1: 1 3 4\n")
      << "in their requested role";
}

TEST(JsonKeys, a_value_that_is_not_a_number_is_an_error) {
  const std::string first = R"({"t":0,"x":1})";
  EXPECT_EQ(second(first, R"({"t":1,"x":null})"),
            "f:2:12: error: keys[1].x: found null; expected a number; fill it in, or give --missing "
            "skip-row or break");
  EXPECT_EQ(second(first, R"({"t":"é","x":1})"),
            "f:2:6: error: keys[1].t: \"é\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(
      second(first, R"({"é":"ü","t":1,"x":true})"),
      "f:2:20: error: keys[1].x: \"true\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(read(R"([{"t":0,"x":null}])"),
            "f:1:13: error: keys[0].x: found null; expected a number; fill it in, or give --missing "
            "skip-row or break");
  EXPECT_EQ(read(R"([{"t":0,"position":[1,"b",3]}])"),
            "f:1:23: error: keys[0].position[1]: \"b\" is not a number; expected a number");
}

TEST(JsonKeys, values_that_are_no_keys_take_linear_time) {
  std::string values = "{\"t\":0,\"x\":1}";
  for (int i = 0; i < 200'000; ++i) values += " 1";
  EXPECT_THAT(read(values), testing::StartsWith("f:1:15: error: found a number behind the keys; expected nothing"));
  EXPECT_THAT(read("{\"t\":0,\"x\":1}\nnul\n{\"t\":1,\"x\":2}"),
              testing::StartsWith("f:2:1: error: not JSON: while parsing value - invalid literal"));
}

TEST(JsonKeys, numbers_may_be_in_quotes) {
  EXPECT_EQ(read(R"([{"t":"0","position":["1.5",2]},{"t":1,"position":[2,"-3e0"]}])"),
            "t x y\n1: 0 1.5 2\n1: 1 2 -3\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1},{"t":"0.5","x":"2"}])"), "t x\n1: 0 1\n1: 0.5 2\n");
}

TEST(JsonKeys, nan_is_a_missing_number) {
  EXPECT_EQ(second(R"({"t":0,"x":1})", R"({"t":1,"x":NaN})"),
            "f:2:12: error: keys[1].x: found \"NaN\"; expected a number; fill it in, or give --missing skip-row or "
            "break");
  InputOptions options;
  options.keys.missing = Missing::skip_row;
  EXPECT_EQ(read(R"([{"t":0,"x":NaN},{"t":1,"x":2},{"t":NaN,"x":2}])", options), "t x\n1: 1 2\n");
}

TEST(JsonKeys, a_missing_new_or_repeated_member_is_an_error) {
  const std::string first = R"({"t":0,"x":1})";
  EXPECT_EQ(
      second(first, R"({"t":1})"),
      "f:2:1: error: the key has no member \"x\"; expected the members of the first key; add it, or give --missing "
      "skip-row or break");
  std::string many = "[" + first;
  for (int i = 1; i < 100; ++i) many += fmt::format(R"(,{{"t":{},"x":1}})", i);
  EXPECT_EQ(read(many + ",\n{\"t\":100,\"x\":2,\"y\":3}]"),
            "f:2:20: error: keys[100].y: the first key has no such number; expected the same members in every key; add "
            "it there");
  EXPECT_EQ(second(first, R"({"t":1,"x":2,"x":3})"),
            "f:2:14: error: keys[1].x: the key has this member twice; expected it once; remove one");
}

TEST(JsonKeys, tension_continuity_and_bias_are_never_dropped_silently) {
  EXPECT_THAT(second(R"({"t":0,"x":1})", R"({"t":1,"x":2,"tcb":[1,0,0]})"),
              testing::AnyOf(HasSubstr("[1 0 0]"), HasSubstr("error: keys[1].tcb")));
}

TEST(JsonKeys, an_array_of_another_length_and_a_value_of_another_shape_are_errors) {
  const std::string first = R"({"t":0,"position":[1,2]})";
  EXPECT_EQ(second(first, R"({"t":1,"position":[1,2,3]})"),
            "f:2:19: error: keys[1].position: the array has 3 elements; expected 2, as in the first key");
  EXPECT_EQ(second(first, R"({"t":1,"position":[1]})"),
            "f:2:19: error: keys[1].position: the array has 1 element; expected 2, as in the first key");
  EXPECT_EQ(second(first, R"({"t":1,"position":5})"),
            "f:2:19: error: keys[1].position: this is not an array; expected one of numbers, as in the first key");
  EXPECT_EQ(second(R"({"t":0,"x":1})", R"({"t":1,"x":[2]})"),
            "f:2:12: error: keys[1].x: this is not a number; expected one, as in the first key");
}

TEST(JsonKeys, an_element_too_many_is_one_error_whatever_it_is) {
  const std::string first = R"({"t":0,"position":[1,2],"tension":0})";
  for (const char* element : {"3", "null", R"("a")"}) {
    EXPECT_THAT(
        second(first, R"({"t":1,"position":[1,2,)" + std::string(element) + R"(],"tension":0})"),
        testing::MatchesRegex("f:2:19: error: keys.1..position: the array has 3 elements; expected 2, as in the first "
                              "key"))
        << element;
  }
}

TEST(JsonKeys, missing_numbers_are_treated_as_requested) {
  InputOptions options;
  const std::string text = R"([{"t":0,"x":1,"y":2},{"t":1,"x":null,"y":3},{"t":2,"y":4},{"t":3,"x":5,"y":6}])";
  options.keys.missing = Missing::skip_row;
  EXPECT_EQ(read(text, options), "t x y\n1: 0 1 2\n1: 3 5 6\n");
  options.keys.missing = Missing::skip_cell;
  EXPECT_EQ(read(text, options), "t x y\n1: 0 1 2\n1: 1 nan 3\n1: 2 nan 4\n1: 3 5 6\n");
  EXPECT_EQ(read(R"([{"t":0,"position":[1,null]},{"t":1,"position":[null,2]}])", options),
            "t x y\n1: 0 1 nan\n1: 1 nan 2\n");
  EXPECT_THAT(read(R"([{"t":0,"x":1},{"t":null,"x":1}])", options), HasSubstr("keys[1].t: found null"));
}

TEST(JsonKeys, keys_have_the_texts_of_groups_and_labels) {
  EXPECT_EQ(read(R"([{"id":7,"t":0,"x":1,"l":"a\"b"},{"id":"7","t":1,"x":2},{"id":true,"t":1,"x":3,"l":null}])",
                 with_columns("group=id,carry=l")),
            "t x\n1: 0 1 <7> <\"a\"b>\n1: 1 2 <\"7> <>\n1: 1 3 <true> <>\n");
  EXPECT_THAT(read(R"([{"id":7,"t":0,"x":1},{"t":1,"x":2}])", with_columns("group=id")),
              HasSubstr("the key has no member \"id\""));
}

TEST(JsonKeys, faults_do_not_end_the_reading) {
  EXPECT_EQ(
      read("[{\"t\":0,\"x\":1},\n{\"t\":\"a\",\"x\":\"b\"},\n{\"t\":2,\"x\":3},\n{\"t\":4,\"y\":5}]"),
      "f:2:6: error: keys[1].t: \"a\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
      "f:2:14: error: keys[1].x: \"b\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
      "f:4:1: error: the key has no member \"x\"; expected the members of the first key; add it, or give --missing "
      "skip-row or break");
  EXPECT_THAT(read("{\"t\":0,\"x\":1}\n{\"t\":1 \"x\":2}\n{\"t\":2}\n"),
              testing::AllOf(HasSubstr("f:2:8: error: not JSON"), HasSubstr("f:3:1: error: the key has no")));
}

TEST(JsonKeys, a_zero_keeps_its_sign) {
  EXPECT_EQ(read(R"([{"t":0,"x":-0,"y":-0.0,"z":0}])"), "t x y z\n1: 0 -0 -0 0\n");
}

TEST(JsonKeys, tcb_and_its_parts_may_alternate_but_not_be_in_one_key) {
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tension":0.5},{"t":1,"x":2,"tcb":[1,2,3]},{"t":2,"x":3,"bias":4}])"),
            "t x\n1: 0 1 [0.5 0 0]\n1: 1 2 [1 2 3]\n1: 2 3 [0 0 4]\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tcb":[1,2,3]},{"t":1,"x":2,"tension":5}])"),
            "t x\n1: 0 1 [1 2 3]\n1: 1 2 [5 0 0]\n");
  EXPECT_THAT(second(R"({"t":0,"x":1})", R"({"t":1,"x":2,"bias":1,"tcb":[1,2,3]})"),
              HasSubstr("keys[1].tcb[2]: this parameter is given twice"));
  EXPECT_THAT(second(R"({"t":0,"x":1,"tension":0})", R"({"t":1,"x":2,"tcb":[1,2]})"),
              HasSubstr("keys[1].tcb: the array has 2 elements; expected 3"));
}

TEST(JsonMembers, channels_name_the_positions_before_or_after_the_keys) {
  const std::string expected = "t a b\n1: 0 1 2\n";
  EXPECT_EQ(read(R"({"channels":["a","b"],"keys":[{"t":0,"position":[1,2]}]})"), expected);
  EXPECT_EQ(read(R"({"keys":[{"t":0,"position":[1,2]}],"channels":["a","b"]})"), expected);
  EXPECT_EQ(read(R"({"channels":["a","b","c"],"keys":[{"t":0,"position":[1,2]}]})"),
            "f:1:13: error: \"channels\" has 3 names; expected 2, one for each number of \"position\"");
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
    const auto keys = without_faults(open_input("f", pieces(text), {}).keys.blocks);
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
    const auto keys = without_faults(open_input("f", pieces(text), {}).keys.blocks);
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
              HasSubstr("all channels have velocities, so the column of tension has no effect"));
}

TEST(JsonMembers, tension_of_channels_has_errors_of_its_own) {
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"position":[1,2],"tcb":{"q":[1,0,0]}}])"),
              HasSubstr("f:1:2: error: column \"tension_q\" names a channel \"q\", which does not exist"));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1,"tcb":{"x":[1,0,0]},"tension_x":1}])"),
              HasSubstr("keys[0].tension_x: this parameter is given twice"));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1,"tcb":{"x":1}}])"),
              HasSubstr("keys[0].tcb.x: this is not an array; expected [T,C,B]"));
  EXPECT_THAT(channel_tcbs(R"([{"t":0,"x":1,"tcb":{"x":[1,0,0]}},{"t":1,"x":2,"tcb":{"x":[1,0]}}])"),
              HasSubstr("keys[1].tcb.x: "));
  EXPECT_EQ(channel_tcbs(R"([{"t":0,"x":1},{"t":1,"x":2,"tcb":{"x":[1,0,0]}}])"), "[0 0 0][1 0 0]");
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
  EXPECT_EQ(
      read(R"([{"t":0,"x":"lost"},{"t":1,"x":1}])", options),
      "f:1:13: error: keys[0].x: \"lost\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
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
  EXPECT_THAT(read(R"([{"t":0,"a":{"x":1}},{"t":1,"a":{"y":1}}])"), HasSubstr("the key has no member \"a.y\""));
}

TEST(JsonMembers, numbers_of_a_rotation_in_any_form_may_be_named) {
  InputOptions options;
  options.rotation.requests = {
      {.notation = {.form = spline::RotationForm::euler}, .columns = {"rotation.x", "rotation.y", "rotation.z"}}};
  const std::string keys = R"([{"t":0,"v":1,"rotation":{"x":2,"y":3,"z":4}}])";
  EXPECT_THAT(read(keys, options), testing::EndsWith("\n1: 0 1 2 3 4\n"));
  EXPECT_THAT(read(keys), HasSubstr("keys[0].rotation: \"rotation\" has members other than x, y, z and w"));
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
      "f:1:7: error: keys[0].t: \"soon\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
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
