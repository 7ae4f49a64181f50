// Shapes of JSON inputs: the same keys in every shape, in pieces of any size.
#include <gmock/gmock.h>

#include <random>

#include "formats/formats.hpp"
#include "read/reading.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

TEST(Json, a_key_has_an_array_of_positions_or_is_flat) {
  EXPECT_EQ(read(R"([{"time":0,"position":[1,2]},{"time":1,"position":[3,4]}])"), "time x y\n1: 0 1 2\n1: 1 3 4\n");
  EXPECT_EQ(read(R"([{"px":1,"Frame":0,"py":2}])"), "Frame px py\n1: 0 1 2\n");
}

TEST(Json, a_channel_that_is_not_a_name_is_an_error) {
  EXPECT_THAT(read(R"({"channels":["a",5],"keys":[{"t":0,"position":[1,2]}]})"), HasSubstr("error"));
}

TEST(Json, an_input_without_keys_is_an_error) {
  InputOptions json;
  json.format = find_format("json");
  for (const char* text : {"", " \n"}) {
    EXPECT_EQ(read(text, json), "f: error: the input has no keys; expected a JSON object for each key; see --help");
  }
  EXPECT_THAT(read("[ ]\n", json), HasSubstr("found no list of keys"));
  EXPECT_EQ(read("{\"keys\":[]}", json), "f:1:1: error: found no keys; expected at least two");
}

TEST(Json, faults_after_the_keys_have_their_position) {
  EXPECT_THAT(read("{\"keys\":[\n{\"t\":0,\"x\":1}\n], }"), testing::StartsWith("f:3:4: error: not JSON"));
  EXPECT_THAT(read("{\"keys\":[{\"t\":0,\"x\":1}], }"), testing::StartsWith("f:1:26: error: not JSON"));
  EXPECT_THAT(read("{\"keys\":[{\"t\":0,\"x\":1}]}\nx"), testing::StartsWith("f:2:1: error: not JSON"));
}

TEST(Json, settings_before_the_keys_do_not_change_their_positions) {
  EXPECT_EQ(
      read("{\"é\":1,\n \"keys\":[{\"t\":0,\"x\":1},{\"t\":1,\"x\":\"b\"}]}"),
      "f:2:35: error: keys[1].x: \"b\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
}

// The result does not depend on how the bytes arrive.
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

TEST(Json, text_that_is_not_json_is_an_error_in_pieces_of_any_size) {
  for (const std::string text :
       {R"([{"t":0,"x":1},])", R"([{"t":0,"x":1},,{"t":1,"x":2}])", R"([{"t":0,"x":1} {"t":1,"x":2}])",
        R"([{"t":0,"x":1},{"t":1,"x":2})", R"([{"t":0,"x":1},{"t":1,)", R"([{"t":0,"x":1},)", R"([{"t":0,"x":"1)",
        R"({"keys":[{"t":0,"x":1},{"t":1,"x":2}])", R"({"keys":[{"t":0,"x":1})", R"({"keys":[{"t":0,"x":1}],"a"})",
        "{\"t\":0,\"x\":1},\n{\"t\":1,\"x\":2}\n", "{\"t\":0,\"x\":1}]\n", R"([{"t":0,"x":1}})", R"([{"t":0,"x":01}])",
        "{\"t\":0,\"x\":1} x\n"}) {
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      EXPECT_THAT(read(text, {}, piece), HasSubstr(" error: ")) << text << " in pieces of " << piece;
    }
  }
}

TEST(Json, the_only_list_in_a_text_is_read_with_its_positions) {
  const std::string text = "{\"fps\":30,\n \"a\":{\"b\":[{\"t\":0,\"x\":1},\n{\"t\":1,\"x\":2}]}}";
  EXPECT_EQ(read(text), "t x\n2: 0 1\n3: 1 2\n");
  InputOptions options;
  options.records = "a.b";
  EXPECT_EQ(read(text, options), "t x\n2: 0 1\n3: 1 2\n");
  EXPECT_EQ(open_input("f", pieces(text), {}).facts.records, "a.b");
  EXPECT_EQ(read("[{\"n\":\"a\",\"p\":[[0,1],[1,2]]}]"), "t x\n1: 0 1\n1: 1 2\n");
  EXPECT_EQ(read("{\"keyframes\":[{\"time\":0,\"value\":[0,0]},{\"time\":1,\"value\":[1,2]}]}"),
            "time x y\n1: 0 0 0\n1: 1 1 2\n");
}

TEST(Json, an_asterisk_in_a_path_makes_curves) {
  InputOptions options;
  options.records = "*.k";
  const Input input = open_input("f", pieces(R"({"a":{"k":[[0,1],[1,2]]},"b":{"k":[[5,6],[7,8]]}})"), options);
  EXPECT_TRUE(input.keys.traits.own_curves);
  std::string ids;
  while (const auto block = input.keys.blocks()) {
    if (block->curve_info) ids += fmt::format("{} {}, ", block->curve_info->id, block->keys.positions.at(0));
  }
  EXPECT_EQ(ids, "\"a.k 1, \"b.k 6, ");
}

TEST(Json, curves_have_their_own_keys_and_settings) {
  const Input input = open_input(
      "f",
      pieces(R"({"curves":[{"id":"a","keys":[{"t":0,"x":1}],"preset":"vtk"},{"keys":[{"t":5,"x":6}],"id":7}]})", 1),
      {});
  EXPECT_TRUE(input.keys.traits.own_curves && input.keys.traits.may_break);
  EXPECT_THAT(input.schema.groups, testing::ElementsAre("id"));
  std::string ids;
  while (const auto block = input.keys.blocks()) {
    if (block->curve_info == nullptr) continue;
    const auto& preset = block->curve_info->settings.preset;
    ids += fmt::format("{} {} {}, ", block->curve_info->id, block->keys.positions.at(0),
                       preset ? spline::name_of(*preset) : "none");
  }
  EXPECT_EQ(ids, "\"a 1 vtk, 7 6 none, ");
}

TEST(Json, settings_outside_curves_are_errors) {
  EXPECT_EQ(read(R"({"preset":"vtk","curves":[{"keys":[{"t":0,"x":1}]}]})"),
            "f:1:11: error: preset: this setting is outside the curves; expected it in each curve; move it there");
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

TEST(Json, a_nul_is_refused_where_it_is) {
  using namespace std::string_literals;
  for (const std::size_t piece : {std::size_t{1}, std::size_t{5}, std::string::npos}) {
    EXPECT_THAT(read("[{\"t\":0,\"x\":1},\n{\"t\":1,\"x\":2},\n\0"s, {}, piece),
                testing::StartsWith("f:3:1: error: this is a NUL byte; expected text in UTF-8"));
  }
}

TEST(Json, a_text_that_looks_like_a_message_is_shown_as_text) {
  EXPECT_EQ(read("[{\"'; expected \xFF\":1}]"),
            "f:1:3: error: not JSON: while parsing object key - invalid string: ill-formed UTF-8 byte");
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
