// Key lists: replacements anywhere, and samples with equal masses between them.
#include "fit/key_list.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fit/recordings.hpp"

namespace tcb {
namespace {

Recording ten_samples() {
  return recording_of({[](double t) { return t; }}, 10, 1, 0.1);
}

std::vector<std::size_t> samples_in(KeyList list) {
  std::vector<std::size_t> samples;
  for (const FitKey& key : std::move(list).take()) samples.push_back(key.sample);
  return samples;
}

TEST(KeyList, keys_are_replaced_before_and_after_each_other) {
  const Recording recording = ten_samples();
  KeyList list(keys_at({0, 2, 4, 6, 9}, recording));
  list.replace(3, 4, keys_at({7}, recording));
  EXPECT_EQ(list.size(), 5U);
  EXPECT_EQ(list[4].sample, 9U);
  list.replace(0, 3, keys_at({0, 3}, recording));
  EXPECT_EQ(list.at_sample(7), 2U);
  EXPECT_EQ(list.at_sample(4), 2U);
  EXPECT_EQ(list.range(1, 3)[0].sample, 3U);
  EXPECT_EQ(samples_in(list), (std::vector<std::size_t>{0, 3, 7, 9}));
}

TEST(KeyList, samples_divide_masses) {
  const std::array<std::size_t, 3> marks{0, 6, 9};
  EXPECT_EQ(divided(ten_samples(), marks, std::array{2.0, 1.0}, 3), (std::vector<std::size_t>{0, 3, 6, 9}));
  EXPECT_EQ(divided(ten_samples(), marks, std::array{0.0, 1.0}, 3), (std::vector<std::size_t>{0, 7, 8, 9}));
}

}  // namespace
}  // namespace tcb
