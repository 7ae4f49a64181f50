// JSON splitter: parts of whole keys in every shape, with their places, however the bytes arrive.
#include "read/json/splitter.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

/// Everything that a splitter hands on.
struct Split {
  std::vector<std::string> texts;   ///< of lists without their brackets
  std::vector<std::string> places;  ///< "LINE:COLUMN PATH #FIRST" of what follows the bracket
  std::vector<JsonPart> objects;
  std::vector<std::string> whole;
  std::optional<JsonShape> shape;
};

Split split(const std::string& text, std::size_t piece = std::string::npos) {
  JsonSplitter splitter(pieces(text, piece));
  Split result;
  while (const auto part = splitter.next()) {
    const Chunk& chunk = part->chunk;
    if (!result.shape) result.shape = splitter.shape();
    if (part->kind == JsonPart::Kind::object) result.objects.push_back(*part);
    if (part->kind == JsonPart::Kind::whole) result.whole.push_back(chunk.text);
    if (part->kind == JsonPart::Kind::object || part->kind == JsonPart::Kind::whole) continue;
    const bool is_list = part->kind == JsonPart::Kind::list;
    EXPECT_TRUE(!is_list || (chunk.text.starts_with('[') && chunk.text.ends_with(']'))) << chunk.text;
    result.texts.push_back(is_list ? chunk.text.substr(1, chunk.text.size() - 2) : chunk.text);
    result.places.push_back(fmt::format("{}:{} {}#{}", chunk.line, chunk.column + (is_list ? 1 : 0),
                                        chunk.path == "keys" ? "" : chunk.path + " ", chunk.first));
  }
  return result;
}

/// The object around keys, as "TEXT|LINE:COLUMN TEXT" with the position of the text after the keys.
std::string shown_object(const JsonPart& part) {
  if (part.seam == std::string::npos) return part.chunk.text;
  return fmt::format("{}|{}:{} {}", part.chunk.text.substr(0, part.seam), part.after.line, part.after.column,
                     part.chunk.text.substr(part.seam));
}

TEST(JsonSplit, an_array_is_cut_into_elements) {
  EXPECT_THAT(split("[{\"t\":0},{\"t\":1}]").texts, ElementsAre("{\"t\":0},{\"t\":1}"));
  const Split cut = split(" [{\"t\":0},\n é{\"t\":1}, {}]", 1);
  EXPECT_THAT(cut.texts, ElementsAre("{\"t\":0}", "\n é{\"t\":1}", " {}"));
  EXPECT_THAT(cut.places, ElementsAre("1:3 #0", "1:11 #1", "2:11 #2")) << "in characters";
  EXPECT_EQ(cut.shape, JsonShape::list);
}

TEST(JsonSplit, keys_in_an_object_leave_the_members_around_them) {
  const Split cut = split("{\"a\":[1,{}],\n\"keys\": [{\"t\":0},{\"t\":1}],\"b\":2}\n", 1);
  EXPECT_THAT(cut.texts, ElementsAre("{\"t\":0}", "{\"t\":1}"));
  EXPECT_THAT(cut.places, ElementsAre("2:10 #0", "2:18 #1"));
  EXPECT_EQ(cut.shape, JsonShape::object);
  ASSERT_EQ(cut.objects.size(), 1U);
  EXPECT_EQ(shown_object(cut.objects[0]), "{\"a\":[1,{}],\n\"keys\": [|2:25 ],\"b\":2}\n");
}

TEST(JsonSplit, what_follows_the_keys_keeps_its_position) {
  const std::pair<const char*, const char*> places[] = {
      {"{\"keys\":[\n{\"t\":0},\n{\"t\":1}\n ] ,\"b\":2}", "{\"keys\":[|4:2 ] ,\"b\":2}"},
      {"{\"keys\":[{\"t\":0}],\"b\":2}", "{\"keys\":[|1:17 ],\"b\":2}"},
      {"{\n\"keys\":[{\"t\":0},\n{}],\"b\":2}", "{\n\"keys\":[|3:3 ],\"b\":2}"}};
  for (const auto& [text, expected] : places) {
    for (std::size_t piece = 1; piece <= std::string(text).size(); ++piece) {
      const auto objects = split(text, piece).objects;
      ASSERT_EQ(objects.size(), 1U) << text;
      EXPECT_EQ(shown_object(objects[0]), expected);
    }
  }
}

TEST(JsonSplit, each_curve_has_its_keys_and_the_members_around_them) {
  const std::string text =
      "{\"v\":{\"curves\":[1]},\"curves\":[\n {\"id\":\"a\",\"keys\":[{\"t\":0},{\"t\":1}],\"closed\":true} ,\n"
      "{\"keys\":[{\"t\":5}]},{\"id\":2}],\"w\":[]}\n";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    const Split cut = split(text, piece);
    std::string keys;
    for (const std::string& part : cut.texts) keys += part + ";";
    EXPECT_THAT(keys, testing::AnyOf("{\"t\":0};{\"t\":1};{\"t\":5};", "{\"t\":0},{\"t\":1};{\"t\":5};"));
    EXPECT_EQ(cut.places.front(), "2:20 curves[0].keys #0");
    EXPECT_EQ(cut.places.back(), "3:10 curves[1].keys #0");
    ASSERT_EQ(cut.objects.size(), 4U);
    EXPECT_EQ(shown_object(cut.objects[0]), "{\"id\":\"a\",\"keys\":[|2:35 ],\"closed\":true}");
    EXPECT_EQ(shown_object(cut.objects[1]), "{\"keys\":[|3:17 ]}");
    EXPECT_EQ(cut.objects[2].chunk.text, "{\"id\":2}");
    EXPECT_EQ(cut.objects[2].chunk.path, "curves[2]");
    EXPECT_EQ(shown_object(cut.objects[3]), "{\"v\":{\"curves\":[1]},\"curves\":[|3:28 ],\"w\":[]}\n");
  }
}

TEST(JsonSplit, between_curves_there_are_commas_and_nothing_else) {
  const std::string curve = "{\"keys\":[{\"t\":0}]}";
  for (const std::string& curves :
       std::vector<std::string>{"[,", "[5", "[" + curve + curve, "[" + curve + ",]", "[" + curve + "}",
                                "[" + curve + ",,", "[" + curve + " x"}) {
    EXPECT_THAT(error_of([&] { split("{\"curves\":" + curves); }), testing::HasSubstr("correct the text")) << curves;
  }
}

TEST(JsonSplit, json_lines_are_cut_after_objects_once_there_are_two) {
  const Split cut = split("{\"t\":0}\n\n{\"t\":1}\n{\"t\":2}\n", 1);
  EXPECT_THAT(cut.texts, ElementsAre("{\"t\":0}\n\n{\"t\":1}", "\n{\"t\":2}"));
  EXPECT_THAT(cut.places, ElementsAre("1:1 #0", "3:8 #2"));
}

TEST(JsonSplit, objects_are_values_wherever_they_end) {
  EXPECT_THAT(split("{\"t\":0}{\"t\":\n1} {\"t\":2}{}", 1).texts,
              ElementsAre("{\"t\":0}{\"t\":\n1}", " {\"t\":2}", "{}"));
}

TEST(JsonSplit, one_object_without_keys_and_rows_of_rows_are_whole) {
  for (const std::string text : {"{\"a\":[{\"t\":0}]} ", "[[[0]]]", " [[{}]]", "{\"keys\":[[0,1],[1,2]]}", "{\"a\":"}) {
    EXPECT_THAT(split(text).whole, ElementsAre(text));
    EXPECT_THAT(split(text, 1).whole, ElementsAre(text));
  }
  EXPECT_EQ(split("[[0,1],[1,2]]").shape, JsonShape::table);
}

TEST(JsonSplit, rows_one_after_another_are_values) {
  for (const std::string text : {"[0,1]\n[1,2]\n", " [ 0 , \"a\" ] [1,2] [2"}) {
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      EXPECT_EQ(split(text, piece).shape, JsonShape::table);
    }
  }
  EXPECT_EQ(split("[0,1]\n").shape, JsonShape::list);
}

TEST(JsonSplit, a_list_can_be_made_whole_again) {
  const std::string text = "[{\"t\":0},\n{\"t\":[1]} ] \n";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    JsonSplitter splitter(pieces(text, piece));
    auto first = splitter.next();
    EXPECT_EQ(splitter.whole(*std::move(first)).chunk.text, text) << piece;
  }
}

TEST(JsonSplit, an_empty_list_has_no_chunks) {
  for (const char* text : {"", " \n", "[]", " [ \n] ", "{\"keys\":[]}"}) {
    EXPECT_THAT(split(text).texts, ElementsAre()) << text;
    EXPECT_THAT(split(text, 1).texts, ElementsAre()) << text;
  }
}

TEST(JsonSplit, brackets_commas_and_quotes_in_strings_have_no_effect) {
  const std::string key = R"({"l":"],[}{,\"\\","t":[0,{"a":[1]}]})";
  for (std::size_t piece = 1; piece <= key.size(); ++piece) {
    const auto texts = split("[" + key + "," + key + "]", piece).texts;
    const bool whole = texts == std::vector<std::string>{key + "," + key};
    const bool in_two = texts == std::vector<std::string>{key, key};
    EXPECT_TRUE(whole || in_two) << piece;
  }
}

TEST(JsonSplit, a_member_that_only_holds_the_word_keys_is_not_the_list) {
  const Split cut = split(R"({"a":"keys","b":[{}],"c":{"keys":[1]},"keys":[{"t":0}]})", 1);
  EXPECT_THAT(cut.texts, ElementsAre("{\"t\":0}"));
  EXPECT_EQ(cut.shape, JsonShape::object);
}

TEST(JsonSplit, every_byte_of_an_array_is_in_a_part_at_its_position) {
  for (const std::string text : {"[{\"a\":1},{\"b\":[2,3]}\n,{\"é\":\"x,]\"},\n\n {\"c\":4} ]", "[1,,2]", "[{},]",
                                 "[{} {}]", "[{}},{}]", "[,{}]"}) {
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      const Split cut = split(text, piece);
      std::string joined = "[";
      for (std::size_t i = 0; i < cut.texts.size(); ++i) {
        if (i > 0) joined += ',';
        const auto line_begin = static_cast<std::size_t>(joined.rfind('\n') + 1);
        const auto line = 1 + std::ranges::count(joined, '\n');
        const auto column =
            1 + std::ranges::count_if(joined.substr(line_begin), [](char c) { return (c & 0xC0) != 0x80; });
        EXPECT_THAT(cut.places[i], testing::StartsWith(fmt::format("{}:{} ", line, column))) << text;
        joined += cut.texts[i];
      }
      EXPECT_EQ(joined + "]", text) << "in pieces of " << piece;
    }
  }
}

TEST(JsonSplit, an_array_that_is_not_closed_is_an_error_after_its_last_element) {
  for (const std::string text : {"[{},{\"a\":", "[{},{\"a\":\"", "[{},", "[{},{}", "{\"keys\":[{}"}) {
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      EXPECT_EQ(error_of([&] { split(text, piece); }),
                fmt::format("f:1:{}: error: not JSON: the text ends too early; expected the rest of the last value; "
                            "complete it",
                            text.size() + 1));
    }
  }
  JsonSplitter splitter(pieces("[{},{}", 4));
  EXPECT_EQ(splitter.next()->chunk.text, "[{}]");
  EXPECT_EQ(splitter.next()->chunk.text, "[{}]");
}

TEST(JsonSplit, text_after_an_array_is_an_error_at_its_position) {
  for (std::size_t piece = 1; piece < 20; ++piece) {
    EXPECT_EQ(error_of([&] { split("[{\"é\":0}]\n \t]x", piece); }),
              "f:2:3: error: there is text after the array of keys; expected nothing; remove it");
    EXPECT_EQ(error_of([&] { split("[{\"é\":0}] [", piece); }),
              "f:1:11: error: another array follows the first one; expected one array of all keys; put the keys into "
              "one");
  }
}

TEST(JsonSplit, a_key_is_passed_on_before_more_is_read_once_it_is_not_the_only_one) {
  int asked = 0;
  JsonSplitter splitter([&]() -> std::optional<std::string> { return ++asked, "{\"t\":0}\n"; });
  for (int key = 0; key < 3; ++key) {
    EXPECT_THAT(splitter.next()->chunk.text, testing::HasSubstr("{\"t\":0}"));
    EXPECT_EQ(asked, key + 2);
  }
}

}  // namespace
}  // namespace tcb
