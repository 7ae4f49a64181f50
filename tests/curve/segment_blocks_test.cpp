// Segment blocks: lengths of segments.
#include "curve/segment_blocks.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "keys/key_store.hpp"

namespace tcb {
namespace {

/// Keys of one channel in blocks of `size`; line i + 1 holds key i.
Source<KeyBlock> blocks(const std::vector<std::array<double, 2>>& table, std::size_t size) {
  return [table, size, next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next >= table.size()) return std::nullopt;
    KeyBlock block;
    block.keys.channels = 1;
    for (const std::size_t end = std::min(next + size, table.size()); next < end; ++next) {
      block.keys.times.emplace_back(table[next][0]);
      block.keys.positions.push_back(table[next][1]);
      block.lines.push_back(next + 1);
    }
    return block;
  };
}

TEST(SegmentBlocks, measured_at_once_or_with_known_lengths_are_the_same) {
  const KeyStore kept(blocks({{0, 0}, {1, 3}, {2, -1}, {4, 5}}, 2));
  const Lengths lengths = all_lengths(segment_blocks({kept.source(), {}}, {}, true));
  ASSERT_EQ(lengths.size(), 3U);
  const auto again = with_lengths(segment_blocks({kept.source(), {}}, {}, false), lengths);
  std::vector<double> found;
  while (const auto stretch = again()) {
    for (const auto& length : stretch->lengths) found.push_back(length.value);
  }
  EXPECT_EQ(found, (std::vector<double>{lengths[0].value, lengths[1].value, lengths[2].value}));
  EXPECT_GE(total_length(lengths), 3 + 4 + 6);
}

}  // namespace
}  // namespace tcb
