// Key store: keys come back unchanged, any number of times.
#include "keys/key_store.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "keys.hpp"

namespace tcb {
namespace {

TEST(KeyStore, keys_are_read_more_than_once_and_the_last_one_can_be_dropped) {
  KeyStore kept(keys_of("0 1\n1 2\n2 3", 1));
  EXPECT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept.key(2).positions[0], 3);
  EXPECT_EQ(kept.first_line(), 1U);
  EXPECT_EQ(kept.last_line(), 3U);
  for (int round = 0; round < 2; ++round) {
    const auto source = kept.source();
    std::size_t count = 0;
    while (const auto block = source()) count += block->size();
    EXPECT_EQ(count, 3U);
  }
  kept.drop_last();
  EXPECT_EQ(kept.size(), 2U);
}

/// `per_key`: entries of tension, continuity and bias.
void expect_keys_back(std::size_t per_key) {
  Keys all;
  all.channels = 2;
  const auto make = [&all, per_key](std::size_t size, double low_part) {
    KeyBlock block;
    block.keys.channels = 2;
    block.keys.given = {true, true};
    for (std::size_t i = 0; i < size; ++i) {
      const auto number = static_cast<double>(all.size() + i);
      block.keys.times.push_back(spline::DoubleDouble{0x1p60 + 1024 * number, low_part * number});
      block.keys.positions.insert(block.keys.positions.end(), {number / 3, -number});
      block.keys.tcbs.resize(block.keys.tcbs.size() + per_key, {0.25, number, 0.5});
      block.keys.eases.push_back({0, 1 / (1 + number)});
      block.keys.velocities.insert(block.keys.velocities.end(), {{number, 1}, {2, -number}});
      block.text_positions.lines.push_back(all.size() + i + 1);
    }
    spline::append(all, block.keys, 0, size);
    return block;
  };
  std::vector<KeyBlock> blocks{make(700, 0), make(1, 0), make(0, 0), make(1500, 1), make(2, 0)};
  KeyStore kept([blocks, next = std::size_t{0}]() mutable {
    return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt;
  });
  for (const std::size_t dropped : {0U, 1U}) {
    if (dropped > 0) kept.drop_last();
    Keys found;
    const auto source = kept.source();
    while (const auto part = source()) spline::append(found, *part, 0, part->size());
    Keys expected;
    spline::append(expected, all, 0, all.size() - dropped);
    ASSERT_EQ(kept.size(), expected.size());
    EXPECT_EQ(found.times, expected.times);
    EXPECT_EQ(found.positions, expected.positions);
    EXPECT_EQ(found.tcbs, expected.tcbs);
    EXPECT_EQ(found.velocities, expected.velocities);
    EXPECT_EQ(found.given, expected.given);
    ASSERT_EQ(found.eases.size(), expected.eases.size());
    EXPECT_EQ(found.eases.back().out, expected.eases.back().out);
    EXPECT_EQ(kept.key(900).times[0], expected.times[900]);
    EXPECT_EQ(kept.key(900).positions[1], -900);
    EXPECT_EQ(kept.key(900).tcb(0, per_key - 1).continuity, 900);
  }
}

TEST(KeyStore, a_repeated_key_gives_the_first_its_incoming_velocities) {
  KeyStore keys([block = std::optional([] {
                   KeyBlock one = *keys_of("0 5\n1 6\n2 5\n", 3)();
                   one.keys.velocities = {{0, 1}, {2, 3}, {4, 5}};
                   one.keys.given = {true};
                   return one;
                 }())]() mutable { return std::exchange(block, std::nullopt); });
  const Keys last = keys.key(2);
  keys.drop_last();
  keys.join_seam(last);
  EXPECT_EQ(keys.all().velocities, (std::vector<spline::Velocity<double>>{{4, 1}, {2, 3}}));
}

TEST(KeyStore, keys_are_read_back_unchanged) {
  expect_keys_back(1);
  expect_keys_back(2);
}

}  // namespace
}  // namespace tcb
