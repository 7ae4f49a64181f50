// Key checks: the ease of keys.
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

TEST(Checked, requires_ease_from_0_to_1) {
  const auto eased = [](double in) { return once({{1, {0.0, 1.0}, {0, 1}, {}, {}, {{0, 0}, {in, 0}}}, {{1, 2}}}); };
  EXPECT_EQ(refusal_of([&] { drain(checked(eased(1), 2)); }), "nothing");
  EXPECT_EQ(refusal_of([&] { drain(checked(eased(1.5), 2)); }),
            "f:2: error: ease_in is 1.5; expected a number from 0 to 1; correct it, or give --no-ease");
}

}  // namespace
}  // namespace tcb
