// Closed curves: the period from a repeated key or given, and keys that come round.
#include "curve/closed.hpp"
#include "cli/remedies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "error.hpp"

namespace tcb {
namespace {

KeyStore kept(std::vector<spline::Time<double>> times, std::vector<double> positions,
              std::vector<double> tensions = {}) {
  KeyBlock block;
  block.keys.channels = 1;
  block.keys.times = std::move(times);
  block.keys.positions = std::move(positions);
  for (const double tension : tensions) block.keys.tcbs.push_back({tension, 0, 0});
  for (std::size_t i = 0; i < block.keys.size(); ++i) block.lines.push_back(i + 1);
  return KeyStore([block, done = false]() mutable -> std::optional<KeyBlock> {
    return std::exchange(done, true) ? std::nullopt : std::optional(block);
  });
}

CurvePlan plan(const char* period) {
  CurvePlan result;
  result.closed = true;
  if (*period != 0) result.period = parse_rational(period);
  return result;
}

std::string refusal(KeyStore keys, const CurvePlan& curve) {
  try {
    (void)close(keys, curve, true);
  } catch (const Error& error) {
    return error_text(error.in("f"));
  }
  return "nothing";
}

TEST(Close, a_repeated_first_position_is_the_period_and_no_key) {
  auto keys = kept({0.0, 1.0, 2.5}, {3, 4, 3});
  EXPECT_EQ(close(keys, plan(""), true).hi, 2.5);
  EXPECT_EQ(keys.size(), 2U);
}

TEST(Close, a_period_is_added_exactly) {
  auto keys = kept({0.1, 0.15}, {3, 4});
  EXPECT_EQ(close(keys, plan("0.2"), true).hi, 0.3);
}

TEST(Close, keys_without_times_take_one_step_more) {
  auto keys = kept({0.0, 1.0, 2.0}, {3, 4, 8});
  EXPECT_EQ(close(keys, plan(""), false).hi, 3);
  CurvePlan chordal = plan("");
  chordal.parameter = 1;
  EXPECT_EQ(close(keys, chordal, false).hi, 7);
}

TEST(Close, refuses_what_makes_no_closed_curve) {
  EXPECT_EQ(
      refusal(kept({0.0, 1.0}, {3, 4}), plan("")),
      "f: error: nothing says when the closed curve is back at its first key; expected --period, or a last row that "
      "repeats the first position; give one");
  EXPECT_EQ(refusal(kept({0.0, 1.0, 2.0}, {3, 4, 3}, {0, 0, 1}), plan("")),
            "f:3: error: this key closes the curve at the position of line 1, but with another tension, continuity or "
            "bias; expected the same; correct one of the two");
  EXPECT_EQ(
      refusal(kept({0.0, 1.0, 2.0}, {3, 4, 5}), plan("2")),
      "f: error: --period: the curve is closed before its last key, at time 2; expected a longer period; correct it");
  EXPECT_EQ(
      refusal(kept({0.0, 1.0, 2.0}, {3, 4, 3}), plan("5")),
      "f:3: error: this key repeats the position of line 1 and so ends the period, but --period says another; take "
      "one of them out");
  EXPECT_EQ(refusal(kept({0.0, 2.0}, {3, 3}), plan("")),
            "f: error: a closed curve needs two distinct keys at least; add keys");
}

TEST(GoingRound, the_last_key_comes_before_the_first_two_after) {
  const auto keys = kept({0.0, 1.0, 3.0}, {5, 6, 7});
  const LinkedKeys linked = going_round(keys, 4.0);
  EXPECT_EQ(linked.context->times[0].hi, -1);
  EXPECT_EQ(linked.context->positions[0], 7);
  std::vector<double> times, positions;
  while (const auto block = linked.keys()) {
    for (std::size_t i = 0; i < block->size(); ++i) {
      times.push_back(block->times[i].hi);
      positions.push_back(block->positions[i]);
    }
  }
  EXPECT_EQ(times, (std::vector<double>{0, 1, 3, 4, 5}));
  EXPECT_EQ(positions, (std::vector<double>{5, 6, 7, 5, 6}));
}

}  // namespace
}  // namespace tcb
