// Curve stream: the segments of a kept curve from blocks of any size, open and closed, each as soon as possible.
#include "tcb/spline/curve_stream.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "example_keys.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb::spline {
namespace {

/// The segments of keys that are pushed in blocks.
Segments<double> streamed(CurveStream<double> stream, const Keys<double>& keys, std::size_t size,
                          const CurveRules<double>& rules) {
  Segments<double> result;
  const auto take = [&](const Window<double>& window) {
    const auto next = segments(window, rules);
    if (next.size() > 0) append(result, next);
  };
  for (std::size_t first = 0; first < keys.size(); first += size) {
    Keys<double> block;
    append(block, keys, first, std::min(first + size, keys.size()));
    take(stream.push(block));
  }
  take(stream.finish());
  return result;
}

void expect_equal(const Segments<double>& found, const Curve<double>& curve) {
  ASSERT_EQ(found.size(), curve.segment_count());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Segment<double> segment = curve.segment(i);
    EXPECT_TRUE(found.times[i] == segment.start && found.times[i + 1] == segment.end);
    for (std::size_t k = 0; k < found.channels; ++k) {
      const auto &a = found[i][k], &b = segment.cubics[k];
      EXPECT_TRUE(a.p0 == b.p0 && a.out == b.out && a.c == b.c && a.c_low == b.c_low && a.p1 == b.p1 && a.in == b.in &&
                  a.e == b.e && a.e_low == b.e_low && a.d == b.d);
    }
    for (std::size_t k = 0; k < segment.rotations.size(); ++k) {
      const auto a = found.rotations_of(i)[k].at({0.25, -0.75}), b = segment.rotations[k].at({0.25, -0.75});
      EXPECT_TRUE((a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w) ||
                  (a.x == -b.x && a.y == -b.y && a.z == -b.z && a.w == -b.w));
    }
  }
}

TEST(CurveStream, blocks_of_any_size_give_the_segments_of_the_kept_curve) {
  std::mt19937_64 random(6);
  const auto keys = random_keys(random, 23, 6);
  CurveRules<double> rules;
  rules.rotations = {{{1, 2, 4, 5}}};
  const auto curve = Curve<double>::build(keys, rules);
  for (std::size_t size = 1; size <= 23; ++size) expect_equal(streamed({}, keys, size, rules), *curve);
}

TEST(CurveStream, equal_speed_has_the_metric_of_the_kept_curve) {
  std::mt19937_64 random(9);
  const auto keys = random_keys(random, 11, 6);
  CurveRules<double> rules;
  rules.equal_speed = true;
  rules.rotations = {{{1, 2, 4, 5}}};
  expect_equal(streamed({}, keys, 3, rules), *Curve<double>::build(keys, rules));
}

TEST(CurveStream, a_closed_curve_returns_to_its_first_key) {
  std::mt19937_64 random(7);
  for (const std::size_t count : {2U, 3U, 9U}) {
    const auto keys = random_keys(random, count, 2);
    const DoubleDouble end = keys.times.back() + DoubleDouble(1.5);
    const auto curve = Curve<double>::build_closed(keys, {}, end - keys.times.front());
    Keys<double> last;
    append(last, keys, count - 1, count);
    for (std::size_t size = 1; size <= count; ++size) {
      expect_equal(streamed({last, curve->times().back()}, keys, size, {}), *curve);
    }
  }
}

TEST(CurveStream, a_single_key_is_a_constant_segment) {
  std::mt19937_64 random(8);
  const auto keys = random_keys(random, 1, 3);
  expect_equal(streamed({}, keys, 1, {}), *Curve<double>::build(keys));
}

TEST(CurveStream, a_segment_is_complete_with_the_key_after_its_end) {
  const auto keys = keys_of(example);
  CurveStream<double> stream;
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    Keys<double> block;
    append(block, keys, i, i + 1);
    known.push_back(segments<double>(stream.push(block), {}).size());
  }
  EXPECT_EQ(known, (std::vector<std::size_t>{0, 0, 1, 1, 1}));
}

}  // namespace
}  // namespace tcb::spline
