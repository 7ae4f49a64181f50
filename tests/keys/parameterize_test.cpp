// Parameterize and check: times from distances, the ease and the number of keys.
#include "keys/parameterize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "keys.hpp"

namespace tcb {
namespace {

/// Keys of one channel in blocks of `size`; line i + 1 holds key i. Without times where `timed` is not set.
Source<KeyBlock> blocks(const std::vector<std::array<double, 2>>& table, std::size_t size, bool timed = true) {
  return [table, size, timed, next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next >= table.size()) return std::nullopt;
    KeyBlock block;
    block.keys.channels = 1;
    for (const std::size_t end = std::min(next + size, table.size()); next < end; ++next) {
      if (timed) block.keys.times.emplace_back(table[next][0]);
      block.keys.positions.push_back(table[next][1]);
      block.lines.push_back(next + 1);
    }
    return block;
  };
}

void drain(const Source<KeyBlock>& source) {
  while (source()) {
  }
}

TEST(Checked, requires_as_many_keys_as_the_request_needs) {
  EXPECT_EQ(refusal_of([] {
              drain(checked(blocks({{0, 1}}, 1), 2));
            }),
            "f:1: error: there is only one key; a curve needs at least two; add keys");
  EXPECT_EQ(refusal_of([] { drain(checked(blocks({{0, 1}}, 1), 1)); }), "nothing");
}

TEST(Checked, requires_ease_from_0_to_1) {
  const auto eased = [](double in) {
    return [in, done = false]() mutable -> std::optional<KeyBlock> {
      if (std::exchange(done, true)) return std::nullopt;
      KeyBlock block{{1, {0.0, 1.0}, {0, 1}, {}, {}, {{0, 0}, {in, 0}}}, {1, 2}};
      return block;
    };
  };
  EXPECT_EQ(refusal_of([&] { drain(checked(eased(1), 2)); }), "nothing");
  EXPECT_EQ(refusal_of([&] { drain(checked(eased(1.5), 2)); }),
            "f:2: error: ease_in is 1.5; expected a number from 0 to 1; correct it, or give --no-ease");
}

TEST(Parameterized, makes_times_from_distances) {
  const std::vector<std::array<double, 2>> table{{0, 0}, {0, 4}, {0, 3}, {0, 12}};
  const std::vector<std::pair<double, std::vector<double>>> expected{
      {0, {0, 1, 2, 3}}, {1, {0, 4, 5, 14}}, {0.5, {0, 2, 3, 6}}};
  for (const auto& [exponent, times] : expected) {
    const auto keys = parameterized(blocks(table, 3, false), exponent, {});
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
        drain(parameterized(blocks({{0, 1}, {0, 1}}, 1, false), 1, {}));
      }),
      "f:2: error: the position repeats the one on line 1, so the distance from which the time is made is 0; expected "
      "different positions; remove one of the rows, or give --parameter uniform");
}

TEST(Parameterized, refuses_a_step_that_rounding_loses) {
  EXPECT_EQ(refusal_of([] {
              drain(parameterized(blocks({{0, 0}, {0, 1e300}, {0, 0}, {0, 1}}, 1, false), 1, {}));
            }),
            "f:4: error: the distance makes a step of 1, which is lost when it is added to the time 2e+300; expected "
            "times that doubles can distinguish; give a smaller exponent to --parameter");
}

TEST(WithoutEase, drops_the_ease_of_all_keys) {
  KeyBlock block{{1, {0.0, 1.0}, {0, 1}, {}, {}, {{0, 0}, {1, 0}}}, {1, 2}};
  const auto keys = without_ease(
      [&block, done = false]() mutable { return std::exchange(done, true) ? std::nullopt : std::optional(block); });
  EXPECT_TRUE(keys()->keys.eases.empty());
}

}  // namespace
}  // namespace tcb
