// Rotations among keys: continuous signs, also of decimals, and what is refused.
#include "keys/rotations.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "error.hpp"
#include "keys/rotation_keys.hpp"

namespace tcb {
namespace {

using testing::MatchesRegex;

KeyBlock checked(const KeyBlock& block, bool normalize = false) {
  const RotationSchema rotation{{{{1, 2, 3, 4}}}, {{}, false, {"qx", "qy", "qz", "qw"}, {}, normalize}};
  return *with_clear_turns(source_of(block), {{rotation}})();
}

/// The line and the message of the error of keys with these quaternions.
std::string refused_rotations(const std::vector<Numbers>& quaternions, bool normalize = false) {
  try {
    (void)checked(block_of(quaternions), normalize);
  } catch (const Error& error) {
    return std::to_string(error.position().line) + ": " + error.message();
  }
  ADD_FAILURE() << "no error";
  return "";
}

TEST(Rotations, signs_are_continuous_and_the_first_is_kept) {
  const KeyBlock block = checked(block_of({{0, 0, 0, -1}, {0, 0, 0.6, 0.8}, {0, 0, -0.8, -0.6}}));
  EXPECT_EQ(block.keys.positions, (Numbers{7, 0, 0, 0, -1, 7, 0, 0, -0.6, -0.8, 7, 0, 0, -0.8, -0.6}));
}

TEST(Rotations, a_key_without_numbers_has_no_rotation) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const KeyBlock block = checked(block_of({{0, 0, 0, 1}, {none, none, none, none}, {0, 0, -0.6, -0.8}}));
  EXPECT_TRUE(std::isnan(block.keys.positions[6]));
  EXPECT_EQ(block.keys.positions[14], 0.8);
  EXPECT_THAT(refused_rotations({{0, 0, 0, 1}, {0, none, 0, 1}}), MatchesRegex("3: .* lacks a number;.*"));
}

TEST(Rotations, decimals_change_their_signs_too) {
  KeyBlock block = block_of({{0, 0, 0, 1}, {0, 0, 0.6, -0.8}});
  for (const char* const text : {"0", "", "", "", "", "", "7", "0", "0", "0", "1"}) block.decimals.add(text);
  for (const char* const text : {"1", "", "", "", "", "", "7", "0", "+0", "0.6", "-0.8"}) block.decimals.add(text);
  ASSERT_EQ(std::size_t{NumberOfKey::position} + 5, block.decimals.size() / 2);
  const KeyBlock result = checked(block);
  const std::size_t first = result.decimals.size() / 2 + NumberOfKey::position;
  EXPECT_EQ(result.decimals[first], "7");
  EXPECT_EQ(result.decimals[first + 1], "-0");
  EXPECT_EQ(result.decimals[first + 2], "-0");
  EXPECT_EQ(result.decimals[first + 3], "-0.6");
  EXPECT_EQ(result.decimals[first + 4], "0.8");
}

TEST(Rotations, what_is_no_rotation_is_refused) {
  EXPECT_THAT(refused_rotations({{0, 0, 0, 1}, {0, 0, 0, 1.0011}}), MatchesRegex("3: .* has the norm.*"));
  EXPECT_THAT(refused_rotations({{0, 0, 0, 1e200}}), MatchesRegex("2: .* has the norm.*"));
  EXPECT_THAT(refused_rotations({{0, 0, 0, 0}}, true), MatchesRegex("2: .* is zero, so it is not a rotation.*"));
  EXPECT_THAT(refused_rotations({{0, 0, 0, 1}, {0, 0, 1, 0}}),
              MatchesRegex("3: .* is exactly 180 degrees from the rotation on line 2.*"));
  EXPECT_EQ(checked(block_of({{0, 0, 0, 0.9995}, {0, 0, 0, 1.0005}})).size(), 2U);
  EXPECT_EQ(checked(block_of({{0, 0, 0, 3}, {0, 0, 0, -1e200}}), true).keys.positions[9], 1e200);
}

}  // namespace
}  // namespace tcb
