// Endings of file names.
#include "text/file_ending.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

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
