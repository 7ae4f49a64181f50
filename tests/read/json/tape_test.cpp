// Tape: the values of a JSON text with their places, and the text positions of what is not JSON.
#include "read/json/tape.hpp"

#include <gtest/gtest.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

JsonPart list_of(const std::string& elements) { return {JsonPart::Kind::list, {"[" + elements + "]"}}; }
JsonPart values_of(const std::string& text) { return {JsonPart::Kind::values, {text}}; }

/// The error of a part.
std::string refusal(const JsonPart& part) {
  return error_of([&] {
    JsonTape tape(part);
    while (part.kind == JsonPart::Kind::values && tape.read_next()) {
    }
  });
}

TEST(JsonTape, values_have_their_kinds_and_texts) {
  const JsonPart part =
      list_of(R"( {"a" : -1.50e3,"b\u0041\"":["é\n", true,null ]},"\\",0,false,{},18446744073709551616)");
  const JsonTape tape(part);
  std::string shown;
  for (std::size_t value = 0; value < tape.size(); ++value) {
    const Kind kind = tape.kind(value);
    const bool is_text = kind == Kind::string || kind == Kind::name;
    shown += fmt::format("{}{} ",
                         is_text                   ? tape.text(value)
                         : tape[value].is_nested() ? ""
                                                   : tape.written(value),
                         "0btsnao"[static_cast<std::size_t>(kind)]);
  }
  EXPECT_EQ(shown, "a o an -1.50e3t bA\"n a é\ns trueb null0 \\s 0t falseb o 18446744073709551616t ");
  EXPECT_EQ(tape.count(0), 6U);
  EXPECT_EQ(tape.written(1), R"({"a" : -1.50e3,"b\u0041\"":["é\n", true,null ]})");
  EXPECT_EQ(tape.path(0, 7), "[0].bA\"[1]");
}

TEST(JsonTape, a_member_is_found_once) {
  const JsonPart part = list_of(R"({"a":1,"b":2,"a":3})");
  const JsonTape tape(part);
  EXPECT_EQ(tape.written(tape.member(1, "b").value()), "2");
  EXPECT_FALSE(tape.member(1, "c"));
  EXPECT_EQ(error_of([&] { (void)tape.member(1, "a"); }),
            "f:1:15: error: a: the object has this member twice; expected it once; remove one");
}

TEST(JsonTape, values_follow_each_other_and_a_faulty_one_is_skipped) {
  const JsonPart part = values_of("{\"a\":1}{\"b\":\n[2]} \xEF\xBB\xBF{\"c\":}\n5\n{\"d\":3}");
  JsonTape tape(part);
  std::string shown;
  for (bool more = true; more;) {
    try {
      more = tape.read_next();
      if (more) shown += fmt::format("{};", tape.written(0));
    } catch (const Error& error) {
      shown += error_text(error.in("f")) + ";";
    }
  }
  EXPECT_EQ(
      shown,
      "{\"a\":1};{\"b\":\n[2]};f:2:12: error: not JSON: found \"}\"; expected a value; correct the text;5;{\"d\":3};");
}

TEST(JsonTape, positions_are_those_in_the_file_that_the_part_is_from) {
  JsonPart part = list_of("{\"é\":1},\n13");
  part.chunk.line = 7;
  part.chunk.column = 5;
  const JsonTape tape(part);
  EXPECT_EQ(tape.position(1).column, 6U);
  EXPECT_EQ(tape.position(3).line, 7U);
  EXPECT_EQ(tape.position(3).column, 11U);
  EXPECT_EQ(tape.position(4).line, 8U);
  EXPECT_EQ(tape.position(4).column, 1U) << "the column is the part's on one line only";
  JsonPart object{JsonPart::Kind::object, {"{\"a\":1,\"keys\":[]\n,\"b\":2}"}};
  object.seam = 15;
  object.after = {9, 4};
  const JsonTape around(object);
  EXPECT_EQ(around.position(around.member(0, "b").value()).line, 10U);
  EXPECT_EQ(around.position(around.member(0, "keys").value()).column, 15U);
}

TEST(JsonTape, nan_is_null_by_its_text) {
  const JsonPart part = list_of(R"({"a":NaN,"b":"NaN","c":[NaN , 1]})");
  const JsonTape tape(part);
  EXPECT_EQ(tape.kind(3), Kind::null);
  EXPECT_EQ(tape.written(3), "NaN");
  EXPECT_EQ(tape.text(5), "NaN");
  for (const char* text : {"NaN1", "-NaN", "nan", "Nan", "{NaN:1}"}) {
    EXPECT_NE(refusal(list_of(text)), "no error") << text;
  }
}

TEST(JsonTape, numbers_are_as_written_and_have_the_syntax_of_json) {
  const std::string numbers = R"([0,-0,100200.0030,-1.50e+07,1E-400,"1.5\"2",120])";
  const JsonPart part = list_of(numbers);
  const JsonTape tape(part);
  std::string shown;
  for (const std::size_t value : tape.inside(1)) shown += fmt::format("{},", tape.written(value));
  EXPECT_EQ("[" + shown, numbers.substr(0, numbers.size() - 1) + ",");
  for (const char* text :
       {"00", "01", "-01", "1.5.2", "1.05.2", "1..2", "1.", ".5", "1e", "1e+", "1e5.5", "+1", "--1"}) {
    EXPECT_NE(refusal(list_of(text)), "no error") << text;
  }
}

TEST(JsonTape, nesting_is_limited) {
  const auto nested = [](std::size_t levels) {
    return list_of(std::string(levels - 1, '[') + std::string(levels - 1, ']'));
  };
  EXPECT_EQ(refusal(nested(100)), "no error");
  EXPECT_EQ(refusal(nested(101)), "f:1:101: error: this is nested deeper than 100 brackets; expected fewer; remove it");
  EXPECT_EQ(refusal(list_of(std::string(1000000, '['))),
            "f:1:101: error: this is nested deeper than 100 brackets; expected fewer; remove it");
}

TEST(JsonTape, the_first_wrong_token_is_an_error_with_what_was_expected) {
  const std::pair<JsonPart, const char*> faults[] = {
      {list_of("{\"a\":1,,}"), "f:1:9: error: not JSON: found \",\"; expected another value or member"},
      {list_of("{\"é\":1}\n}"), "f:2:1: error: not JSON: found \"}\"; expected a comma or a closing bracket"},
      {list_of("{\"a\":1}5"), "f:1:9: error: not JSON: found \"5\"; expected a comma or a closing bracket"},
      {list_of("{,}"), "f:1:3: error: not JSON: found \",\"; expected a name in quotes"},
      {list_of("{\"a\":1 \"b\":2}"), "f:1:9: error: not JSON: found \"b\"; expected a comma or a closing bracket"},
      {list_of("{\"a\":tru}"), "f:1:7: error: not JSON: found \"tru\"; expected a value"},
      {list_of("{\"a\":-x}"), "f:1:7: error: not JSON: found \"-x\"; expected a value"},
      {list_of("{\"a\":01}"), "f:1:8: error: not JSON: found \"1\"; expected a comma or a closing bracket"},
      {list_of("[2-5,1]"), "f:1:4: error: not JSON: found \"-5\"; expected a comma or a closing bracket"},
      {list_of("{\"a\":[1,,2]}"), "f:1:10: error: not JSON: found \",\"; expected another value or member"},
      {list_of("{\"a\":[,1]}"), "f:1:8: error: not JSON: found \",\"; expected a value"},
      {list_of("{\"a\":1"), "f:1:8: error: not JSON: the text ends too early"},
      {list_of("{\"a\":\"b}"), "f:1:7: error: not JSON: a string is not closed"},
      {list_of("{\"a\":\"b\\q\"}"), "f:1:10: error: not JSON: the last character of \"b\\q\""},
      {list_of("{\"a\":\"\\u12\"}"), "f:1:12: error: not JSON: the last character of \"\\u12\"\""},
      {list_of("{\"a\":1e999}"),
       "f:1:7: error: \"1e999\" is too large for a double; expected less than 1.8e308 in size; correct it"},
      {list_of("{},,{}"), "f:1:5: error: no key before or after a comma"},
      {list_of(",{}"), "f:1:2: error: no key before or after a comma"},
      {list_of("{},"), "f:1:5: error: no key before or after a comma"},
      {values_of("{\"a\":1}\n{\"a\"}\n"), "f:2:5: error: not JSON: found \"}\"; expected a colon"},
      {values_of("{\"a\":1},{\"a\":2}"), "f:1:8: error: not JSON: found \",\"; expected a value"}};
  for (const auto& [part, start] : faults) {
    const std::string error = refusal(part);
    EXPECT_TRUE(error.starts_with(start)) << error << "\ninstead of " << start;
    EXPECT_EQ(error.find("json.exception"), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace tcb
