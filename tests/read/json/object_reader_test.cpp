// Object reader: the events of each key, and the text positions of errors.
#include "read/json/object_reader.hpp"

#include <gtest/gtest.h>

#include "read/json/errors.hpp"
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
  bool on_member(const std::string& name) override {
    member_ = name;
    return add(" " + name + ":");
  }
  std::string_view member() const override { return member_; }
  bool on_number(const spline::Time<double>& value) override {
    if (value.hi == 13) throw at_value(json::number_expected());
    return add(index() + shown_time(value));
  }
  bool on_text(std::string_view value) override {
    if (value == "bad") throw at_value(json::number_expected());
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

  std::string member_;
};

JsonPart part_of(const std::string& text) { return {JsonPart::Kind::elements, {text}}; }

JsonPart lines_of(const std::string& text) { return {JsonPart::Kind::lines, {text}}; }

std::string log(const JsonPart& part) {
  Log reader(part);
  const std::string error = error_of([&] { reader.parse(); });
  return error == "no error" ? reader.text : error;
}

TEST(ObjectReader, an_array_of_keys_is_read_member_by_member) {
  EXPECT_EQ(log(part_of("{\"a\":1,\"b\":[2,\"x\",null],\"c\":true},\n\n{\"a\":\"é\"}")),
            "1{ a:1 b: 0=2 1=<x> 2=<null>/3 c:<true>}3{ a:<é>}");
}

TEST(ObjectReader, an_object_per_line_is_read_like_an_array) {
  EXPECT_EQ(log(lines_of("{\"a\":1}\r\n \t\r\n{\"a\":[]}")), "1{ a:1}3{ a:/0}");
}

TEST(ObjectReader, numbers_have_the_precision_of_a_time) {
  EXPECT_EQ(
      log(part_of("{\"a\":9007199254740993,\"b\":-9007199254740993,\"c\":0.5,\"d\":1e3,\"e\":18446744073709551616}")),
      "1{ a:9007199254740993 b:-9007199254740993 c:0.5 d:1000 e:1.8446744073709552e+19}");
}

TEST(ObjectReader, elements_that_are_arrays_or_objects_count_as_elements) {
  EXPECT_EQ(log(part_of("{\"a\":[[7],{\"b\":8},9]}")), "1{ a: 0=<nested> 1=<nested> 2=9/3}");
}

TEST(ObjectReader, values_in_an_object_of_a_member_are_ignored) {
  EXPECT_EQ(log(part_of("{\"a\":{\"b\":7,\"c\":[8],\"d\":\"x\"},\"e\":9}")), "1{ a:<nested> e:9}");
}

TEST(ObjectReader, the_members_of_tcb_are_members_of_the_key) {
  EXPECT_EQ(
      log(part_of("{\"tcb\":{\"x\":[1,2,3],\"y\":4,\"z\":{\"w\":5},\"v\":[[6]]},\"e\":9,\"a\":{\"tcb\":{\"x\":7}}}")),
      "1{ tcb: tcb.x: 0=1 1=2 2=3/3 tcb.y:4 tcb.z:<nested> tcb.v: 0=<nested>/1 e:9 a:<nested>}");
  EXPECT_EQ(log(lines_of("{\"tcb\":{}}\n{\"tcb\":[1],\"b\":2}")), "1{ tcb:}2{ tcb: 0=1/1 b:2}");
}

TEST(ObjectReader, returning_false_ends_the_parsing) {
  const JsonPart part = lines_of("{\"a\":1}\n{\"a\":2}\n{");
  Log reader(part);
  reader.stop_at_key_end = true;
  reader.parse();
  EXPECT_EQ(reader.text, "1{ a:1}");
}

TEST(ObjectReader, one_object_may_go_over_lines) {
  const std::string text = "{\"a\":\n1,\n\"b\":[\n2]}";
  const JsonPart object{JsonPart::Kind::object, {text}};
  Log reader(object);
  reader.parse();
  EXPECT_EQ(reader.text, "1{ a:1 b: 0=2/1}");
  EXPECT_NE(error_of([&] { Log(lines_of(text)).parse(); }), "no error") << "but an object per line ends with its line";
}

TEST(ObjectReader, errors_have_the_position_and_the_path_of_the_value) {
  EXPECT_EQ(log(part_of("{\"a\":1},{\"a\":13}")),
            "f:1:14: error: keys[1].a: this is not a number; expected one, as in the first key; correct it");
  EXPECT_EQ(log(part_of("{\"é\":\"ü\",\"b\":[1, 13 ]}")),
            "f:1:18: error: keys[0].b[1]: this is not a number; expected one, as in the first key; correct it");
  EXPECT_EQ(log(part_of("\n{\"a\":\n  13\n}")),
            "f:3:3: error: keys[0].a: this is not a number; expected one, as in the first key; correct it");
  EXPECT_EQ(log(part_of("{\"a\":\"\\\"\\\\\",\"b\":\"bad\"}")),
            "f:1:17: error: keys[0].b: this is not a number; expected one, as in the first key; correct it");
  EXPECT_EQ(log(lines_of("{\"a\":1}\n{\"a\":{},\"b\":[\"bad\"]}")),
            "f:2:14: error: keys[1].b[0]: this is not a number; expected one, as in the first key; correct it");
}

TEST(ObjectReader, positions_are_those_in_the_file_that_the_chunk_is_from) {
  const JsonPart part{JsonPart::Kind::elements, {"{\"a\":1,\"b\":13},\n{\"a\":13}", 7, 5, 40}};
  EXPECT_EQ(error_of([&] { Log(part).parse(); }),
            "f:7:16: error: keys[40].b: this is not a number; expected one, as in the first key; correct it");
  const JsonPart later{JsonPart::Kind::elements, {"{\"a\":1},\n{\"a\":13}", 7, 5, 40}};
  EXPECT_EQ(error_of([&] { Log(later).parse(); }),
            "f:8:6: error: keys[41].a: this is not a number; expected one, as in the first key; correct it")
      << "the column is the part's on one line only";
}

TEST(ObjectReader, a_value_for_a_key_is_an_error_at_its_position) {
  EXPECT_EQ(log(part_of("{},5")), "f:1:4: error: found a number as a key; expected an object; correct it");
  EXPECT_EQ(log(part_of("{},true")), "f:1:4: error: found \"true\" as a key; expected an object; correct it");
  EXPECT_EQ(log(part_of("")), "f:1:1: error: no key before or after a comma; expected an object; remove the comma");
  EXPECT_EQ(log(lines_of("{}\n5\n")), "f:2:1: error: found a number as a key; expected an object; correct it");
}

TEST(ObjectReader, an_array_for_a_key_is_an_error_at_its_bracket) {
  EXPECT_EQ(log(part_of("{},[0]")), "f:1:4: error: found an array as a key; expected an object; correct it");
}

TEST(ObjectReader, the_first_wrong_token_is_an_error_with_what_was_expected) {
  const std::pair<JsonPart, const char*> faults[] = {
      {part_of("{\"a\":1,,}"), "f:1:8: error: not JSON: found \",\"; expected another value or member"},
      {part_of("{\"é\":1}\n}"), "f:2:1: error: not JSON: found \"}\"; expected a comma or a closing bracket"},
      {part_of("{\"a\":1}5"), "f:1:8: error: not JSON: found \"5\"; expected a comma or a closing bracket"},
      {part_of("{,}"), "f:1:2: error: not JSON: found \",\"; expected a name in quotes"},
      {part_of("{\"a\":1 \"b\":2}"), "f:1:8: error: not JSON: found \"b\"; expected a comma or a closing bracket"},
      {part_of("{\"a\":tru}"), "f:1:6: error: not JSON: found \"tru}\"; expected a value"},
      {part_of("{\"a\":-x}"), "f:1:6: error: not JSON: found \"-x\"; expected a value"},
      {part_of("{\"a\":01}"), "f:1:7: error: not JSON: found \"1\"; expected a comma or a closing bracket"},
      {part_of("{\"a\":[1,,2]}"), "f:1:9: error: not JSON: found \",\"; expected another value or member"},
      {part_of("{\"a\":[,1]}"), "f:1:7: error: not JSON: found \",\"; expected a value"},
      {part_of("{\"a\":1"), "f:1:7: error: not JSON: the text ends too early"},
      {part_of("{\"a\":\"b}"), "f:1:6: error: not JSON: a string is not closed"},
      {part_of("{\"a\":\"b\\q\"}"), "f:1:9: error: not JSON: the last character of \"b\\q\""},
      {part_of("{\"a\":\"\\u12\"}"), "f:1:11: error: not JSON: the last character of \"\\u12\"\""},
      {part_of("{},,{}"), "f:1:4: error: no key before or after a comma"},
      {part_of(",{}"), "f:1:1: error: no key before or after a comma"},
      {part_of("{},"), "f:1:4: error: no key before or after a comma"},
      {lines_of("{\"a\":1}\n{\"a\"}\n"), "f:2:5: error: not JSON: found \"}\"; expected a colon"},
      {lines_of("{\"a\":1}{\"a\":2}"), "f:1:8: error: not JSON: found \"{\"; expected nothing after the last bracket"}};
  for (const auto& [part, start] : faults) {
    const std::string error = log(part);
    EXPECT_TRUE(error.starts_with(start)) << error << "\ninstead of " << start;
    EXPECT_EQ(error.find("json.exception"), std::string::npos) << error;
  }
}

TEST(ObjectReader, a_number_too_large_has_its_own_error) {
  EXPECT_EQ(log(part_of("{\"a\":1e999}")),
            "f:1:6: error: \"1e999\" is too large for a double; expected less than 1.8e308 in size; correct it");
}

TEST(ObjectReader, a_tiny_number_is_zero) { EXPECT_EQ(log(part_of("{\"a\":1e-400}")), "1{ a:0}"); }

}  // namespace
}  // namespace tcb
