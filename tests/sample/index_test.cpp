// Random access to a curve: the segment for any time or length, from either side.
#include "sample/index.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

namespace tcb {
namespace {

/// Straight segments between keys at t = 0, 1, 2, 4 with a hold from 1 to 2, in blocks of one segment.
CurveIndex curve() {
  const std::vector<double> times{0, 1, 2, 4}, positions{0, 3, 3, 7};
  return CurveIndex(
      [=, next = std::size_t{0}]() mutable -> std::optional<SegmentBlock> {
        if (next == 3) return std::nullopt;
        const double h = positions[next + 1] - positions[next];
        SegmentBlock block;
        block.segments = {
            1, {times[next], times[next + 1]}, {spline::cubic<double>(positions[next], positions[next + 1], h, h)}, {}};
        block.lengths = {{h, 0}};
        block.last = ++next == 3;
        return block;
      },
      {});
}

TEST(CurveIndex, finds_the_segment_for_a_time) {
  const CurveIndex whole = curve();
  EXPECT_EQ(whole.size(), 3U);
  for (const bool left : {true, false}) {
    EXPECT_EQ(whole.find_time(0.0, left), 0U);
    EXPECT_EQ(whole.find_time(0.5, left), 0U);
    EXPECT_EQ(whole.find_time(1.0, left), left ? 0U : 1U);
    EXPECT_EQ(whole.find_time(3.0, left), 2U);
    EXPECT_EQ(whole.find_time(4.0, left), 2U);
  }
}

TEST(CurveIndex, finds_the_first_segment_that_reaches_a_length) {
  const CurveIndex whole = curve();
  EXPECT_EQ(whole.length(), 7);
  EXPECT_EQ(whole.find_length(0.0, true), 0U);
  EXPECT_EQ(whole.find_length(2.0, false), 0U);
  EXPECT_EQ(whole.find_length(3.0, true), 0U);
  EXPECT_EQ(whole.find_length(3.0, false), 1U) << "the hold begins here, and with it its first key";
  EXPECT_EQ(whole.find_length(3.5, false), 2U);
  EXPECT_EQ(whole.find_length(7.0, false), 2U);
}

TEST(CurveIndex, neighbouring_rows_on_a_segment_are_located_together) {
  const auto whole = std::make_shared<const CurveIndex>(curve());
  const std::array<double, 5> times{0.25, 0.5, 3, 3.5, 0.75};
  const auto place = [times](std::uint64_t row) { return Time(times.at(row)); };
  const auto rows = std::make_shared<const AnywhereInTime>(place, times.size(), Extrapolation::error, 0.0, 4.0);
  const auto block = look_up(whole, rows, false)();
  ASSERT_TRUE(block);
  ASSERT_EQ(block->parts.size(), 3U);
  EXPECT_EQ(block->parts[0].last, 2U);
  EXPECT_EQ(block->parts[1].segment.number, 2U);
  EXPECT_EQ(block->parts[2].first, 4U);
}

TEST(CurveIndex, segments_have_their_place_on_the_curve) {
  const CurveIndex whole = curve();
  const auto segment = whole.segment(2);
  EXPECT_EQ(segment.start.hi, 2);
  EXPECT_EQ(segment.s_start.hi, 3);
  EXPECT_EQ(segment.s_end.hi, 7);
  EXPECT_TRUE(segment.last);
  EXPECT_EQ(segment.end_key, 3U);
  EXPECT_EQ(segment.cycle[0], 7);
}

}  // namespace
}  // namespace tcb
