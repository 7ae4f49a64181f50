// Keys on their way to measured pieces: what is refused, times made from distances, and lengths.
#include "curve/segment_blocks.hpp"
#include "cli/remedies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "error.hpp"
#include "keys/key_store.hpp"

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

template <class F>
std::string refusal(F f) {
  try {
    f();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::data);
    return error_text(error.in("f"));
  }
  return "nothing";
}

void drain(const Source<KeyBlock>& source) {
  while (source()) {
  }
}

TEST(Checked, wants_as_many_keys_as_the_request_needs) {
  EXPECT_EQ(refusal([] {
              drain(checked(blocks({{0, 1}}, 1), 2));
            }),
            "f:1: error: only 1 key; a curve needs two at least; add keys");
  EXPECT_EQ(refusal([] { drain(checked(blocks({{0, 1}}, 1), 1)); }), "nothing");
}

TEST(Checked, wants_ease_from_0_to_1) {
  const auto eased = [](double in) {
    return [in, done = false]() mutable -> std::optional<KeyBlock> {
      if (std::exchange(done, true)) return std::nullopt;
      KeyBlock block{{1, {0.0, 1.0}, {0, 1}, {}, {}, {{0, 0}, {in, 0}}}, {1, 2}};
      return block;
    };
  };
  EXPECT_EQ(refusal([&] { drain(checked(eased(1), 2)); }), "nothing");
  EXPECT_EQ(refusal([&] { drain(checked(eased(1.5), 2)); }),
            "f:2: error: ease_in is 1.5; expected 0 to 1; correct it, or give --no-ease");
}

TEST(Parameterized, makes_times_of_distances) {
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

TEST(Parameterized, refuses_neighbours_without_a_distance) {
  EXPECT_EQ(
      refusal([] {
        drain(parameterized(blocks({{0, 1}, {0, 1}}, 1, false), 1, {}));
      }),
      "f:2: error: the position repeats that in line 1; distances make the times, and here there is none; take one "
      "of the rows out, or give --parameter uniform");
}

TEST(Stretches, measured_at_once_or_with_known_lengths_are_the_same) {
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
