// Key blocks: parts of them with everything that belongs to their keys, and the positions of keys.
#include "schema/key_block.hpp"
#include "schema/curve_settings.hpp"

#include <gtest/gtest.h>

#include "keys.hpp"

namespace tcb {
namespace {

/// Three keys with an entry in every member that has one per key.
KeyBlock three_keys() {
  KeyBlock block = *keys_of("0 5 a b\n1 6 c d\n2 7 e f\n", 3)();
  block.keys.tcbs = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  block.keys.eases = {{0, 1}, {0, 2}, {0, 3}};
  block.text_positions.columns = {1, 2, 3};
  block.text_positions.numbers = {10, 11, 12};
  for (const char* decimal : {"0.0", "1.0", "2.0"}) block.decimals.add(decimal);
  return block;
}

TEST(KeyBlock, selected_keys_keep_all_that_belongs_to_them) {
  const std::vector<std::size_t> two{0, 2};
  const KeyBlock part = three_keys().selected(two);
  EXPECT_EQ(part.keys.times[1].hi, 2);
  EXPECT_EQ(part.keys.positions, (std::vector<double>{5, 7}));
  EXPECT_EQ(part.keys.tcbs[1].tension, 3);
  EXPECT_EQ(part.keys.eases[1].out, 3);
  EXPECT_EQ(part.text_positions.lines, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(part.text_positions.columns, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(part.text_positions.numbers, (std::vector<std::uint64_t>{10, 12}));
  ASSERT_EQ(part.texts.size(), 4U);
  EXPECT_EQ(part.text(1, 0), "e");
  ASSERT_EQ(part.decimals.size(), 2U);
  EXPECT_EQ(part.decimals[1], "2.0");
}

TEST(KeyBlock, tension_of_channels_belongs_to_their_keys) {
  KeyBlock block = *keys_of("0 5\n1 7\n2 9\n", 3)();
  block.keys.channels = 2;
  block.keys.positions = {5, 6, 7, 8, 9, 10};
  for (const double tension : {1, 2, 3, 4, 5, 6}) block.keys.tcbs.push_back({tension, 0, 0});
  for (const double velocity : {1, 2, 3, 4, 5, 6}) block.keys.velocities.push_back({velocity, -velocity});
  block.keys.given = {true, false};
  const KeyBlock part = block.range(1, 3);
  ASSERT_EQ(part.keys.tcbs.size(), 4U);
  ASSERT_EQ(part.keys.velocities.size(), 4U);
  EXPECT_EQ(part.keys.velocities[2].out, -5);
  EXPECT_EQ(part.keys.given, block.keys.given);
  EXPECT_EQ(part.keys.tcb(1, 0).tension, 5);
  EXPECT_FALSE(part.has_shape_of(three_keys()));
  EXPECT_TRUE(part.has_shape_of(block) && part.has_shape_of({}) && KeyBlock().has_shape_of(part));
  const KeyBlock last = block.cut(block.size() - 1);
  ASSERT_EQ(last.keys.tcbs.size(), 2U);
  EXPECT_EQ(last.keys.tcb(0, 1).tension, 6);
  EXPECT_EQ(block.keys.tcbs.size(), 4U);
  EXPECT_EQ(last.keys.velocities[1].in, 6);
  EXPECT_EQ(block.keys.velocities.size(), 4U);
}

TEST(KeyBlock, the_last_key_splits_off_with_all_that_belongs_to_it) {
  KeyBlock block = three_keys();
  block.breaks.before = {1, 2};
  block.curve_info = std::make_shared<const CurveInfo>();
  const KeyBlock last = block.cut(block.size() - 1);
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last.keys.positions, std::vector<double>{7});
  EXPECT_EQ(last.keys.tcbs[0].tension, 3);
  EXPECT_EQ(last.keys.eases[0].out, 3);
  EXPECT_EQ(last.text_positions.lines, std::vector<std::uint64_t>{3});
  EXPECT_EQ(last.text_positions.columns, std::vector<std::uint32_t>{3});
  EXPECT_EQ(last.text_positions.numbers, std::vector<std::uint64_t>{12});
  EXPECT_EQ(last.text(0, 1), "f");
  EXPECT_EQ(last.decimals[0], "2.0");
  EXPECT_TRUE(last.begins_curve(0));
  EXPECT_EQ(last.curve_info, nullptr);

  ASSERT_EQ(block.size(), 2U);
  EXPECT_EQ(block.keys.size(), 2U);
  EXPECT_EQ(block.keys.positions, (std::vector<double>{5, 6}));
  EXPECT_EQ(block.keys.tcbs.size(), 2U);
  EXPECT_EQ(block.keys.eases.size(), 2U);
  EXPECT_EQ(block.text_positions.columns.size(), 2U);
  EXPECT_EQ(block.text_positions.numbers.size(), 2U);
  EXPECT_EQ(block.texts.size(), 4U);
  EXPECT_EQ(block.decimals.size(), 2U);
  EXPECT_EQ(block.breaks.before, std::vector<std::size_t>{1});
  EXPECT_NE(block.curve_info, nullptr);
}

TEST(KeyBlock, an_only_key_splits_off_with_the_curve_that_it_begins) {
  KeyBlock block = *keys_of("0 5 a\n", 1)();
  block.curve_info = std::make_shared<const CurveInfo>();
  EXPECT_NE(block.cut(block.size() - 1).curve_info, nullptr);
  EXPECT_TRUE(block.empty());
  EXPECT_EQ(block.curve_info, nullptr);
}

TEST(KeyBlock, the_members_of_a_block_move_to_another_block) {
  KeyBlock from = three_keys(), to;
  from.keys.common_tcb = {1, 2, 3};
  from.breaks.at_end = from.faults.unreadable = true;
  from.faults.skipped = 4;
  from.faults.errors.emplace_back(Exit::data, "a fault");
  from.curve_info = std::make_shared<const CurveInfo>();
  to.take_block_data(from);
  EXPECT_TRUE(to.empty());
  EXPECT_EQ(to.keys.channels, 1U);
  EXPECT_EQ(to.keys.common_tcb.bias, 3);
  EXPECT_TRUE(to.breaks.at_end && to.faults.unreadable && to.curve_info != nullptr);
  EXPECT_EQ(to.faults.skipped, 4U);
  EXPECT_EQ(to.faults.errors.size(), 1U);
}

TEST(KeyBlock, a_key_has_a_position_in_text_and_in_its_list) {
  KeyBlock block = *keys_of("0 5\n1 6\n", 2)();
  EXPECT_EQ(block.text_position(1).line, 2U);
  EXPECT_EQ(block.text_position(1).column, 0U);
  EXPECT_EQ(block.list_position(1), "");
  block.text_positions.columns = {3, 8};
  block.text_positions.path = "keys";
  block.text_positions.numbers = {3, 4};
  EXPECT_EQ(block.text_position(1).column, 8U);
  EXPECT_EQ(block.list_position(1), "keys[4]");
}

}  // namespace
}  // namespace tcb
