// Suggestions: names within a third of their letters, and nothing farther.
#include "text/suggest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tcb {
namespace {

std::string nearest(std::string_view name, std::string_view known) { return nearest_name(name, std::array{known}); }

TEST(Nearest, one_letter_changed_dropped_added_or_in_other_case) {
  for (const char* name : {"stop", "ste", "steps", "Step", "tep", "sstep"}) {
    EXPECT_EQ(nearest(name, "step"), "step") << name;
  }
}

TEST(Nearest, a_third_of_the_letters_of_the_longer_name_is_near_and_more_is_not) {
  EXPECT_EQ(nearest("abX", "abc"), "abc");
  EXPECT_EQ(nearest("aX", "ab"), "");
  EXPECT_EQ(nearest("aXX", "abc"), "");
  EXPECT_EQ(nearest("abcdXX", "abcdef"), "abcdef");
  EXPECT_EQ(nearest("abcXX", "abcde"), "");
  EXPECT_EQ(nearest("abcdXXX", "abcdefg"), "");
  EXPECT_EQ(nearest("abcd", "abcdef"), "abcdef") << "two of six are dropped";
  EXPECT_EQ(nearest("abc", "abcde"), "") << "two of five are more than a third";
}

TEST(Nearest, the_distance_is_the_least_number_of_edits) {
  EXPECT_EQ(nearest("kitten___", "sitting__"), "sitting__") << "three of nine";
  EXPECT_EQ(nearest("kitten__", "sitting_"), "") << "three of eight";
}

TEST(Nearest, the_nearest_of_several_is_named) {
  const std::array<std::string_view, 3> known{"--to", "--from", "--format"};
  EXPECT_EQ(nearest_name("--fron", known), "--from");
  EXPECT_EQ(nearest_name("--formats", known), "--format");
  EXPECT_EQ(nearest_name("--quiet", known), "");
}

TEST(LikelyName, is_the_nearest_or_the_only_one_that_begins_so_or_contains_it) {
  const std::array<std::string_view, 5> known{"uniform", "finite-difference", "interval", "interval-c", "3dsmax"};
  EXPECT_EQ(likely_name("unifrm", known), "uniform");
  EXPECT_EQ(likely_name("fin", known), "finite-difference");
  EXPECT_EQ(likely_name("difference", known), "finite-difference");
  EXPECT_EQ(likely_name("max", known), "3dsmax");
  EXPECT_EQ(likely_name("i", known), "") << "one letter is too little";
  EXPECT_EQ(likely_name("int", known), "") << "two begin so";
  EXPECT_EQ(likely_name("xamsd3", known), "3dsmax") << "the same letters";
  EXPECT_EQ(likely_name("velocity", known), "");
}

TEST(Nearest, of_no_names_none_is_near) {
  EXPECT_EQ(nearest_name("step", {}), "");
  EXPECT_EQ(nearest("", "step"), "");
}

TEST(InShell, words_with_other_characters_are_quoted) {
  EXPECT_EQ(in_shell("time=header.stamp"), "time=header.stamp");
  EXPECT_EQ(in_shell("time=timestamp [ns]"), "'time=timestamp [ns]'");
  EXPECT_EQ(in_shell("it's"), "'it'\\''s'");
  EXPECT_EQ(in_shell(""), "''");
}

}  // namespace
}  // namespace tcb
