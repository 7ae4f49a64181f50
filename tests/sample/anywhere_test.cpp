// Look up: the segments of rows in any order, from either side of a key.
#include "sample/anywhere.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace tcb {
namespace {

/// Straight segments between keys at t = 0, 1, 2, 4 with a hold from 1 to 2.
std::shared_ptr<const ShownCurve> curve() {
  spline::Keys<double> keys{1, {0, 1, 2, 4}, {0, 3, 3, 7}, {}, {.tension = 1}, {}};
  return std::make_shared<const ShownCurve>(*spline::Curve<double>::build(keys), CurveChannels{});
}

TEST(LookUp, neighbouring_rows_on_a_segment_are_located_together) {
  const std::array<double, 5> times{0.25, 0.5, 3, 3.5, 0.75};
  const auto place = [times](std::uint64_t row) { return Time(times.at(row)); };
  const auto rows = std::make_shared<const AnywhereInTime>(place, times.size(), Extrapolations{}, 0.0, 4.0);
  const auto block = look_up(curve(), rows, spline::Side::right)();
  ASSERT_TRUE(block);
  ASSERT_EQ(block->parts.size(), 3U);
  EXPECT_EQ(block->parts[0].last, 2U);
  EXPECT_EQ(block->parts[1].segment.number, 2U);
  EXPECT_EQ(block->parts[2].first, 4U);
}

TEST(LookUp, a_row_at_a_key_is_on_the_side_that_was_asked_for) {
  const auto place = [](std::uint64_t) { return Time(1.0); };
  const auto in_time = std::make_shared<const AnywhereInTime>(place, 1, Extrapolations{}, 0.0, 4.0);
  EXPECT_EQ(look_up(curve(), in_time, spline::Side::left)()->parts[0].segment.number, 0U);
  EXPECT_EQ(look_up(curve(), in_time, spline::Side::right)()->parts[0].segment.number, 1U);
  const auto start_of_hold = [](std::uint64_t) { return Time(3.0); };
  const auto in_length = std::make_shared<const AnywhereInLength>(start_of_hold, 1, 7);
  EXPECT_EQ(look_up(curve(), in_length, spline::Side::left)()->parts[0].segment.number, 0U);
  EXPECT_EQ(look_up(curve(), in_length, spline::Side::right)()->parts[0].segment.number, 1U);
}

TEST(LookUp, keys_replace_times_next_to_them) {
  const auto times = with_keys<Time>({0.5, 1.0 + 1e-12, 1.5}, curve()->curve().times(), 0.5, 2.0, 1e-9);
  EXPECT_EQ(times, (std::vector<Time>{0.5, 1.0, 1.5, 2.0}));
}

}  // namespace
}  // namespace tcb
