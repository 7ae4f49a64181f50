// JSON events: what is heard of each key, and where faults are placed.
#include "input/json/events.hpp"

#include <gtest/gtest.h>

#include "input/reading.hpp"

namespace tcb {
namespace {

/// Writes down what it hears, and refuses the number 13 and the text "bad".
class Log : public JsonEvents {
 public:
  using JsonEvents::JsonEvents;
  std::string text;
  bool stop_at_key_end = false;

 private:
  bool on_key_start() override { return add(fmt::format("{}{{", place_of_key().line)); }
  bool on_key_end() override { return add("}") && !stop_at_key_end; }
  bool on_member(const std::string& name) override { return add(" " + name + ":"); }
  bool on_number(const spline::Time<double>& value) override {
    if (value.hi == 13) fail(path());
    return add(index() + shown_time(value));
  }
  bool on_other(std::string_view value) override {
    if (value == "bad") fail(path());
    return add(fmt::format("{}<{}>", index(), value));
  }
  bool on_array_end() override { return add(fmt::format("/{}", element())); }

  std::string index() const { return in_array() ? fmt::format(" {}=", element()) : ""; }
  bool add(const std::string& more) {
    text += more;
    return true;
  }
};

std::string log(const std::string& text) {
  const Chunk chunk{text};
  Log events(chunk);
  const std::string error = error_of([&] { events.parse(); });
  return error == "no error" ? events.text : error;
}

TEST(JsonEvents, an_array_of_keys_is_heard_member_by_member) {
  EXPECT_EQ(log("[{\"a\":1,\"b\":[2,\"x\",null],\"c\":true},\n\n{\"a\":\"é\"}]"),
            "1{ a:1 b: 0=2 1=<x> 2=<null>/3 c:<true>}3{ a:<é>}");
}

TEST(JsonEvents, an_object_a_line_is_heard_like_an_array) {
  EXPECT_EQ(log("{\"a\":1}\r\n \t\r\n{\"a\":[]}"), "1{ a:1}3{ a:/0}");
}

TEST(JsonEvents, numbers_keep_what_a_time_holds) {
  EXPECT_EQ(log("[{\"a\":9007199254740993,\"b\":-9007199254740993,\"c\":0.5,\"d\":1e3,\"e\":18446744073709551616}]"),
            "1{ a:9007199254740993 b:-9007199254740993 c:0.5 d:1000 e:1.8446744073709552e+19}");
}

TEST(JsonEvents, elements_that_are_arrays_or_objects_count_as_elements) {
  EXPECT_EQ(log("[{\"a\":[[7],{\"b\":8},9]}]"), "1{ a: 0=<an array> 1=<an object> 2=9/3}");
}

TEST(JsonEvents, what_lies_in_an_object_of_a_member_is_passed_over) {
  EXPECT_EQ(log("[{\"a\":{\"b\":7,\"c\":[8],\"d\":\"x\"},\"e\":9}]"), "1{ a:<an object> e:9}");
}

TEST(JsonEvents, returning_false_ends_the_parsing) {
  const Chunk chunk{"{\"a\":1}\n{\"a\":2}\n{"};
  Log events(chunk);
  events.stop_at_key_end = true;
  events.parse();
  EXPECT_EQ(events.text, "1{ a:1}");
}

TEST(JsonEvents, one_object_may_go_over_lines) {
  const Chunk chunk{"{\"a\":\n1,\n\"b\":[\n2]}"};
  Log events(chunk);
  events.parse_object();
  EXPECT_EQ(events.text, "1{ a:1 b: 0=2/1}");
  EXPECT_NE(error_of([&] { Log(chunk).parse(); }), "no error") << "but an object a line ends with its line";
}

TEST(JsonEvents, faults_are_placed_at_the_value_with_its_path) {
  EXPECT_EQ(log("[{\"a\":1},{\"a\":13}]"), "f:1:15: error: keys[1].a");
  EXPECT_EQ(log("[{\"é\":\"ü\",\"b\":[1, 13 ]}]"), "f:1:19: error: keys[0].b[1]");
  EXPECT_EQ(log("[\n{\"a\":\n  13\n}]"), "f:3:3: error: keys[0].a");
  EXPECT_EQ(log("[{\"a\":\"\\\"\\\\\",\"b\":\"bad\"}]"), "f:1:18: error: keys[0].b");
  EXPECT_EQ(log("{\"a\":1}\n{\"a\":{},\"b\":[\"bad\"]}"), "f:2:14: error: keys[1].b[0]");
}

TEST(JsonEvents, faults_are_placed_in_the_file_that_the_chunk_is_from) {
  const Chunk chunk{"[{\"a\":1,\"b\":13},\n{\"a\":13}]", 7, 5, 40};
  EXPECT_EQ(error_of([&] { Log(chunk).parse(); }), "f:7:17: error: keys[40].b");
  const Chunk later{"[{\"a\":1},\n{\"a\":13}]", 7, 5, 40};
  EXPECT_EQ(error_of([&] { Log(later).parse(); }), "f:8:6: error: keys[41].a")
      << "the column is the chunk's on one line only";
}

TEST(JsonEvents, what_is_no_key_is_refused_at_its_place) {
  EXPECT_EQ(log("[{},5]"), "f:1:5: error: a number where a key was expected; expected {…}; correct it");
  EXPECT_EQ(log("[{},true]"), "f:1:5: error: true where a key was expected; expected {…}; correct it");
  EXPECT_EQ(log("[]"), "f:1:2: error: nothing where a key was expected; expected {…}; take the comma out");
  EXPECT_EQ(log("{}\n5\n"), "f:2:1: error: a number where a key was expected; expected {…}; correct it");
}

TEST(JsonEvents, an_array_for_a_key_is_refused_at_its_bracket) {
  EXPECT_EQ(log("[{},[0]]"), "f:1:5: error: an array where a key was expected; expected {…}; correct it");
}

TEST(JsonEvents, text_that_is_not_json_is_refused_at_its_place) {
  const std::pair<const char*, const char*> faults[] = {
      {"[{\"a\":1,,}]", "f:1:9: error: not JSON: syntax error"},
      {"[{\"é\":1}\n}", "f:2:1: error: not JSON: syntax error"},
      {"{\"a\":1}\n{\"a\"}\n", "f:2:5: error: not JSON: syntax error"},
      {"[{\"a\":1}] x", "f:1:11: error: not JSON: syntax error"},
      {"{\"a\":1}{\"a\":2}", "f:1:8: error: not JSON: syntax error"}};
  for (const auto& [text, start] : faults) {
    const std::string error = log(text);
    EXPECT_TRUE(error.starts_with(start)) << error;
    EXPECT_TRUE(error.ends_with("; correct the text")) << error;
    EXPECT_EQ(error.find("json.exception"), std::string::npos) << error;
  }
}

TEST(JsonEvents, a_number_too_large_is_json_and_refused_as_a_number) {
  EXPECT_EQ(log("[{\"a\":1e999}]"),
            "f:1:7: error: \"1e999\" is not a finite double; expected less than 1.8e308 in size; correct it");
}

TEST(JsonEvents, a_tiny_number_is_zero) { EXPECT_EQ(log("[{\"a\":1e-400}]"), "1{ a:0}"); }

}  // namespace
}  // namespace tcb
