// Blocks: parts of them with everything that belongs to the keys, and how keys are named.
#include "input/blocks.hpp"

#include <gtest/gtest.h>

#include "keys.hpp"

namespace tcb {
namespace {

TEST(Blocks, a_part_has_all_that_belongs_to_its_keys) {
  KeyBlock block = *keys_of("0 5 a b\n1 6 c d\n2 7 e f\n", 3)();
  block.keys.tcbs = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  block.keys.eases = {{0, 1}, {0, 2}, {0, 3}};
  block.numbers = {10, 11, 12};
  const std::vector<std::size_t> two{0, 2};
  const KeyBlock part = chosen(block, two);
  EXPECT_EQ(part.keys.times[1].hi, 2);
  EXPECT_EQ(part.keys.positions, (std::vector<double>{5, 7}));
  EXPECT_EQ(part.keys.tcbs[1].tension, 3);
  EXPECT_EQ(part.keys.eases[1].out, 3);
  EXPECT_EQ(part.lines, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(part.numbers, (std::vector<std::uint64_t>{10, 12}));
  ASSERT_EQ(part.texts.size(), 4U);
  EXPECT_EQ(part.texts[2], "e");
}

TEST(Blocks, a_key_is_named_by_its_list_or_by_its_line) {
  KeyBlock block = *keys_of("0 5\n1 6\n", 2)();
  EXPECT_EQ(name_of_key(block, 1), "line 2");
  block.path = "keys";
  block.numbers = {3, 4};
  EXPECT_EQ(name_of_key(block, 1), "keys[4]");
}

}  // namespace
}  // namespace tcb
