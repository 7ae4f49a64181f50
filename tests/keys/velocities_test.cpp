// Velocities: which of those that are given may be missing.
#include "keys/prepare.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "keys.hpp"

namespace tcb {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The error of keys with these positions and velocities in one channel, in blocks of two.
std::string error_with(const std::vector<double>& positions, const std::vector<spline::Velocity<double>>& velocities,
                       bool equal_speed = false) {
  const auto source = [&, key = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (key == positions.size()) return std::nullopt;
    KeyBlock block;
    block.keys.channels = 1;
    block.keys.given = {true};
    for (const std::size_t end = std::min(key + 2, positions.size()); key < end; ++key) {
      block.keys.times.emplace_back(static_cast<double>(key));
      block.keys.positions.push_back(positions[key]);
      block.keys.velocities.push_back(velocities[key]);
      block.text_positions.lines.push_back(key + 1);
    }
    return block;
  };
  const auto checked = with_complete_velocities(source, {"x"}, equal_speed);
  try {
    while (checked()) {
    }
  } catch (const Error& error) {
    return error_text(error.in("f"));
  }
  return "";
}

TEST(Velocities, are_needed_between_keys_only) {
  EXPECT_EQ(error_with({1, 2, 3}, {{none, 1}, {2, 3}, {4, none}}), "");
  EXPECT_EQ(error_with({1}, {{none, none}}), "");
  const std::string incoming =
      ": error: the incoming velocity of channel \"x\" is missing; expected a number at every key but the first; fill "
      "it "
      "in, or remove the row";
  EXPECT_EQ(error_with({1, 2, 3}, {{none, 1}, {none, 3}, {4, none}}), "f:2" + incoming);
  EXPECT_EQ(error_with({1, 2, 3}, {{none, 1}, {2, 3}, {none, none}}), "f:3" + incoming);
  const std::string outgoing =
      ": error: the outgoing velocity of channel \"x\" is missing; expected a number at every key but the last; fill "
      "it "
      "in, or remove the row";
  EXPECT_EQ(error_with({1, 2, 3}, {{none, 1}, {2, none}, {4, none}}), "f:2" + outgoing);
}

TEST(Velocities, are_not_needed_where_a_channel_has_no_position) {
  EXPECT_EQ(error_with({none, 2, none, 4, none}, {{none, none}, {none, 1}, {none, none}, {1, none}, {1, 1}}), "");
}

TEST(Velocities, exclude_equal_speed) {
  EXPECT_EQ(error_with({1, 2}, {{1, 1}, {1, 1}}, true),
            "f: error: the keys have velocities, which --equal-speed would change; expected one of the two; remove "
            "--equal-speed");
}

}  // namespace
}  // namespace tcb
