// JSON scanner: strings and brackets.
#include "read/json/scanner.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tcb {
namespace {

/// A scanner that has read a text whole.
JsonScanner scanner_of(const std::string& text) {
  JsonScanner scanner([text, read = false]() mutable -> std::optional<std::string> {
    return std::exchange(read, true) ? std::nullopt : std::optional(text);
  });
  (void)scanner.read_more();
  return scanner;
}

TEST(JsonScanner, structure_in_strings_is_skipped) {
  JsonScanner scanner = scanner_of(R"("a,\"[" , 1)");
  ASSERT_TRUE(scanner.skip_to_structure());
  EXPECT_EQ(scanner.view().substr(scanner.at), ", 1");
  JsonScanner open = scanner_of("\"a,\\");
  EXPECT_FALSE(open.skip_to_structure());
  EXPECT_TRUE(open.in_string);
}

TEST(JsonScanner, a_plain_object_is_skipped_and_others_are_not) {
  JsonScanner plain = scanner_of(R"({"a":"]"})");
  plain.skip_plain_object();
  EXPECT_EQ(plain.now(), '"') << "its brace is the next";
  EXPECT_EQ(plain.at, 7U);
  for (const char* text : {R"({"a":{}})", R"({"a":"}"})", R"({"a":"\""})", R"({"a":1)"}) {
    JsonScanner other = scanner_of(text);
    other.skip_plain_object();
    EXPECT_EQ(other.at, 0U) << text;
  }
}

}  // namespace
}  // namespace tcb
