// UTF-8: columns in characters, invalid bytes, and texts as messages quote them.
#include "text/utf8.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

TEST(InQuotes, unprintable_bytes_are_escaped) {
  EXPECT_EQ(in_quotes("a\tb"), "\"a\\x09b\"");
  EXPECT_EQ(in_quotes(std::string_view("\0x", 2)), "\"\\x00x\"");
  EXPECT_EQ(in_quotes("\xFC"
                      "ber"),
            "\"\\xFCber\"");
  EXPECT_EQ(in_quotes("\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80"), "\"\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80\"");
  EXPECT_EQ(in_quotes("\xE2\x82"), "\"\\xE2\\x82\"") << "a character that is cut off";
}

TEST(InQuotes, long_text_is_cut) { EXPECT_EQ(in_quotes(std::string(1000, 'a')), "\"" + std::string(40, 'a') + "…\""); }

TEST(Utf8, the_first_invalid_byte_is_found) {
  for (const char* text : {"", "abc", "\xC3\xBC", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF"}) {
    EXPECT_EQ(find_invalid_utf8(text), std::string::npos) << text;
  }
  for (const char* text :
       {"a\xFC", "a\xC0\x80", "a\xE0\x80\x80", "a\xED\xA0\x80", "a\xF4\x90\x80\x80", "a\x80", "a\xF8"}) {
    EXPECT_EQ(find_invalid_utf8(text), 1U) << text;
  }
}

TEST(Utf8, control_characters_are_escaped_in_one_line) {
  EXPECT_EQ(in_one_line("a\nb\x7F\xC3\xBC"), "a\\x0Ab\\x7F\xC3\xBC");
  EXPECT_EQ(in_one_line("\xC2\x85\xE2\x80\xA8\x85"), "\\xC2\\x85\\xE2\\x80\\xA8\x85")
      << "NEL and LS; a byte alone remains";
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\xC2\\x9B31m")
      << "a control of Latin-1";
  EXPECT_EQ(printable("\x9B"), "\\x9B") << "no character";
  EXPECT_EQ(printable("a\u202Eb\u2066c\u200Fd\u2028e\u061Cf"),
            "a\\xE2\\x80\\xAEb\\xE2\\x81\\xA6c\\xE2\\x80\\x8Fd\\xE2\\x80\\xA8e\\xD8\\x9Cf")
      << "the direction of writing, and an end of a line";
  EXPECT_EQ(in_quotes("x\u202Ey"), "\"x\\xE2\\x80\\xAEy\"");
}

TEST(Utf8, columns_count_characters_after_the_last_line_end) {
  EXPECT_EQ(column_after("", 5), 5U);
  EXPECT_EQ(column_after("a\xC3\xBC", 5), 7U);
  EXPECT_EQ(column_after("abc\n\xE2\x82\xAC", 5), 2U);
  std::string text;
  for (std::uint64_t characters = 1; characters < 40; ++characters) {
    text += characters % 3 == 0 ? "\xE2\x82\xAC" : characters % 5 == 0 ? "\xF0\x9F\x98\x80" : "x";
    EXPECT_EQ(column_after(text, 1), characters + 1) << text;
  }
  const LinePosition position = position_after("a\nb\nc", {7, 3});
  EXPECT_EQ(position.line, 9U);
  EXPECT_EQ(position.column, 2U);
  EXPECT_EQ(count_lines("a\nb\n"), 2U);
}

}  // namespace
}  // namespace tcb
