// Grouping: curves in order of first appearance, breaks inside of them, and sorting that keeps equal times in order.
#include "keys/order.hpp"

#include <gtest/gtest.h>

#include <random>

#include "keys.hpp"

namespace tcb {
namespace {

std::string grouped_keys(const std::string& lines, const Grouping& grouping, std::size_t size = 3) {
  return shown_keys(grouped(keys_of(lines, size), grouping));
}

TEST(Grouped, rows_in_any_order_make_curves_in_order_of_first_appearance) {
  for (std::size_t size = 1; size < 7; ++size) {
    EXPECT_EQ(grouped_keys("0 1 b\n0 2 a\n1 3 b\n5 4 c\n1 5 a\n", {1, false}, size), " 1:1 3:3 / 2:2 5:5 / 4:4");
  }
}

TEST(Grouped, several_columns_identify_a_curve_together) {
  EXPECT_EQ(grouped_keys("0 1 a b\n0 2 ab x\n1 3 a b\n1 4 a c\n", {2, false}), " 1:1 3:3 / 2:2 / 4:4");
}

TEST(Grouped, a_break_in_the_input_breaks_each_curve_that_continues_after_it) {
  EXPECT_EQ(grouped_keys("0 1 a\n0 2 b\n/\n1 3 a\n2 4 a\n/\n3 5 b\n", {1, false}), " 1:1 / 4:3 5:4 / 2:2 / 7:5");
}

TEST(Grouped, a_gap_belongs_to_the_curve_of_its_row) {
  EXPECT_EQ(grouped_keys("0 1 a\n0 2 b\ngap 1 a\n1 4 b\n2 5 a\n", {1, false}), " 1:1 gap 3:nan 5:5 / 2:2 4:4");
}

TEST(Grouped, sorting_is_stable_and_does_not_cross_breaks) {
  EXPECT_EQ(grouped_keys("2 1\n0 2\n1 3\n0 4\n", {0, true}), " 2:2 4:4 3:3 1:1");
  EXPECT_EQ(grouped_keys("2 1\n0 2\n/\n1 3\n0 4\n", {0, true}), " 2:2 1:1 / 5:4 4:3");
  EXPECT_EQ(grouped_keys("2 1 b\n1 2 a\n0 3 b\n0 4 a\n", {1, true}), " 3:3 1:1 / 4:4 2:2");
}

TEST(Grouped, a_gap_is_sorted_like_a_key_and_skipped_without_a_time) {
  EXPECT_EQ(grouped_keys("2 1\ngap 1\n0 2\ngap ?\n", {0, true}), " 3:2 gap 2:nan 1:1");
}

TEST(Grouped, many_curves_keep_all_their_keys) {
  std::mt19937_64 random(7);
  std::string lines;
  std::vector<std::string> expected(5000);
  for (int i = 0; i < 20000; ++i) {
    const auto curve = static_cast<std::size_t>(random() % expected.size());
    lines += fmt::format("{} {} curve{}\n", i, i, curve);
    expected[curve] += fmt::format(" {}:{}", i + 1, i);
  }
  std::string all = grouped_keys(lines, {1, false}, 4000);
  std::erase(all, '/');
  for (const std::string& curve : expected) {
    ASSERT_NE((" " + all + " ").find(curve + " "), std::string::npos) << curve;
  }
}

}  // namespace
}  // namespace tcb
