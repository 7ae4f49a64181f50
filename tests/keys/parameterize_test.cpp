// Parameterize: times from distances.
#include "keys/prepare.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "keys.hpp"

namespace tcb {
namespace {

/// Keys of one channel with these positions, a key per block, without times; line i + 1 holds key i.
Source<KeyBlock> blocks_at(const std::vector<double>& positions) {
  return [positions, next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next >= positions.size()) return std::nullopt;
    KeyBlock block;
    block.keys.channels = 1;
    block.keys.positions = {positions[next]};
    block.text_positions = {{next + 1}};
    ++next;
    return block;
  };
}

void read_all(const Source<KeyBlock>& source) {
  while (source()) {
  }
}

TEST(Parameterized, makes_times_from_distances) {
  const std::vector<std::pair<double, std::vector<double>>> expected{
      {0, {0, 1, 2, 3}}, {1, {0, 4, 5, 14}}, {0.5, {0, 2, 3, 6}}};
  for (const auto& [exponent, times] : expected) {
    const auto keys = parameterized(blocks_at({0, 4, 3, 12}), exponent, {});
    std::vector<double> found;
    while (const auto block = keys()) {
      for (const auto& time : block->keys.times) found.push_back(time.hi);
    }
    EXPECT_EQ(found, times) << exponent;
  }
}

TEST(Parameterized, refuses_neighbours_at_the_same_position) {
  EXPECT_EQ(
      refusal_of([] {
        read_all(parameterized(blocks_at({1, 1}), 1, {}));
      }),
      "f:2: error: the position repeats the one on line 1, so the distance from which the time is made is 0; expected "
      "different positions; remove one of the rows, or give --parameter uniform");
}

TEST(Parameterized, refuses_a_step_that_rounding_loses) {
  EXPECT_EQ(refusal_of([] {
              read_all(parameterized(blocks_at({0, 1e300, 0, 1}), 1, {}));
            }),
            "f:4: error: the distance gives a step of 1, which is too small to change the time 2e+300; expected "
            "times that doubles can distinguish; give a smaller exponent to --parameter");
}

}  // namespace
}  // namespace tcb
