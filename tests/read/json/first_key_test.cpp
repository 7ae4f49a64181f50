// First key of JSON: the kinds of its members' values.
#include "read/json/first_key.hpp"

#include <gtest/gtest.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

/// Elements of an array as a part.
JsonPart part_of(const std::string& elements) { return {JsonPart::Kind::elements, {elements}}; }

/// The members as "NAME:KIND", with the count of numbers.
std::string kinds(const std::string& text, const std::vector<std::string>& signs = {}) {
  std::string out;
  for (const FoundMember& member : read_first_key(part_of(text), {}, signs).members) {
    const char* const kind = member.deep_numbers ? "numbers inside"
                             : member.nested     ? "nested"
                             : member.array      ? "array"
                             : member.text       ? "text"
                             : member.empty      ? "empty"
                                                 : "number";
    out += fmt::format("{}:{}:{} ", member.name, kind, member.numbers);
  }
  return out;
}

TEST(FirstKey, has_the_kinds_of_values) {
  EXPECT_EQ(kinds(R"({"t":0,"a":[1,2],"b":{"c":[3]},"d":[[[]]],"e":[],"f":"g","h":null,"i":true,"j":{"k":"l"}})"),
            "t:number:1 a:array:2 b:numbers inside:0 d:nested:0 e:empty:0 f:text:0 h:number:1 i:text:0 j:nested:0 ");
}

TEST(FirstKey, a_text_is_a_number_if_a_later_key_has_one_or_all_are_signs_of_missing_ones) {
  EXPECT_EQ(kinds(R"({"x":"lost"},{"x":1})"), "x:number:1 ");
  EXPECT_EQ(kinds(R"({"x":"N/A"},{"x":"-"})"), "x:number:1 ");
  EXPECT_EQ(kinds(R"({"x":"-"},{"x":"a"})"), "x:text:0 ");
  EXPECT_EQ(kinds(R"({"x":""},{"x":""})"), "x:text:0 ");
  EXPECT_EQ(kinds(R"({"x":"a"},{"y":1})"), "x:text:0 ");
  EXPECT_EQ(kinds(R"({"x":"lost"},{"x":"lost"})", {"lost"}), "x:number:1 ");
}

TEST(FirstKey, has_positions_and_paths) {
  const FirstKey key = read_first_key(part_of("{\"t\":0,\n\"x\":1}"), {}, {});
  EXPECT_EQ(key.position.line, 1U);
  EXPECT_EQ(key.position.column, 1U);
  EXPECT_EQ(key.members.at(1).path, "keys[0].x");
  EXPECT_EQ(key.members.at(1).position.line, 2U);
}

}  // namespace
}  // namespace tcb
