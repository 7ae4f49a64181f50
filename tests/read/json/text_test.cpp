// JSON text: values with their kinds, texts and places; faults; where a text is cut.
#include "read/json/text.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::StartsWith;

Json json_of(const std::string& text, LinePosition begin = {}) { return Json(text, begin, text.size()); }

std::string refusal_of(const std::string& text) {
  return error_of([&] { json_of(text); });
}

TEST(JsonText, values_have_their_kinds_and_texts) {
  const Json json = json_of(R"({"a\u0062":[1.50,-0,"x\"y",true,null],"o":{}} )");
  EXPECT_EQ(json.kind(1), Json::Kind::object);
  const std::size_t array = *json.member(1, "ab");
  EXPECT_EQ(json.written(array - 1), R"("a\u0062")");
  std::string shown;
  for (const std::size_t value : json.inside(array)) shown += std::string(json.text(value)) + " ";
  EXPECT_EQ(shown, "1.50 -0 x\"y true null ");
  EXPECT_EQ(json.written(array), R"([1.50,-0,"x\"y",true,null])");
  EXPECT_EQ(json.written(*json.member(1, "o")), "{}");
  EXPECT_EQ(json.written(1), R"({"a\u0062":[1.50,-0,"x\"y",true,null],"o":{}})");
  EXPECT_EQ(json.path(1, array + 3), "ab[2]");
  EXPECT_FALSE(json.member(1, "b"));
}

TEST(JsonText, places_are_those_in_the_file) {
  const Json json = json_of("{\"é\":1,\n \"b\" : [2]}", {7, 3});
  EXPECT_EQ(json.position(3).line, 7U);
  EXPECT_EQ(json.position(3).column, 8U);
  EXPECT_EQ(json.position(5).line, 8U);
  EXPECT_EQ(json.position(5).column, 8U);
}

TEST(JsonText, nan_is_null_by_its_text) {
  const Json json = json_of(R"([NaN,"NaN",1])");
  EXPECT_EQ(json.kind(2), Json::Kind::null);
  EXPECT_EQ(json.text(2), "NaN");
  EXPECT_EQ(json.kind(3), Json::Kind::string);
  EXPECT_EQ(json.text(4), "1");
}

TEST(JsonText, several_values_follow_one_another) {
  const Json json = json_of("1 {\"a\":2}[3]\n");
  EXPECT_EQ(json.count(0), 3U);
}

TEST(JsonText, faults_have_their_places) {
  EXPECT_THAT(refusal_of("[1,\n 01]"), StartsWith("f:2:3: error: not JSON: "));
  EXPECT_THAT(refusal_of("[1 2]"), StartsWith("f:1:4: error: not JSON: "));
  EXPECT_THAT(refusal_of("{\"a\":nul}"), StartsWith("f:1:6: error: not JSON: "));
  EXPECT_THAT(refusal_of("[1,"), StartsWith("f:1:4: error: not JSON: the text ends too early"));
  EXPECT_THAT(refusal_of("[1e400]"), StartsWith("f:1:2: error: \"1e400\" is too large for a double"));
  EXPECT_THAT(refusal_of(std::string(101, '[')), StartsWith("f:1:101: error: this is nested deeper"));
}

TEST(JsonText, faults_are_at_the_comma_or_colon_that_is_too_many) {
  EXPECT_THAT(refusal_of("[1,,2]"), StartsWith("f:1:4: error: not JSON: while parsing value - unexpected ','"));
  EXPECT_THAT(refusal_of("[1,\n, ,2]"), StartsWith("f:2:1: error: not JSON: while parsing value - unexpected ','"));
  EXPECT_THAT(refusal_of("[ ,1]"), StartsWith("f:1:3: error: not JSON: while parsing value - unexpected ','"));
  EXPECT_THAT(refusal_of("[NaN,,1]"), StartsWith("f:1:6: error: not JSON: while parsing value - unexpected ','"));
  EXPECT_THAT(refusal_of("{\"a\"::2}"), StartsWith("f:1:6: error: not JSON: while parsing value - unexpected ':'"));
  EXPECT_THAT(refusal_of("{\"a\":,1}"), StartsWith("f:1:6: error: not JSON: while parsing value - unexpected ','"));
  EXPECT_THAT(refusal_of("[1:2]"), StartsWith("f:1:3: error: not JSON: while parsing array - unexpected ':'"));
  EXPECT_THAT(refusal_of("{\"a\":1,,"), StartsWith("f:1:8: error: not JSON: while parsing object key - "));
  EXPECT_THAT(refusal_of("[1],\n[2]"), StartsWith("f:1:4: error: not JSON: while parsing value - unexpected ','"));
  EXPECT_THAT(refusal_of("[1 , "), StartsWith("f:1:6: error: not JSON: the text ends too early"));
  EXPECT_THAT(refusal_of("[tru"), StartsWith("f:1:5: error: not JSON: the text ends too early"));
}

/// The blocks of a text, divided by bars.
std::string blocks_of(const std::string& text, std::size_t piece, std::uint64_t max_memory = default_max_memory) {
  JsonBlocks blocks(pieces(text, piece), max_memory);
  std::string shown;
  while (const auto block = blocks.next()) shown += fmt::format("{}:{}|", block->begin.line, block->text);
  return shown;
}

TEST(JsonText, only_lines_are_cut_and_the_first_hundred_stay_together) {
  EXPECT_EQ(blocks_of("[1,\n2]\n", 1), "1:[1,\n2]\n|");
  std::string lines, more = "{\"a\":\n\"]\\\"\"}\n";
  for (int i = 0; i < 100; ++i) lines += "[1]\n";
  EXPECT_EQ(blocks_of(lines + more + more, 1), "1:" + lines + "|101:" + more + "|103:" + more + "|");
  EXPECT_EQ(blocks_of(lines, 7), "1:" + lines + "|");
}

TEST(JsonText, memory_is_counted_before_it_is_taken) {
  const std::string text = "[" + std::string(1000, ' ') + "1,2]";
  EXPECT_THAT(error_of([&] { blocks_of(text, 10, 500); }),
              testing::AllOf(testing::HasSubstr("kept as a whole"), testing::HasSubstr("jq -c '.[]'")));
  EXPECT_EQ(blocks_of(text, 10, 2000), "1:" + text + "|");
}

}  // namespace
}  // namespace tcb
