// Curve keys: sparse channels, rotations and angles run as if they were alone; closed curves; any range of segments.
#include "tcb/spline/curve_keys.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tcb/spline/curve_stream.hpp"

namespace tcb::spline {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Row {
  double time, x, y;
};

/// Keys of two channels with a tension of a tenth of their time.
Keys<double> keys(const std::vector<Row>& rows) {
  Keys<double> all;
  all.channels = 2;
  for (const auto& [time, x, y] : rows) {
    all.times.emplace_back(time);
    all.positions.insert(all.positions.end(), {x, y});
    all.tcbs.push_back({time / 10, 0.25, -0.5});
  }
  return all;
}

/// The keys that have a position in this channel, and only that.
Keys<double> alone(const Keys<double>& all, std::size_t channel) {
  Keys<double> own;
  own.channels = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::isnan(all.position(i)[channel])) continue;
    own.times.push_back(all.times[i]);
    own.positions.push_back(all.position(i)[channel]);
    own.tcbs.push_back(all.tcbs[i]);
  }
  return own;
}

/// The channel's position at a time.
double channel_at(const Segments<double>& segments, double t, std::size_t channel) {
  std::size_t i = 0;
  while (i + 1 < segments.size() && segments.times[i + 1].hi <= t) ++i;
  const double duration = (segments.times[i + 1] - segments.times[i]).hi;
  const double u = (t - segments.times[i].hi) / duration;
  return position(segments[i][channel], {u, u - 1});
}

Segments<double> joined(const Keys<double>& all, const std::optional<DoubleDouble>& end = {},
                        const CurveRules<double>& rules = {}) {
  const CurveKeys<double> curve(all, rules, end);
  return curve.segments(0, curve.size());
}

/// The segments of keys without a missing position.
Segments<double> plain(const Keys<double>& all, const CurveRules<double>& rules = {}) {
  return segments<double>({all}, rules);
}

TEST(Sparse, each_channel_runs_as_if_it_were_alone) {
  const Keys<double> all = keys({{0, 1, 5}, {1, 3, none}, {2, none, none}, {4, -2, 7}, {5, 0, none}, {8, 6, -3}});
  const auto together = joined(all);
  ASSERT_EQ(together.size(), 5U);
  for (std::size_t channel = 0; channel < 2; ++channel) {
    const auto own = plain(alone(all, channel));
    for (double t = 0; t <= 8; t += 0.0625)
      EXPECT_NEAR(channel_at(together, t, channel), channel_at(own, t, 0), 1e-14) << t;
  }
}

TEST(Sparse, a_channel_without_a_missing_position_keeps_every_bit) {
  const Keys<double> all = keys({{0, 1, 5}, {0.3, 3, none}, {2.1, 0.7, 9}, {4, -2, none}, {5, 0.1, 2}});
  const auto together = joined(all), own = plain(alone(all, 0));
  ASSERT_EQ(together.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto &one = together[i][0], &other = own[i][0];
    EXPECT_TRUE(one.p0 == other.p0 && one.out == other.out && one.c == other.c && one.c_low == other.c_low &&
                one.p1 == other.p1 && one.in == other.in && one.e == other.e && one.d == other.d);
  }
}

TEST(Sparse, the_curve_passes_through_keys_bit_for_bit) {
  const Keys<double> all = keys({{0, 0.1, 5}, {0.3, none, 0.7}, {2.1, 0.3, none}, {4, none, 0.9}});
  const auto together = joined(all);
  EXPECT_EQ(together[1][0].p1, 0.3);
  EXPECT_EQ(together[0][1].p1, 0.7);
  EXPECT_EQ(together[2][1].p1, 0.9);
}

TEST(Sparse, a_channel_is_constant_before_its_first_key_and_after_its_last) {
  const auto together = joined(keys({{0, 0, none}, {1, 1, 4}, {2, 2, 6}, {3, 3, none}}));
  EXPECT_EQ(channel_at(together, 0, 1), 4);
  EXPECT_EQ(channel_at(together, 0.5, 1), 4);
  EXPECT_EQ(channel_at(together, 2.5, 1), 6);
  const auto constant = joined(keys({{0, 0, none}, {1, 1, 4}, {3, 3, none}}));
  for (const double t : {0.0, 0.5, 1.0, 2.0, 3.0}) EXPECT_EQ(channel_at(constant, t, 1), 4);
}

TEST(Sparse, on_a_closed_curve_a_channel_is_extended_by_its_own_keys) {
  const Keys<double> all = keys({{0, 1, none}, {1, 3, 2}, {2, 0, none}, {4, 2, 5}, {5, 1.5, 3}});
  const Keys<double> own = alone(all, 1);
  const auto together = joined(all, DoubleDouble(7.0));
  // The channel's own curve is from time 1 to 8.
  Keys<double> last;
  append(last, own, own.size() - 1, own.size());
  CurveStream<double> stream(last, 8.0);
  Segments<double> segments = spline::segments<double>(stream.push(own), {});
  append(segments, spline::segments<double>(stream.finish(), {}));
  for (double t = 0; t < 7; t += 0.125) {
    EXPECT_NEAR(channel_at(together, t, 1), channel_at(segments, t < 1 ? t + 7 : t, 0), 1e-14) << t;
  }
}

TEST(Sparse, an_angle_turns_the_shorter_way_in_its_own_channel_alone) {
  const Keys<double> all = keys({{0, 350, 4}, {1, 10, none}, {2, 30, 300}, {3, 20, 310}});
  CurveRules<double> rules;
  rules.angles = {{0, true}};
  const auto together = joined(all, {}, rules);
  const auto angle = plain(alone(all, 0), rules), other = plain(alone(all, 1));
  for (double t = 0; t < 3; t += 0.25) {
    EXPECT_NEAR(channel_at(together, t, 0), channel_at(angle, t, 0), 1e-12) << t;
    EXPECT_NEAR(channel_at(together, t, 1), channel_at(other, t, 0), 1e-12) << t;
  }
  EXPECT_GT(channel_at(together, 0.4, 0), 350);
}

TEST(Sparse, a_rotation_runs_through_the_keys_that_have_it) {
  const double half = std::sqrt(0.5);
  Keys<double> all{5, {0, 1, 2, 3}, {}, {}, {}, {}};
  all.positions = {0, 0, 0, 0, 1, 1, none, none, none, none, 2, 0, 0, half, half, 3, none, none, none, none};
  CurveRules<double> rules;
  rules.rotations = {{{1, 2, 3, 4}}};
  rules.rotation_rules.curve = RotationCurve::slerp;
  const auto together = joined(all, {}, rules);
  ASSERT_EQ(together.rotations.size(), 3U);
  const auto middle = together.rotations_of(0)[0].at({1, 0});
  EXPECT_NEAR(middle.z, std::sin(std::acos(-1) / 8), 1e-15);
  EXPECT_NEAR(together.rotations_of(2)[0].at({0.5, -0.5}).z, half, 1e-15);
}

TEST(CurveKeys, any_range_of_segments_is_that_of_the_whole) {
  const Keys<double> all = keys({{0, 1, 5}, {1, 3, none}, {2, none, none}, {4, -2, 7}, {5, 0, none}, {8, 6, -3}});
  for (const auto& end : {std::optional<DoubleDouble>(), std::optional<DoubleDouble>(9.5)}) {
    const CurveKeys<double> curve(all, {}, end);
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

TEST(CurveKeys, a_mask_is_as_good_as_nan) {
  Keys<double> all = keys({{0, 1, 5}, {1, 3, none}, {2, none, 4}, {4, -2, 7}});
  const auto by_nan = joined(all);
  for (double& position : all.positions) {
    all.missing.push_back(std::isnan(position));
    if (std::isnan(position)) position = 99;
  }
  const auto by_mask = joined(all);
  for (std::size_t i = 0; i < by_nan.cubics.size(); ++i) {
    EXPECT_EQ(by_nan.cubics[i].p1, by_mask.cubics[i].p1);
    EXPECT_EQ(by_nan.cubics[i].out, by_mask.cubics[i].out);
  }
}

}  // namespace
}  // namespace tcb::spline
