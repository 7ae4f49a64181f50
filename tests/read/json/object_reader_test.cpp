// Object reader: the events of each key, and the text positions of errors.
#include "read/json/object_reader.hpp"

#include <gtest/gtest.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

/// Writes the events down, and has an error for the number 13 and the text "bad".
class Log : public JsonObjectReader {
 public:
  using JsonObjectReader::JsonObjectReader;
  std::string text;
  bool stop_at_key_end = false;

 private:
  bool on_key_start() override { return add(fmt::format("{}{{", key_position().line)); }
  bool on_key_end() override { return add("}") && !stop_at_key_end; }
  bool on_member(const std::string& name) override { return add(" " + name + ":"); }
  bool on_number(const spline::Time<double>& value) override {
    if (value.hi == 13) throw value_error(ErrorCode::json_number_expected);
    return add(index() + shown_time(value));
  }
  bool on_text(std::string_view value) override {
    if (value == "bad") throw value_error(ErrorCode::json_number_expected);
    return add(fmt::format("{}<{}>", index(), value));
  }
  bool on_null() override { return add(index() + "<null>"); }
  bool on_nested() override { return add(index() + "<nested>"); }
  bool on_array_end() override { return add(fmt::format("/{}", element())); }

  std::string index() const { return in_array() ? fmt::format(" {}=", element()) : ""; }
  bool add(const std::string& more) {
    text += more;
    return true;
  }
};

std::string log(const std::string& text) {
  const Chunk chunk{text};
  Log reader(chunk);
  const std::string error = error_of([&] { reader.parse(); });
  return error == "no error" ? reader.text : error;
}

TEST(ObjectReader, an_array_of_keys_is_read_member_by_member) {
  EXPECT_EQ(log("[{\"a\":1,\"b\":[2,\"x\",null],\"c\":true},\n\n{\"a\":\"é\"}]"),
            "1{ a:1 b: 0=2 1=<x> 2=<null>/3 c:<true>}3{ a:<é>}");
}

TEST(ObjectReader, an_object_per_line_is_read_like_an_array) {
  EXPECT_EQ(log("{\"a\":1}\r\n \t\r\n{\"a\":[]}"), "1{ a:1}3{ a:/0}");
}

TEST(ObjectReader, numbers_have_the_precision_of_a_time) {
  EXPECT_EQ(log("[{\"a\":9007199254740993,\"b\":-9007199254740993,\"c\":0.5,\"d\":1e3,\"e\":18446744073709551616}]"),
            "1{ a:9007199254740993 b:-9007199254740993 c:0.5 d:1000 e:1.8446744073709552e+19}");
}

TEST(ObjectReader, elements_that_are_arrays_or_objects_count_as_elements) {
  EXPECT_EQ(log("[{\"a\":[[7],{\"b\":8},9]}]"), "1{ a: 0=<nested> 1=<nested> 2=9/3}");
}

TEST(ObjectReader, values_in_an_object_of_a_member_are_ignored) {
  EXPECT_EQ(log("[{\"a\":{\"b\":7,\"c\":[8],\"d\":\"x\"},\"e\":9}]"), "1{ a:<nested> e:9}");
}

TEST(ObjectReader, the_members_of_tcb_are_members_of_the_key) {
  EXPECT_EQ(log("[{\"tcb\":{\"x\":[1,2,3],\"y\":4,\"z\":{\"w\":5},\"v\":[[6]]},\"e\":9,\"a\":{\"tcb\":{\"x\":7}}}]"),
            "1{ tcb: tcb.x: 0=1 1=2 2=3/3 tcb.y:4 tcb.z:<nested> tcb.v: 0=<nested>/1 e:9 a:<nested>}");
  EXPECT_EQ(log("{\"tcb\":{}}\n{\"tcb\":[1],\"b\":2}"), "1{ tcb:}2{ tcb: 0=1/1 b:2}");
}

TEST(ObjectReader, returning_false_ends_the_parsing) {
  const Chunk chunk{"{\"a\":1}\n{\"a\":2}\n{"};
  Log reader(chunk);
  reader.stop_at_key_end = true;
  reader.parse();
  EXPECT_EQ(reader.text, "1{ a:1}");
}

TEST(ObjectReader, one_object_may_go_over_lines) {
  const Chunk chunk{"{\"a\":\n1,\n\"b\":[\n2]}"};
  Log reader(chunk);
  reader.parse_object();
  EXPECT_EQ(reader.text, "1{ a:1 b: 0=2/1}");
  EXPECT_NE(error_of([&] { Log(chunk).parse(); }), "no error") << "but an object per line ends with its line";
}

TEST(ObjectReader, errors_have_the_position_and_the_path_of_the_value) {
  EXPECT_EQ(log("[{\"a\":1},{\"a\":13}]"),
            "f:1:15: error: keys[1].a: expected a number, as in the first key; correct it");
  EXPECT_EQ(log("[{\"é\":\"ü\",\"b\":[1, 13 ]}]"),
            "f:1:19: error: keys[0].b[1]: expected a number, as in the first key; correct it");
  EXPECT_EQ(log("[\n{\"a\":\n  13\n}]"), "f:3:3: error: keys[0].a: expected a number, as in the first key; correct it");
  EXPECT_EQ(log("[{\"a\":\"\\\"\\\\\",\"b\":\"bad\"}]"),
            "f:1:18: error: keys[0].b: expected a number, as in the first key; correct it");
  EXPECT_EQ(log("{\"a\":1}\n{\"a\":{},\"b\":[\"bad\"]}"),
            "f:2:14: error: keys[1].b[0]: expected a number, as in the first key; correct it");
}

TEST(ObjectReader, positions_are_those_in_the_file_that_the_chunk_is_from) {
  const Chunk chunk{"[{\"a\":1,\"b\":13},\n{\"a\":13}]", 7, 5, 40};
  EXPECT_EQ(error_of([&] { Log(chunk).parse(); }),
            "f:7:17: error: keys[40].b: expected a number, as in the first key; correct it");
  const Chunk later{"[{\"a\":1},\n{\"a\":13}]", 7, 5, 40};
  EXPECT_EQ(error_of([&] { Log(later).parse(); }),
            "f:8:6: error: keys[41].a: expected a number, as in the first key; correct it")
      << "the column is the chunk's on one line only";
}

TEST(ObjectReader, a_value_for_a_key_is_an_error_at_its_position) {
  EXPECT_EQ(log("[{},5]"), "f:1:5: error: a number where a key was expected; expected an object; correct it");
  EXPECT_EQ(log("[{},true]"), "f:1:5: error: true where a key was expected; expected an object; correct it");
  EXPECT_EQ(log("[]"), "f:1:2: error: nothing where a key was expected; expected an object; remove the comma");
  EXPECT_EQ(log("{}\n5\n"), "f:2:1: error: a number where a key was expected; expected an object; correct it");
}

TEST(ObjectReader, an_array_for_a_key_is_an_error_at_its_bracket) {
  EXPECT_EQ(log("[{},[0]]"), "f:1:5: error: an array where a key was expected; expected an object; correct it");
}

TEST(ObjectReader, the_first_wrong_token_is_an_error_with_what_was_expected) {
  const std::pair<const char*, const char*> faults[] = {
      {"[{\"a\":1,,}]", "f:1:9: error: not JSON: \",\"; expected a name in quotes"},
      {"[{\"é\":1}\n}", "f:2:1: error: not JSON: \"}\"; expected a comma or ]"},
      {"{\"a\":1}\n{\"a\"}\n", "f:2:5: error: not JSON: \"}\"; expected a colon"},
      {"[{\"a\":1}] x", "f:1:11: error: not JSON: \"x\" after the last bracket"},
      {"{\"a\":1}{\"a\":2}", "f:1:8: error: not JSON: \"{\" after the last bracket"},
      {"[{\"a\":01}]", "f:1:7: error: not JSON: \"01\"; expected a value"},
      {"[{\"a\":1", "f:1:7: error: not JSON: the text ends early"},
      {"[{\"a\":\"b}]", "f:1:7: error: not JSON: the string \"b}]\" is not closed"},
      {"[{\"a\":\"b\\q\"}]", "f:1:10: error: not JSON: the last character of \"b\\q\""}};
  for (const auto& [text, start] : faults) {
    const std::string error = log(text);
    EXPECT_TRUE(error.starts_with(start)) << error;
    EXPECT_EQ(error.find("json.exception"), std::string::npos) << error;
  }
}

TEST(ObjectReader, a_number_too_large_has_its_own_error) {
  EXPECT_EQ(log("[{\"a\":1e999}]"),
            "f:1:7: error: \"1e999\" is not a finite double; expected less than 1.8e308 in size; correct it");
}

TEST(ObjectReader, a_tiny_number_is_zero) { EXPECT_EQ(log("[{\"a\":1e-400}]"), "1{ a:0}"); }

}  // namespace
}  // namespace tcb
