// JSON: keys in every shape, what members mean, every refusal with its place, in pieces of any size.
#include "input/json/shapes.hpp"

#include <gmock/gmock.h>

#include <random>

#include "input/json/key_parser.hpp"
#include "input/reading.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

TEST(Json, a_key_has_an_array_of_positions_or_is_flat) {
  EXPECT_EQ(read(R"([{"time":0,"position":[1,2]},{"time":1,"position":[3,4]}])"), "time x y\n1: 0 1 2\n1: 1 3 4\n");
  EXPECT_EQ(read(R"([{"px":1,"Frame":0,"py":2}])"), "Frame px py\n1: 0 1 2\n");
}

TEST(Json, an_array_an_object_with_keys_and_json_lines_say_the_same) {
  const std::string one = R"({"t":0,"x":1,"T":0.5})", two = R"({"t":1,"x":2,"T":0})";
  const std::string keys = "t x\n1: 0 1 [0.5 0 0]\n2: 1 2\n";
  for (const std::string& text : {"[" + one + ",\n" + two + "]", "{\"keys\":[" + one + ",\n" + two + "]}",
                                  one + "\n" + two, one + "\r\n" + two + "\r\n"}) {
    EXPECT_EQ(read(text), keys) << text;
  }
}

TEST(Json, a_list_may_be_laid_out_freely) {
  EXPECT_EQ(read(" \n[\n  {\n    \"t\": 0,\n    \"x\": 1\n  },\n  {\"x\": 2, \"t\": 1}\n]\n"), "t x\n3: 0 1\n7: 1 2\n");
}

TEST(Json, tension_continuity_and_bias_are_members_or_one_array) {
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tension":1,"Continuity":2,"B":3}])"), "t x\n1: 0 1 [1 2 3]\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tcb":[1,2,3]}])"), "t x\n1: 0 1 [1 2 3]\n");
}

TEST(Json, keys_that_carry_no_tcb_have_the_given_one) {
  InputOptions options;
  options.tcb = {1, 2, 3};
  EXPECT_EQ(read(R"([{"t":0,"x":1,"bias":0},{"t":1,"x":1}])", options), "t x\n1: 0 1 [1 2 0]\n1: 1 1 [1 2 3]\n");
}

TEST(Json, channels_name_the_positions_wherever_they_stand) {
  const std::string expected = "t a b\n1: 0 1 2\n";
  EXPECT_EQ(read(R"({"channels":["a","b"],"keys":[{"t":0,"position":[1,2]}]})"), expected);
  EXPECT_EQ(read(R"({"keys":[{"t":0,"position":[1,2]}],"channels":["a","b"]})"), expected);
  EXPECT_EQ(read(R"({"channels":["a","b","c"],"keys":[{"t":0,"position":[1,2]}]})"),
            "f:1:35: error: \"channels\" names 3; expected 2, one for each number of \"position\"; correct it");
}

TEST(Json, a_channel_that_is_no_name_is_refused) {
  EXPECT_THAT(read(R"({"channels":["a",5],"keys":[{"t":0,"position":[1,2]}]})"), HasSubstr("error"));
}

TEST(Json, columns_asked_for_win) {
  EXPECT_EQ(read(R"([{"t":9,"when":0,"a":1,"b":2}])", with_columns("time=when,position=b")), "when b\n1: 0 2\n");
  EXPECT_EQ(read(R"([{"t":0,"position":[1,2]}])", with_columns("position=y")), "t y\n1: 0 2\n");
}

TEST(Json, members_that_say_nothing_about_the_curve_are_passed_over) {
  EXPECT_EQ(read(R"([{"id":7,"t":0,"position":[1],"name":"a","tags":[1,"b",[2]],"more":{"x":[3]},"ok":true},)"
                 R"({"t":1,"position":[2],"name":null}])"),
            "t x\n1: 0 1\n1: 1 2\n");
}

TEST(Json, whole_numbers_are_exact_times_and_rounded_positions) {
  EXPECT_EQ(read(R"([{"t":1403636579763555585,"x":9007199254740993},{"t":18446744073709551615,"x":-1}])"),
            "t x\n1: 1403636579763555585 9007199254740992\n1: 1.8446744073709552e+19 -1\n");
}

TEST(Json, members_may_come_in_another_order_in_every_key) {
  EXPECT_EQ(read(R"([{"t":0,"x":1,"y":2},{"y":4,"t":1,"x":3},{"x":5,"y":6,"t":2}])"),
            "t x y\n1: 0 1 2\n1: 1 3 4\n1: 2 5 6\n");
}

/// The error of an array whose first key is right, and whose second stands on line 2.
std::string second(const std::string& first, const std::string& key) { return read("[" + first + ",\n" + key + "]"); }

TEST(Json, a_value_that_is_no_number_is_refused) {
  const std::string first = R"({"t":0,"x":1})";
  EXPECT_EQ(second(first, R"({"t":1,"x":null})"),
            "f:2:12: error: keys[1].x: null where a number was expected; fill it in, or give --missing skip-row, "
            "skip-cell or break");
  EXPECT_EQ(second(first, R"({"t":"é","x":1})"),
            "f:2:6: error: keys[1].t: \"é\" is not a number; expected one without quotes; correct it");
  EXPECT_EQ(second(first, R"({"é":"ü","t":1,"x":true})"),
            "f:2:20: error: keys[1].x: \"true\" is not a number; expected one without quotes; correct it");
  EXPECT_EQ(read(R"([{"t":0,"x":null}])"),
            "f:1:13: error: keys[0].x: null where a number was expected; fill it in, or give --missing skip-row, "
            "skip-cell or break");
  EXPECT_EQ(read(R"([{"t":0,"position":[1,"2",3]}])"),
            "f:1:23: error: keys[0].position[1]: \"2\" is not a number; expected one without quotes; correct it");
}

TEST(Json, a_member_that_is_missing_new_or_doubled_is_refused) {
  const std::string first = R"({"t":0,"x":1})";
  EXPECT_EQ(second(first, R"({"t":1})"),
            "f:2:1: error: a key without \"x\"; expected the members of the first key; add it, or give --missing "
            "skip-row, skip-cell or "
            "break");
  EXPECT_EQ(second(first, R"({"t":1,"x":2,"y":3})"),
            "f:2:18: error: keys[1].y: not in the first key; expected the same members in every key; add it there");
  EXPECT_EQ(second(first, R"({"t":1,"x":2,"x":3})"),
            "f:2:14: error: keys[1].x: a second time in one key; expected once; take one out");
}

TEST(Json, a_member_doubled_in_the_first_key_is_refused) {
  EXPECT_THAT(read(R"([{"t":0,"x":1,"x":2}])"),
              HasSubstr("keys[0].x: a second time in one key; expected once; take one out"));
}

TEST(Json, tension_continuity_and_bias_are_never_dropped_silently) {
  EXPECT_THAT(second(R"({"t":0,"x":1})", R"({"t":1,"x":2,"tcb":[1,0,0]})"),
              testing::AnyOf(HasSubstr("[1 0 0]"), HasSubstr("error: keys[1].tcb")));
}

TEST(Json, an_array_of_another_length_and_a_value_of_another_shape_are_refused) {
  const std::string first = R"({"t":0,"position":[1,2]})";
  EXPECT_EQ(second(first, R"({"t":1,"position":[1,2,3]})"),
            "f:2:24: error: keys[1].position: an array of 3; expected 2 numbers, as in the first key; correct it");
  EXPECT_EQ(second(first, R"({"t":1,"position":[1]})"),
            "f:2:20: error: keys[1].position: an array of 1; expected 2 numbers, as in the first key; correct it");
  EXPECT_EQ(second(first, R"({"t":1,"position":5})"),
            "f:2:19: error: keys[1].position: expected an array of numbers, as in the first key; correct it");
  EXPECT_EQ(second(R"({"t":0,"x":1})", R"({"t":1,"x":[2]})"),
            "f:2:13: error: keys[1].x[0]: expected a number, as in the first key; correct it");
}

TEST(Json, an_input_without_keys_is_refused) {
  InputOptions json;
  json.format = FormatId::json;
  for (const char* text : {"", " \n", "[]", "[ ]\n"}) {
    EXPECT_EQ(read(text, json), "f: error: no keys: the input is empty; expected an object for each key; see --help");
  }
  EXPECT_EQ(read("{\"keys\":[]}", json), "f:1:1: error: no keys; expected two at least; add them");
}

TEST(Json, faults_behind_the_keys_are_placed_where_they_stand) {
  EXPECT_THAT(read("{\"keys\":[\n{\"t\":0,\"x\":1}\n], }"), testing::StartsWith("f:3:4: error: not JSON"));
  EXPECT_THAT(read("{\"keys\":[{\"t\":0,\"x\":1}], }"), testing::StartsWith("f:1:26: error: not JSON"));
  EXPECT_THAT(read("{\"keys\":[{\"t\":0,\"x\":1}]}\nx"), testing::StartsWith("f:2:1: error: not JSON"));
}

TEST(Json, a_list_that_is_cut_off_is_refused_at_its_end) {
  EXPECT_THAT(read("[{\"t\":0,\"x\":1},\n{\"t\":1,"), testing::StartsWith("f:2:7: error: not JSON"));
  EXPECT_THAT(read("{\"keys\":[{\"t\":0,\"x\":1},\n{\"t\":1,"), testing::StartsWith("f:2:7: error: not JSON"));
}

TEST(Json, settings_before_the_keys_do_not_move_their_places) {
  EXPECT_EQ(read("{\"é\":1,\n \"keys\":[{\"t\":0,\"x\":1},{\"t\":1,\"x\":\"2\"}]}"),
            "f:2:35: error: keys[1].x: \"2\" is not a number; expected one without quotes; correct it");
}

TEST(Json, the_first_key_tells_the_members) {
  const Chunk chunk{R"([{"t":0,"position":[1,2],"name":"a","T":1}])"};
  const JsonColumns columns = find_members(chunk, {}, {"a", "b"});
  ASSERT_GE(columns.members.size(), 4U);
  EXPECT_TRUE(columns.members[1].array);
  EXPECT_EQ(columns.members[1].cells, 2U);
  EXPECT_EQ(columns.columns.cells[columns.members[2].cell].role, Role::left_out);
  EXPECT_TRUE(columns.members[0].required && columns.members[1].required);
  EXPECT_FALSE(columns.members[2].required || columns.members[3].required);
  EXPECT_EQ(shown_key(parse_json(chunk, columns), 0), "1: 0 1 2 [1 0 0]\n");
}

// The law: what is read does not depend on how the bytes arrive.
TEST(Json, pieces_of_any_size_give_the_same_keys_or_the_same_error) {
  for (const std::string text :
       {R"([{"t":0,"x":1},{"t":1,"x":2}])",
        "\xEF\xBB\xBF {\"keys\":\n[{\"t\":0,\"x\":1} , {\"t\":1,\"x\":2}],\"a\":[]}",
        "{\"t\":0,\"x\":1}\n\n{\"t\":1,\"x\":2}", R"([{"t":0,"l":"\"],[{","x":1},{"t":1,"x":2,"l":"\\"}])", "[]",
        "[{\"t\":0,\"x\":1},\n {\"é\":\"ü\",\"t\":1,\"x\":null}]", "{\"t\":0,\"x\":1}\n{\"t\":1}\n{\"t\":2,\"x\":2}\n",
        "[{\"t\":0,\"x\":1},{\"t\":1,\"x\":2}] ]", "[5]", "[{\"t\":0,\"x\":1},5]"}) {
    const std::string whole = read(text);
    for (std::size_t piece = 1; piece < text.size(); ++piece) {
      ASSERT_EQ(read(text, {}, piece), whole) << text << " in pieces of " << piece;
    }
  }
}

TEST(Json, text_that_is_not_json_is_refused_in_pieces_of_any_size) {
  for (const std::string text :
       {R"([{"t":0,"x":1},])", R"([{"t":0,"x":1},,{"t":1,"x":2}])", R"([{"t":0,"x":1} {"t":1,"x":2}])",
        R"([{"t":0,"x":1},{"t":1,"x":2})", R"([{"t":0,"x":1},{"t":1,)", R"([{"t":0,"x":1},)", R"([{"t":0,"x":"1)",
        R"({"keys":[{"t":0,"x":1},{"t":1,"x":2}])", R"({"keys":[{"t":0,"x":1})", R"({"keys":[{"t":0,"x":1}],"a"})",
        "{\"t\":0,\"x\":1},\n{\"t\":1,\"x\":2}\n", "{\"t\":0,\n\"x\":1}\n", "{\"t\":0,\"x\":1}]\n",
        R"([{"t":0,"x":1}})", R"([{"t":0,"x":01}])", "{\"t\":0,\"x\":1} x\n"}) {
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      EXPECT_THAT(read(text, {}, piece), HasSubstr(" error: ")) << text << " in pieces of " << piece;
    }
  }
}

TEST(Json, two_keys_on_a_line_are_the_same_in_pieces_of_any_size) {
  for (const std::string text :
       {R"({"t":0,"x":1}{"t":1,"x":2})", R"({"t":0,"x":1} {"t":1,"x":2})", R"({"t":0,"x":1}[{"t":1,"x":2}])"}) {
    const std::string whole = read(text);
    for (std::size_t piece = 1; piece < text.size(); ++piece) {
      ASSERT_EQ(read(text, {}, piece), whole) << text << " in pieces of " << piece;
    }
  }
}

TEST(Json, missing_numbers_are_treated_as_asked_for) {
  InputOptions options;
  const std::string text = R"([{"t":0,"x":1,"y":2},{"t":1,"x":null,"y":3},{"t":2,"y":4},{"t":3,"x":5,"y":6}])";
  options.missing = Missing::skip_row;
  EXPECT_EQ(read(text, options), "t x y\n1: 0 1 2\n1: 3 5 6\n");
  options.missing = Missing::skip_cell;
  EXPECT_EQ(read(text, options), "t x y\n1: 0 1 2\n1: 1 nan 3\n1: 2 nan 4\n1: 3 5 6\n");
  EXPECT_EQ(read(R"([{"t":0,"position":[1,null]},{"t":1,"position":[null,2]}])", options),
            "t x y\n1: 0 1 nan\n1: 1 nan 2\n");
  EXPECT_THAT(read(R"([{"t":0,"x":1},{"t":null,"x":1}])", options), HasSubstr("keys[1].t: null where a number"));
}

TEST(Json, texts_of_groups_and_labels_go_with_the_keys) {
  EXPECT_EQ(read(R"([{"id":7,"t":0,"x":1,"l":"a\"b"},{"id":"7","t":1,"x":2},{"id":true,"t":1,"x":3,"l":null}])",
                 with_columns("group=id,carry=l")),
            "t x\n1: 0 1 <7> <\"a\"b>\n1: 1 2 <\"7> <>\n1: 1 3 <true> <>\n");
  EXPECT_THAT(read(R"([{"id":7,"t":0,"x":1},{"t":1,"x":2}])", with_columns("group=id")),
              HasSubstr("a key without \"id\""));
}

TEST(Json, faults_do_not_end_the_reading) {
  EXPECT_EQ(read("[{\"t\":0,\"x\":1},\n{\"t\":\"a\",\"x\":\"b\"},\n{\"t\":2,\"x\":3},\n{\"t\":4,\"y\":5}]"),
            "f:2:6: error: keys[1].t: \"a\" is not a number; expected one without quotes; correct it\n"
            "f:2:14: error: keys[1].x: \"b\" is not a number; expected one without quotes; correct it\n"
            "f:4:1: error: a key without \"x\"; expected the members of the first key; add it, or give --missing "
            "skip-row, skip-cell or break\n"
            "f:4:12: error: keys[3].y: not in the first key; expected the same members in every key; add it there");
  EXPECT_THAT(read("{\"t\":0,\"x\":1}\n{\"t\":1 \"x\":2}\n{\"t\":2}\n"),
              testing::AllOf(HasSubstr("f:2:8: error: not JSON"), HasSubstr("f:3:1: error: a key without")));
}

TEST(Json, a_zero_keeps_its_sign) { EXPECT_EQ(read(R"([{"t":0,"x":-0,"y":-0.0,"z":0}])"), "t x y z\n1: 0 -0 -0 0\n"); }

TEST(Json, curves_have_their_own_keys_and_settings) {
  const Input input = open_input(
      "f",
      pieces(R"({"curves":[{"id":"a","keys":[{"t":0,"x":1}],"preset":"vtk"},{"keys":[{"t":5,"x":6}],"id":7}]})", 1),
      {});
  EXPECT_TRUE(input.own_curves && input.may_break);
  EXPECT_THAT(input.groups, testing::ElementsAre("id"));
  std::string ids;
  while (const auto block = input.keys()) {
    if (block->curve_info == nullptr) continue;
    ids += fmt::format("{} {} {}, ", block->curve_info->id, block->keys.positions.at(0),
                       block->curve_info->settings.preset.value_or("none"));
  }
  EXPECT_EQ(ids, "\"a 1 vtk, 7 6 none, ");
}

TEST(Json, settings_beside_curves_are_refused) {
  EXPECT_EQ(read(R"({"preset":"vtk","curves":[{"keys":[{"t":0,"x":1}]}]})"),
            "f:1:11: error: preset: beside the curves; expected in each of them; move it there");
}

TEST(Json, tcb_and_its_parts_may_take_turns_but_not_stand_together) {
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tension":0.5},{"t":1,"x":2,"tcb":[1,2,3]},{"t":2,"x":3,"bias":4}])"),
            "t x\n1: 0 1 [0.5 0 0]\n1: 1 2 [1 2 3]\n1: 2 3 [0 0 4]\n");
  EXPECT_EQ(read(R"([{"t":0,"x":1,"tcb":[1,2,3]},{"t":1,"x":2,"tension":5}])"),
            "t x\n1: 0 1 [1 2 3]\n1: 1 2 [5 0 0]\n");
  EXPECT_THAT(second(R"({"t":0,"x":1})", R"({"t":1,"x":2,"bias":1,"tcb":[1,2,3]})"),
              HasSubstr("keys[1].tcb[2]: besides \"tcb\"; expected one of them"));
  EXPECT_THAT(second(R"({"t":0,"x":1,"tension":0})", R"({"t":1,"x":2,"tcb":[1,2]})"),
              HasSubstr("keys[1].tcb: an array of 2; expected 3 numbers"));
}

TEST(Json, a_number_that_is_nearly_a_known_member_is_refused) {
  const std::string what =
      ": nearly \"tension\", but a channel by its name; expected tension, or another name; rename it";
  EXPECT_THAT(read(R"([{"t":0,"position":[1],"tensoin":0.5}])"),
              testing::StartsWith("f:1:24: error: keys[0].tensoin" + what));
  EXPECT_THAT(read(R"([{"t":0,"tensoin":0.5}])"), testing::StartsWith("f:1:9: error: keys[0].tensoin" + what));
  EXPECT_EQ(read(R"([{"t":0,"tensoin":0.5,"tension":1}])"), "t tensoin\n1: 0 0.5 [1 0 0]\n") << "it is there";
  EXPECT_EQ(read(R"([{"t":0,"position":[1],"weight":0.5,"id":3}])"), "t x\n1: 0 1\n");
}

/// Keys in one of the three shapes, freely laid out, and what they mean.
class RandomJson {
 public:
  explicit RandomJson(std::uint64_t seed) : random_(seed) {
    const std::uint64_t shape = draw(3);
    const std::string settings = R"("a":{"keys":[1]},"b":"]")";
    lines_ = shape == 2;
    if (shape == 0) add(space() + "[" + space());
    if (shape == 1) add("{" + space() + (draw(2) != 0 ? settings + "," : "") + "\"keys\"" + space() + ":[" + space());
    for (std::uint64_t key = 0, keys = 1 + draw(6); key < keys; ++key) {
      if (key > 0) add(lines_ ? "\n" + space() : space() + "," + space());
      expected += fmt::format("{}: {} {}\n", line_, key, key * 2);
      add(fmt::format("{{\"t\"{}:{}{},\"label\":{},\"x\":{}}}", space(), space(), key, label(), key * 2));
    }
    if (shape == 0) add(space() + "]" + space());
    if (shape == 1) add(space() + "]" + (draw(2) != 0 ? "," + settings + "}" : "}") + space());
  }
  std::string text, expected = "t x\n";

 private:
  std::uint64_t draw(std::uint64_t below) { return random_() % below; }
  void add(const std::string& more) {
    text += more;
    line_ += static_cast<std::uint64_t>(std::ranges::count(more, '\n'));
  }
  std::string space() { return std::string(draw(3), " \n\t\r"[lines_ ? 0 : draw(4)]); }
  std::string label() {
    std::string quoted = "\"";
    const std::string parts[] = {"[", "]", "{", "}", ",", "\\\"", "\\\\", "é", "\\n", "keys"};
    while (draw(5) != 0) quoted += parts[draw(10)];
    return quoted + '"';
  }
  std::mt19937_64 random_;
  std::uint64_t line_ = 1;
  bool lines_ = false;
};

TEST(Json, what_stands_before_a_nul_is_read_first) {
  using namespace std::string_literals;
  for (const std::size_t piece : {std::size_t{1}, std::size_t{5}, std::string::npos}) {
    EXPECT_EQ(
        read("[{\"t\":0,\"x\":1},\n{\"t\":1,\"x\":\"a\"},\n\0"s, {}, piece),
        "f:2:12: error: keys[1].x: \"a\" is not a number; expected one without quotes; correct it\n"
        "f:3:1: error: a NUL byte; expected text in UTF-8; convert the input, for example with iconv -f UTF-16 -t "
        "UTF-8");
  }
}

TEST(Json, a_text_that_reads_like_a_message_is_shown_as_text) {
  EXPECT_EQ(read("[{\"'; expected \xFF"),
            "f:1:16: error: not JSON: syntax error while parsing object key - invalid string: ill-formed UTF-8 byte in "
            "\"'; expected \\xFF\"; expected string literal; correct the text");
  EXPECT_EQ(read("[{\"a\":\"'; expected \xFF"),
            "f:1:20: error: not JSON: syntax error while parsing value - invalid string: ill-formed UTF-8 byte in "
            "\"'; expected \\xFF\"; correct the text");
}

TEST(Json, nothing_where_a_key_was_expected) {
  for (const std::size_t piece : {std::size_t{1}, std::string::npos}) {
    const auto refusal = [](int column) {
      return "f:1:" + std::to_string(column) +
             ": error: nothing where a key was expected; expected {…}; take the comma out";
    };
    EXPECT_EQ(read(R"([,{"t":0,"x":1}])", {}, piece), refusal(2));
    EXPECT_EQ(read(R"([{"t":0,"x":1},,{"t":1,"x":1}])", {}, piece), refusal(16));
    EXPECT_EQ(read(R"([{"t":0,"x":1},])", {}, piece), refusal(16));
  }
}

TEST(Json, random_texts_give_their_keys_in_pieces_of_any_size) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const RandomJson json(seed);
    for (const std::size_t piece :
         {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{7}, std::string::npos}) {
      ASSERT_EQ(read(json.text, {}, piece), json.expected) << json.text << " in pieces of " << piece;
    }
  }
}

}  // namespace
}  // namespace tcb
