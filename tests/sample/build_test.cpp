// Building curves: segments with lengths, open, closed and sparse; what closes a curve; kept curves.
#include "sample/build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "keys/key_store.hpp"
#include "sample/kept_curve_of.hpp"

namespace tcb {
namespace {

/// Keys of one channel in blocks of `size`; line i + 1 holds key i.
Source<KeyBlock> blocks(const std::vector<std::array<double, 2>>& table, std::size_t size) {
  return [table, size, next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next >= table.size()) return std::nullopt;
    KeyBlock block;
    block.keys.channels = 1;
    for (const std::size_t end = std::min(next + size, table.size()); next < end; ++next) {
      block.keys.times.emplace_back(table[next][0]);
      block.keys.positions.push_back(table[next][1]);
      block.text_positions.lines.push_back(next + 1);
    }
    return block;
  };
}

TEST(SegmentBlocks, measured_at_once_or_with_known_lengths_are_the_same) {
  const StreamedCurve curve{KeyStore(blocks({{0, 0}, {1, 3}, {2, -1}, {4, 5}}, 2)), {}, {}, {}};
  const auto lengths_of = [](const Source<SegmentBlock>& segments) {
    std::vector<double> lengths;
    while (const auto block = segments()) {
      for (const auto& length : block->lengths) lengths.push_back(length.value);
    }
    return lengths;
  };
  const auto [segments, length, last_moving] = curve.measured();
  const std::vector<double> lengths = lengths_of(segments);
  ASSERT_EQ(lengths.size(), 3U);
  EXPECT_EQ(lengths, lengths_of(curve.segments(true)));
  EXPECT_GE(length, 3 + 4 + 6);
  EXPECT_EQ(last_moving, 2U);
}

KeyStore kept(std::vector<spline::Time<double>> times, std::vector<double> positions) {
  KeyBlock block;
  block.keys.channels = 1;
  block.keys.times = std::move(times);
  block.keys.positions = std::move(positions);
  for (std::size_t i = 0; i < block.keys.size(); ++i) block.text_positions.lines.push_back(i + 1);
  return KeyStore([block, done = false]() mutable -> std::optional<KeyBlock> {
    return std::exchange(done, true) ? std::nullopt : std::optional(block);
  });
}

CurveSpec closed_spec(const char* period) {
  CurveSpec result;
  result.closed = true;
  if (*period != 0) result.period = parse_rational(period);
  return result;
}

TEST(Closing, a_repeated_first_position_is_the_period_and_no_key) {
  auto keys = kept({0.0, 1.0, 2.5}, {3, 4, 3});
  EXPECT_EQ(take_closing(keys, closed_spec(""), {"x"}).hi, 2.5);
  EXPECT_EQ(keys.size(), 2U);
}

TEST(Closing, a_period_is_added_exactly) {
  auto keys = kept({0.1, 0.15}, {3, 4});
  EXPECT_EQ(take_closing(keys, closed_spec("0.2"), {"x"}).hi, 0.3);
}

TEST(Closing, keys_without_times_need_one_step_more) {
  auto keys = kept({0.0, 1.0, 2.0}, {3, 4, 8});
  CurveSpec spec = closed_spec("");
  spec.timed = false;
  EXPECT_EQ(take_closing(keys, spec, {"x"}).hi, 3);
  spec.parameter = ParameterSetting{1, "chordal"};
  EXPECT_EQ(take_closing(keys, spec, {"x"}).hi, 7);
}

TEST(SegmentBlocks, of_a_closed_curve_end_at_the_first_key) {
  const KeyStore keys = kept({0.0, 1.0, 3.0}, {5, 6, 7});
  const auto source = StreamedCurve{keys, {.first = {}, .last = Time(4.0), .closed = true}, {}, {}}.segments();
  std::vector<double> times, positions;
  bool closes = false;
  while (const auto block = source()) {
    for (std::size_t i = 0; i < block->segments.size(); ++i) {
      times.push_back(block->segments.times[i].hi);
      positions.push_back(block->segments[i][0].p1);
    }
    closes = block->closes;
  }
  EXPECT_EQ(times, (std::vector<double>{0, 1, 3}));
  EXPECT_EQ(positions, (std::vector<double>{6, 7, 5}));
  EXPECT_TRUE(closes);
}

TEST(SegmentBlocks, of_sparse_keys_are_measured_on_request) {
  const auto block = StreamedCurve{kept({0.0, 1.0, 2.0}, {0, std::nan(""), 3}), {}, {}, {}}.segments(true)();
  ASSERT_EQ(block->lengths.size(), 2U);
  EXPECT_EQ(block->lengths[0].value, 1.5);
  EXPECT_TRUE(block->last);
}

TEST(KeptCurve, segments_have_their_place_on_the_curve) {
  const spline::Keys<double> keys{1, {0, 1, 2, 4}, {0, 3, 3, 7}, {}, {.tension = 1}, {}};
  const KeptCurve curve = kept_curve_of(*spline::Curve<double>::build(keys));
  EXPECT_EQ(curve.size(), 3U);
  const CurveSegment segment = curve.segment(2);
  EXPECT_EQ(segment.start.hi, 2);
  EXPECT_EQ(segment.s_start.hi, 3);
  EXPECT_EQ(segment.s_end.hi, 7);
  EXPECT_TRUE(segment.last);
  EXPECT_EQ(segment.end_key, 3U);
  EXPECT_EQ(segment.cycle[0], 7);
}

TEST(KeptCurve, a_closed_curve_ends_at_its_first_key) {
  const spline::Keys<double> keys{1, {0, 1, 2}, {0, 3, 5}, {}, {}, {}};
  const KeptCurve curve = kept_curve_of(*spline::Curve<double>::build_closed(keys, {}, spline::DoubleDouble(4.0)));
  EXPECT_EQ(curve.size(), 3U);
  EXPECT_EQ(curve.segment(1).end_key, 2U);
  EXPECT_EQ(curve.segment(2).end_key, 0U);
  EXPECT_EQ(curve.segment(2).cycle[0], 0);
}

}  // namespace
}  // namespace tcb
