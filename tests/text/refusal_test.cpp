// Refusals: texts shown so that they can be read, and the remedy that fits.
#include "text/refusal.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

using testing::EndsWith;

TEST(Shown, what_cannot_be_shown_is_written_as_a_number) {
  EXPECT_EQ(shown("a\tb"), "\"a\\x09b\"");
  EXPECT_EQ(shown(std::string_view("\0x", 2)), "\"\\x00x\"");
  EXPECT_EQ(shown("\xFC"
                  "ber"),
            "\"\\xFCber\"");
  EXPECT_EQ(shown("\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80"), "\"\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80\"");
  EXPECT_EQ(shown("\xE2\x82"), "\"\\xE2\\x82\"") << "a character that is cut off";
}

TEST(Shown, long_text_is_cut) { EXPECT_EQ(shown(std::string(1000, 'a')), "\"" + std::string(40, 'a') + "…\""); }

TEST(FindForeign, finds_what_is_no_utf_8) {
  for (const char* text : {"", "abc", "\xC3\xBC", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF"}) {
    EXPECT_EQ(find_foreign(text), std::string::npos) << text;
  }
  for (const char* text :
       {"a\xFC", "a\xC0\x80", "a\xE0\x80\x80", "a\xED\xA0\x80", "a\xF4\x90\x80\x80", "a\x80", "a\xF8"}) {
    EXPECT_EQ(find_foreign(text), 1U) << text;
  }
}

TEST(NoNumber, names_the_remedy_that_fits) {
  EXPECT_THAT(no_number("", '.'), EndsWith("give --missing skip-row, skip-cell or break"));
  EXPECT_THAT(no_number("0,5", '.'), EndsWith("give --decimal , if this is a decimal comma"));
  EXPECT_THAT(no_number("1.234,5", '.'), EndsWith("correct the cell")) << "that is two marks";
  EXPECT_THAT(no_number("1.5", ','), EndsWith("correct the cell, or take --decimal out"));
  EXPECT_THAT(no_number("1,5e999", ','), EndsWith("expected less than 1.8e308 in size; correct the cell"));
  EXPECT_THAT(no_number("1 2", '.'), EndsWith("give the delimiter with -d"));
  EXPECT_THAT(no_number("0x1F", '.'), EndsWith("expected a decimal such as -1.5 or 2e3; correct the cell"));
}

}  // namespace
}  // namespace tcb
