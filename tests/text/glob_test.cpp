// Patterns: * is any text, ? any character.
#include "text/glob.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

TEST(Glob, matches_whole_names) {
  EXPECT_TRUE(matches("Ship/position", "Ship/position"));
  EXPECT_FALSE(matches("Ship/position", "Ship"));
  EXPECT_FALSE(matches("Ship", "Ship/position"));
  EXPECT_TRUE(matches("", ""));
  EXPECT_FALSE(matches("a", ""));
}

TEST(Glob, a_star_is_any_text_and_a_question_mark_any_character) {
  EXPECT_TRUE(matches("Ship/position", "*"));
  EXPECT_TRUE(matches("", "**"));
  EXPECT_TRUE(matches("Ship/position", "Sh?p/*"));
  EXPECT_TRUE(matches("Ship/position", "*/pos*on"));
  EXPECT_FALSE(matches("Ship/position", "*/pos*x"));
  EXPECT_TRUE(matches("aXbXc", "a*Xc"));
  EXPECT_FALSE(matches("Ship", "Ship?"));
}

}  // namespace
}  // namespace tcb
