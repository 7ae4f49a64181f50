// Names: suggestions within a third of their letters, and nothing farther; patterns; endings.
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

TEST(FileEnding, is_in_upper_or_lower_case) {
  EXPECT_TRUE(has_ending("a/keys.CSV", ".csv"));
  EXPECT_FALSE(has_ending("a/keyscsv", ".csv"));
}

TEST(FileEnding, is_not_the_whole_name) {
  EXPECT_FALSE(has_ending(".csv", ".csv"));
  EXPECT_FALSE(has_ending("a/.csv", ".csv"));
}

TEST(FileEnding, of_compressed_files_is_removed) {
  EXPECT_EQ(compression_ending("keys.csv.GZ"), ".gz");
  EXPECT_EQ(without_compression("keys.csv.GZ"), "keys.csv");
  EXPECT_EQ(without_compression("keys.zst"), "keys");
  EXPECT_EQ(compression_ending("keys.csv"), "");
  EXPECT_EQ(without_compression("a/.gz"), "a/.gz");
}

}  // namespace
}  // namespace tcb
