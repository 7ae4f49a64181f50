// Key checks: the ease and the number of keys.
#include "keys/prepare.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "keys.hpp"

namespace tcb {
namespace {

Source<KeyBlock> once(const KeyBlock& block) {
  return [block, done = false]() mutable { return std::exchange(done, true) ? std::nullopt : std::optional(block); };
}

void drain(const Source<KeyBlock>& source) {
  while (source()) {
  }
}

TEST(Checked, requires_as_many_keys_as_the_request_needs) {
  KeyBlock one;
  one.keys.channels = 1;
  one.keys.times = {0.0};
  one.keys.positions = {1};
  one.text_positions = {{1}};
  EXPECT_EQ(refusal_of([&] { drain(checked(once(one), 2)); }),
            "f:1: error: there is only one key; a curve needs at least two; add keys");
  EXPECT_EQ(refusal_of([&] { drain(checked(once(one), 1)); }), "nothing");
}

TEST(Checked, requires_ease_from_0_to_1) {
  const auto eased = [](double in) { return once({{1, {0.0, 1.0}, {0, 1}, {}, {}, {{0, 0}, {in, 0}}}, {{1, 2}}}); };
  EXPECT_EQ(refusal_of([&] { drain(checked(eased(1), 2)); }), "nothing");
  EXPECT_EQ(refusal_of([&] { drain(checked(eased(1.5), 2)); }),
            "f:2: error: ease_in is 1.5; expected a number from 0 to 1; correct it, or give --no-ease");
}

TEST(WithoutEase, drops_the_ease_of_all_keys) {
  const KeyBlock block{{1, {0.0, 1.0}, {0, 1}, {}, {}, {{0, 0}, {1, 0}}}, {{1, 2}}};
  EXPECT_TRUE(without_ease(once(block))()->keys.eases.empty());
}

}  // namespace
}  // namespace tcb
