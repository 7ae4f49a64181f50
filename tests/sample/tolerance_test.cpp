// Tolerance: the polyline stays as near as promised, corners are rows, and there are no more rows than needed.
#include "sample/places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "error.hpp"
#include "sample/kept_curve_of.hpp"
#include "spline/allocations.hpp"

namespace tcb {
namespace {

/// A curve through keys, and its position by time.
struct Curve : KeptCurve {
  Curve(const spline::Keys<double>& keys, const spline::CurveRules<double>& rules = {})
      : KeptCurve(kept_curve_of(*spline::Curve<double>::build(keys, rules))) {}

  std::vector<double> at(double t) const {
    std::vector<double> x(curve().channels());
    curve().position(t, x);
    return x;
  }
};

double distance(const std::vector<double>& p, const std::vector<double>& a, const std::vector<double>& b) {
  double along = 0, length2 = 0, distance2 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    along += (p[i] - a[i]) * (b[i] - a[i]);
    length2 += (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double part = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
  for (std::size_t i = 0; i < p.size(); ++i) distance2 += std::pow(p[i] - a[i] - part * (b[i] - a[i]), 2);
  return std::sqrt(distance2);
}

spline::Keys<double> random_keys(std::mt19937_64& random, std::size_t channels) {
  std::uniform_real_distribution<double> place(-1, 1);
  spline::Keys<double> keys;
  keys.channels = channels;
  double t = 0;
  for (int i = 0; i < 6; ++i, t += 1.5 + place(random)) {
    keys.times.emplace_back(t);
    keys.tcbs.push_back({place(random), i % 2 == 0 ? place(random) : 0, place(random)});
    for (std::size_t c = 0; c < channels; ++c) keys.positions.push_back(place(random));
  }
  return keys;
}

TEST(Tolerance, no_point_of_the_curve_is_farther_from_the_polyline) {
  std::mt19937_64 random(21);
  for (int round = 0; round < 40; ++round) {
    const auto keys = random_keys(random, round % 2 == 0 ? 2 : 3);
    const Curve curve(keys);
    const double tolerance = std::pow(10, -1 - round % 3);
    const bool at_keys = round % 4 >= 2;
    auto rows = rows_within_tolerance(curve, {tolerance}, 1'000'000, at_keys).times;
    if (at_keys) {
      rows.insert(rows.end(), keys.times.begin(), keys.times.end());
      std::ranges::sort(rows);
    }
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      const auto a = curve.at(rows[i].hi), b = curve.at(rows[i + 1].hi);
      for (double f = 0; f <= 1; f += 1.0 / 64) {
        ASSERT_LE(distance(curve.at(rows[i].hi + f * (rows[i + 1].hi - rows[i].hi)), a, b), tolerance);
      }
    }
  }
}

/// Keys at seconds since 1970, where a double is a quarter of a microsecond from the next.
spline::Keys<double> late_keys(std::size_t channels) {
  spline::Keys<double> keys{channels, {1403715524.0, 1403715525.0, 1403715526.0, 1403715527.0}, {}, {}, {}, {}};
  for (const double y : {0, 1, 0, 1}) {
    if (channels == 2) keys.positions.push_back(static_cast<double>(keys.positions.size()) / 2);
    keys.positions.push_back(y);
  }
  return keys;
}

TEST(Tolerance, holds_for_rows_at_the_times_that_they_print) {
  constexpr double tolerance = 1e-8;
  const Curve path(late_keys(2)), graph(late_keys(1));
  const auto of_path = rows_within_tolerance(path, {tolerance}, 1'000'000).times;
  const auto of_graph = rows_within_tolerance(graph, {1e-6}, 1'000'000).times;
  const auto between = [](const std::vector<Time>& rows, std::size_t i, int part) {
    return rows[i].hi + (rows[i + 1].hi - rows[i].hi) * part / 16;
  };
  for (std::size_t i = 0; i + 1 < of_path.size(); ++i) {
    const auto a = path.at(of_path[i].hi), b = path.at(of_path[i + 1].hi);
    for (int part = 1; part < 16; ++part) ASSERT_LE(distance(path.at(between(of_path, i, part)), a, b), tolerance);
  }
  for (std::size_t i = 0; i + 1 < of_graph.size(); ++i) {
    const double a = graph.at(of_graph[i].hi)[0], b = graph.at(of_graph[i + 1].hi)[0];
    for (int part = 1; part < 16; ++part) {
      const double t = between(of_graph, i, part);
      const double height = a + (b - a) * ((t - of_graph[i].hi) / (of_graph[i + 1].hi - of_graph[i].hi));
      ASSERT_LE(std::abs(graph.at(t)[0] - height), 1e-6);
    }
  }
}

TEST(Tolerance, that_no_printed_time_can_keep_is_refused) {
  const Curve path(late_keys(2));
  EXPECT_THROW(rows_within_tolerance(path, {1e-15}, 1'000'000'000), Error);
}

TEST(Tolerance, a_single_channel_is_a_graph_over_time) {
  std::mt19937_64 random(22);
  for (int round = 0; round < 40; ++round) {
    const auto keys = random_keys(random, 1);
    const Curve curve(keys);
    const auto rows = rows_within_tolerance(curve, {0.01}, 1'000'000).times;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      const double a = curve.at(rows[i].hi)[0], b = curve.at(rows[i + 1].hi)[0];
      for (double f = 0; f <= 1; f += 1.0 / 64) {
        const double t = rows[i].hi + f * (rows[i + 1].hi - rows[i].hi);
        ASSERT_LE(std::abs(curve.at(t)[0] - (a + f * (b - a))), 0.01 + 1e-15);
      }
    }
  }
}

TEST(Tolerance, corners_are_rows) {
  std::mt19937_64 random(23);
  for (int round = 0; round < 20; ++round) {
    const auto keys = random_keys(random, 2);
    const auto rows = rows_within_tolerance(Curve(keys), {100}, 1'000'000).times;
    EXPECT_EQ(rows, (std::vector<Time>{keys.times[0], keys.times[2], keys.times[4], keys.times[5]}));
  }
}

TEST(Tolerance, an_s_whose_middle_lies_on_the_chord_is_not_taken_for_straight) {
  spline::Keys<double> keys;
  keys.channels = 2;
  keys.times = {0.0, 1.0};
  keys.positions = {0, 0, 1, 0};
  spline::CurveRules<double> rules;
  constexpr auto velocity = spline::EndRule::velocity;
  rules.start = {velocity, {1, 3}};
  rules.end = {velocity, {1, 3}};
  const Curve s(keys, rules);
  EXPECT_GE(rows_within_tolerance(s, {0.1}, 100).times.size(), 4U);
  EXPECT_EQ(rows_within_tolerance(s, {1}, 100).times.size(), 2U);
}

TEST(Tolerance, refuses_more_rows_than_allowed) {
  std::mt19937_64 random(24);
  const auto keys = random_keys(random, 2);
  EXPECT_THROW(rows_within_tolerance(Curve(keys), {1e-6}, 10), Error);
}

TEST(Tolerance, no_rotation_is_farther_from_the_arcs_between_rows) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> part(0, 0.5);
  spline::CurveRules<double> rules;
  rules.rotations.push_back({{0, 1, 2, 3}});
  for (int round = 0; round < 40; ++round) {
    auto keys = random_keys(random, 4);
    for (std::size_t i = 0; i < keys.size() && round % 2 == 0; ++i) keys.eases.push_back({part(random), part(random)});
    const Curve curve(keys, rules);
    const double angle = std::pow(10, -round % 3) / 4;
    const auto rotation_at = [&](const Time& t) {
      std::uint64_t number = 0;
      while (number + 1 < curve.size() && curve.segment(number).end < t) ++number;
      const CurveSegment segment = curve.segment(number);
      return segment.rotations[0].at(segment.time_map()(t));
    };
    const auto rows = rows_within_tolerance(curve, {std::numeric_limits<double>::infinity(), angle}, 1'000'000).times;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      const auto a = rotation_at(rows[i]), b = rotation_at(rows[i + 1]);
      const spline::Arc<double> arc(a, spline::dot(a, b) < 0 ? -b : b);
      for (double f = 0; f <= 1; f += 1.0 / 64) {
        const auto turn =
            spline::conjugate(arc.at(f, 1 - f)) * rotation_at(rows[i] + (rows[i + 1] - rows[i]) * Time(f));
        const double sine = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
        ASSERT_LE(2 * std::asin(std::min(sine, 1.0)), angle) << round << ", " << i;
      }
    }
  }
}

TEST(Tolerance, takes_memory_for_segments_but_not_for_rows) {
  std::mt19937_64 random(22);
  auto keys = random_keys(random, 3);
  const Curve plain(keys);
  keys.eases.assign(keys.size(), {0.2, 0.3});
  const Curve eased(keys);
  for (const Curve* const curve : {&plain, &eased}) {
    const std::size_t before = allocations;
    const std::size_t few = rows_within_tolerance(*curve, {1e-4}, 1'000'000).times.size();
    const std::size_t middle = allocations;
    const std::size_t many = rows_within_tolerance(*curve, {1e-6}, 1'000'000).times.size();
    EXPECT_GT(many, 5 * few);
    EXPECT_LE(allocations - middle, middle - before + 8) << "for the growing list of times";
  }
}

KeptCurve curve_of_size(std::mt19937_64& random, std::size_t channels, double size) {
  std::uniform_real_distribution<double> place(-1, 1);
  spline::Keys<double> keys;
  keys.channels = channels;
  for (int i = 0; i < 6; ++i) {
    keys.times.emplace_back(i);
    keys.tcbs.push_back({place(random), place(random), place(random)});
    for (std::size_t c = 0; c < channels; ++c) keys.positions.push_back(place(random) * size);
  }
  return kept_curve_of(*spline::Curve<double>::build(keys, {}));
}

TEST(LeastRows, are_never_more_than_the_rows_that_are_enough) {
  std::mt19937_64 random(51);
  for (int round = 0; round < 200; ++round) {
    const double size = std::pow(10, (round % 5 - 2) * 150), tolerance = size * std::pow(10, -round % 5);
    const auto rows = rows_within_tolerance(curve_of_size(random, 1 + static_cast<std::size_t>(round) % 4, size),
                                            {tolerance}, 1'000'000);
    EXPECT_LE(rows.least, rows.times.size()) << round;
  }
}

TEST(LeastRows, are_two_thirds_of_the_rows_of_a_small_tolerance) {
  std::mt19937_64 random(52);
  for (int round = 0; round < 20; ++round) {
    const auto rows =
        rows_within_tolerance(curve_of_size(random, 1 + static_cast<std::size_t>(round) % 4, 1), {1e-5}, 1'000'000);
    EXPECT_LT(static_cast<double>(rows.least), 0.75 * static_cast<double>(rows.times.size())) << round;
    EXPECT_GT(static_cast<double>(rows.least), 0.6 * static_cast<double>(rows.times.size())) << round;
  }
}

}  // namespace
}  // namespace tcb
