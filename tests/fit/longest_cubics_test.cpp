// Longest cubics: how many cubics the samples need at least.
#include "fit/fit.hpp"

#include <gtest/gtest.h>

#include "fit/recordings.hpp"

namespace tcb {
namespace {

TEST(LongestCubics, a_cubic_is_one_piece) {
  const auto cubic = [](double t) { return 3 * t * t * t - 20 * t * t + t - 7; };
  EXPECT_EQ(longest_cubics(recording_of({cubic}, 1000, 0.01, 1e-9)).size(), 1U);
}

TEST(LongestCubics, plateaus_are_pieces) {
  const auto plateaus = [](double t) { return std::fmod(std::floor(t), 2.0); };
  const auto cubics = longest_cubics(recording_of({plateaus}, 1000, 1.0 / 128, 0.01));  // of 128 samples each
  ASSERT_EQ(cubics.size(), 8U);
  for (std::size_t i = 0; i < cubics.size(); ++i) EXPECT_EQ(cubics[i], i * 128);
}

/// The best cubic approximation of t^4 on an interval of length h is off by h^4/128.
TEST(LongestCubics, of_the_fourth_power_have_the_length_of_chebyshev) {
  const auto power = [](double t) { return t * t * t * t; };
  const double longest = 0.5, tolerance = longest * longest * longest * longest / 128;
  const auto cubics = longest_cubics(recording_of({power}, 4001, 0.001, tolerance));  // up to t = 4
  ASSERT_EQ(cubics.size(), 8U);
  for (std::size_t i = 1; i < cubics.size(); ++i) EXPECT_EQ((cubics[i] + 250) / 501, i);
}

TEST(LongestCubics, every_group_of_channels_counts) {
  const auto line = [](double t) { return t; };
  const auto step = [](double t) { return t < 0.5 ? 0.0 : 1.0; };
  Recording recording = recording_of({line, step}, 1001, 0.001, 0.1);
  EXPECT_EQ(longest_cubics(recording).size(), 2U);
  recording.groups = {{{0}, 0.001}, {{1}, 1}};
  EXPECT_EQ(longest_cubics(recording).size(), 1U);
  recording.groups = {{{0}, 0.001}, {{1}, 0.1}};
  EXPECT_EQ(longest_cubics(recording).size(), 2U);
}

TEST(LongestCubics, of_few_samples) {
  const auto zigzag = [](double t) { return std::fmod(t, 2.0); };
  EXPECT_EQ(longest_cubics(recording_of({zigzag}, 2, 1, 1e-6)).size(), 1U);
  EXPECT_EQ(longest_cubics(recording_of({zigzag}, 4, 1, 1e-6)).size(), 1U);
  EXPECT_EQ(longest_cubics(recording_of({zigzag}, 9, 1, 1e-6)).size(), 3U);
}

TEST(LongestCubics, knots_are_where_one_cubic_ends_and_another_begins) {
  const auto kinks = [](double t) { return t < 1 ? 0 : t < 3 ? (t - 1) * (t - 1) : 4 * t - 8; };
  for (const double tolerance : {1e-2, 1e-6}) {
    const auto knots = knots_of(recording_of({kinks}, 501, 0.01, tolerance), 3);
    ASSERT_EQ(knots.size(), 2U) << tolerance;
    EXPECT_NEAR(static_cast<double>(knots[0]), 100, 1) << tolerance;
    EXPECT_NEAR(static_cast<double>(knots[1]), 300, 1) << tolerance;
  }
}

TEST(LongestCubics, of_long_recordings_are_the_same_on_any_number_of_threads) {
  const auto plateaus = [](double t) { return std::fmod(std::floor(t), 2.0); };
  const Recording recording = recording_of({plateaus}, 160'000, 1.0 / 100, 0.01);
  const auto cubics = longest_cubics(recording);
  ASSERT_EQ(cubics.size(), 1600U);
  for (std::size_t i = 0; i < cubics.size(); ++i) EXPECT_EQ(cubics[i], i * 100);
  EXPECT_EQ(longest_cubics(recording, 3), cubics);
  EXPECT_EQ(knots_of(recording, cubics.size(), 3), knots_of(recording, cubics.size()));
}

}  // namespace
}  // namespace tcb
