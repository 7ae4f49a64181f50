// Errors of curves: faults of the library with the names of channels and the lines of keys.
#include "sample/build.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "io/terminal.hpp"
#include "tcb/spline/build_error.hpp"

namespace tcb {
namespace {

/// The words for a fault of two keys, in lines 4 and 7, with channels x and y.
std::string words(const spline::BuildError& error) {
  KeyBlock block;
  block.keys = {2, {0.5, 2.0}, {1, 2, 3, 4}, {}, {}, {}};
  block.text_positions.lines = {4, 7};
  const KeyStore keys([block, done = false]() mutable -> std::optional<KeyBlock> {
    return std::exchange(done, true) ? std::nullopt : std::optional(block);
  });
  return error_text(curve_error(error, keys, {"x", "y"}).in("f"));
}

TEST(CurveErrors, name_channels_and_lines) {
  using enum spline::BuildErrorCode;
  EXPECT_EQ(words({.code = channel_without_positions, .channel = 1}),
            "f: error: no key has a number in channel \"y\"; expected at least one; fill one in, or leave the column "
            "out with --columns");
  EXPECT_EQ(words({.code = period_too_short, .key = 1}),
            "f: error: the period ends before the last key, at time 2; give a longer period");
}

}  // namespace
}  // namespace tcb
