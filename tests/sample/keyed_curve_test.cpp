// Curves by their keys: sparse channels run as if they were alone, at any scalar; periodic extension.
#include "sample/keyed_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/rounding.hpp"
#include "keys.hpp"
#include "sample/build.hpp"

namespace tcb {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Row {
  double time, x, y;
};

/// Keys of two channels with a tension of a tenth of their time.
Keys keys(const std::vector<Row>& rows) {
  Keys all;
  all.channels = 2;
  for (const auto& [time, x, y] : rows) {
    all.times.emplace_back(time);
    all.positions.insert(all.positions.end(), {x, y});
    all.tcbs.push_back({time / 10, 0.25, -0.5});
  }
  return all;
}

/// The keys that have a position in this channel, and only that.
Keys alone(const Keys& all, std::size_t channel) {
  Keys own;
  own.channels = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::isnan(all.position(i)[channel])) continue;
    own.times.push_back(all.times[i]);
    own.positions.push_back(all.position(i)[channel]);
    own.tcbs.push_back(all.tcbs[i]);
  }
  return own;
}

Source<Keys> once(Keys all) {
  return [left = std::optional(std::move(all))]() mutable { return std::exchange(left, std::nullopt); };
}

/// The channel's position at a time.
double at(const spline::Segments<double>& segments, double t, std::size_t channel) {
  std::size_t i = 0;
  while (i + 1 < segments.size() && segments.times[i + 1].hi <= t) ++i;
  const double duration = (segments.times[i + 1] - segments.times[i]).hi;
  const double u = (t - segments.times[i].hi) / duration;
  return spline::position(segments[i][channel], {u, u - 1});
}

Source<KeyBlock> blocks_of(const Keys& all) {
  return [left = std::optional(KeyBlock{all, std::vector<std::uint64_t>(all.size(), 1)})]() mutable {
    return std::exchange(left, std::nullopt);
  };
}

spline::Segments<double> joined(const Keys& all, std::optional<Time> end = {}) {
  const KeyStore store(blocks_of(all));
  return sparse_segment_blocks(store, end, {}, false, {"x", "y"})()->segments;
}

/// All segments of a curve, which come in segment_blocks.
spline::Segments<double> all_of(const Source<SegmentBlock>& segment_blocks) {
  spline::Segments<double> all = segment_blocks()->segments;
  while (const auto more = segment_blocks()) {
    if (all.size() == 0) all = more->segments;
    for (std::size_t i = 0; all.times.back() != more->segments.times.back() && i < more->segments.size(); ++i) {
      all.times.push_back(more->segments.times[i + 1]);
      all.cubics.insert(all.cubics.end(), more->segments[i].begin(), more->segments[i].end());
    }
  }
  return all;
}

spline::Segments<double> plain(const Keys& all) { return all_of(segment_blocks({once(all), {}}, {}, false)); }

TEST(Sparse, each_channel_runs_as_if_it_were_alone) {
  const Keys all = keys({{0, 1, 5}, {1, 3, none}, {2, none, none}, {4, -2, 7}, {5, 0, none}, {8, 6, -3}});
  const auto together = joined(all);
  ASSERT_EQ(together.size(), 5U);
  for (std::size_t channel = 0; channel < 2; ++channel) {
    const auto own = plain(alone(all, channel));
    for (double t = 0; t <= 8; t += 0.0625) EXPECT_NEAR(at(together, t, channel), at(own, t, 0), 1e-14) << t;
  }
}

TEST(Sparse, a_channel_without_a_missing_position_keeps_every_bit) {
  const Keys all = keys({{0, 1, 5}, {0.3, 3, none}, {2.1, 0.7, 9}, {4, -2, none}, {5, 0.1, 2}});
  const auto together = joined(all), own = plain(alone(all, 0));
  ASSERT_EQ(together.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto &one = together[i][0], &other = own[i][0];
    EXPECT_TRUE(one.p0 == other.p0 && one.out == other.out && one.c == other.c && one.c_low == other.c_low &&
                one.p1 == other.p1 && one.in == other.in && one.e == other.e && one.d == other.d);
  }
}

TEST(Sparse, the_curve_passes_through_keys_bit_for_bit) {
  const Keys all = keys({{0, 0.1, 5}, {0.3, none, 0.7}, {2.1, 0.3, none}, {4, none, 0.9}});
  const auto together = joined(all);
  EXPECT_EQ(together[1][0].p1, 0.3);
  EXPECT_EQ(together[0][1].p1, 0.7);
  EXPECT_EQ(together[2][1].p1, 0.9);
}

TEST(Sparse, a_channel_is_constant_before_its_first_key_and_after_its_last) {
  const auto together = joined(keys({{0, 0, none}, {1, 1, 4}, {2, 2, 6}, {3, 3, none}}));
  EXPECT_EQ(at(together, 0, 1), 4);
  EXPECT_EQ(at(together, 0.5, 1), 4);
  EXPECT_EQ(at(together, 2.5, 1), 6);
  const auto constant = joined(keys({{0, 0, none}, {1, 1, 4}, {3, 3, none}}));
  for (const double t : {0.0, 0.5, 1.0, 2.0, 3.0}) EXPECT_EQ(at(constant, t, 1), 4);
}

TEST(Sparse, a_channel_without_any_number_is_refused) {
  EXPECT_EQ(refusal_of([] {
              joined(keys({{0, 0, none}, {1, 1, none}}));
            }),
            "f: error: y: no key has a number; expected at least one; fill one in, or leave the column out with "
            "--columns");
}

TEST(Sparse, on_a_closed_curve_a_channel_is_extended_by_its_own_keys) {
  const Keys all = keys({{0, 1, none}, {1, 3, 2}, {2, 0, none}, {4, 2, 5}, {5, 1.5, 3}});
  const KeyStore own(blocks_of(alone(all, 1)));
  const auto together = joined(all, Time(7.0));
  // The channel's own curve is from time 1 to 8.
  const auto segments = all_of(segment_blocks(periodic_extension(own, {8.0}), {}, false));
  for (double t = 0; t < 7; t += 0.125) {
    EXPECT_NEAR(at(together, t, 1), at(segments, t < 1 ? t + 7 : t, 0), 1e-14) << t;
  }
}

TEST(Sparse, lengths_are_measured_on_request) {
  const Keys all = keys({{0, 0, 0}, {1, 3, none}, {2, 3, 0}});
  const KeyStore store(blocks_of(all));
  const auto block = sparse_segment_blocks(store, {}, {}, true, {"x", "y"})();
  ASSERT_EQ(block->lengths.size(), 2U);
  EXPECT_GE(block->lengths[0].value, 3);
  EXPECT_TRUE(block->last);
}

TEST(KeyedCurve, any_range_of_segments_is_that_of_the_whole) {
  const Keys all = keys({{0, 1, 5}, {1, 3, none}, {2, none, none}, {4, -2, 7}, {5, 0, none}, {8, 6, -3}});
  std::vector<bool> missing;
  for (const double position : all.positions) missing.push_back(std::isnan(position));
  for (const auto& end : {std::optional<Time>(), std::optional<Time>(9.5)}) {
    const KeyedCurve<double> curve(all, missing, {}, end);
    const auto whole = curve.segments(0, curve.size());
    for (std::size_t first = 0; first < curve.size(); ++first) {
      for (std::size_t to = first + 1; to <= curve.size(); ++to) {
        const auto part = curve.segments(first, to);
        for (std::size_t i = 0; i < part.size() * 2; ++i) {
          EXPECT_EQ(part[i / 2][i % 2].p0, whole[first + i / 2][i % 2].p0);
          EXPECT_EQ(part[i / 2][i % 2].out, whole[first + i / 2][i % 2].out);
          EXPECT_EQ(part[i / 2][i % 2].d, whole[first + i / 2][i % 2].d);
        }
      }
    }
  }
}

TEST(KeyedCurve, extension_repeats_keys_every_period_at_every_scalar) {
  const auto time = [](std::ptrdiff_t number) {
    const auto key = [](std::size_t i) {
      return spline::Keys<Rational>{1, {Rational(static_cast<int>(i))}, {0}, {}, {}, {}};
    };
    return extended_key<Rational>(key, 3, Rational(10), number).times[0];
  };
  EXPECT_EQ(time(2), 2);
  EXPECT_EQ(time(3), 10);
  EXPECT_EQ(time(-1), -8);
  EXPECT_EQ(time(-4), -18);
}

}  // namespace
}  // namespace tcb
