// Fits: the curve of the keys is within the tolerances, by the library's own evaluation.
#include "fit/fit.hpp"

#include <gtest/gtest.h>

#include <random>

#include "fit/recordings.hpp"
#include "stream/ordered_map.hpp"
#include "tcb/spline/curve.hpp"
#include "tcb/spline/window_segments.hpp"

namespace tcb {
namespace {

/// The largest distance of the samples from the curve, in tolerances.
double largest_distance(const Recording& recording, const Keys& keys) {
  const auto curve = spline::Curve<double>::build(keys);
  double largest = 0;
  std::vector<double> position(recording.channels);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    curve->position(recording.times[i], position);
    for (const FitGroup& group : recording.groups) {
      double sum = 0;
      for (const std::size_t channel : group.channels) {
        sum += std::pow(position[channel] - recording.position(i, channel), 2);
      }
      largest = std::max(largest, std::sqrt(sum) / group.tolerance);
    }
  }
  return largest;
}

Recording noisy_recording(std::uint64_t seed, double noise, double tolerance) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise);
  return recording_of({[&](double t) { return std::sin(t) + normal(random); },
                       [&](double t) { return std::cos(1.7 * t) + normal(random); }},
                      2000, 0.01, tolerance);
}

TEST(Fit, is_within_the_tolerance) {
  for (const double noise : {0.0, 0.002, 0.02}) {
    for (const double tolerance : {0.1, 0.01}) {
      for (const FitKeys kind : {FitKeys::tcb, FitKeys::hermite}) {
        const Recording recording = noisy_recording(7, noise, tolerance);
        const auto result = fit(recording, times_of(recording), {.keys = kind});
        ASSERT_TRUE(result);
        EXPECT_LE(largest_distance(recording, result->keys), 1);
        EXPECT_NEAR(largest_distance(recording, result->keys), result->largest, 1e-9);
        EXPECT_GE(result->keys.size(), result->least_keys);
      }
    }
  }
}

TEST(Fit, of_a_long_recording_is_the_same_on_any_number_of_threads) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 0.01);
  const Recording recording =
      recording_of({[&](double t) { return std::sin(t) + normal(random); }}, 80'000, 0.01, 0.05);  // two parts
  const auto one = fit(recording, times_of(recording), {.keys = FitKeys::hermite});
  const ThreadPool pool(2);
  const auto two = fit(recording, times_of(recording), {.keys = FitKeys::hermite, .threads = 2});
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->keys.positions, two->keys.positions);
  EXPECT_LE(largest_distance(recording, two->keys), 1);
}

TEST(Fit, rotations_are_within_their_angle) {
  const auto half = [](double t) { return 0.4 * std::sin(t); };  // of the angle, around an axis that moves
  Recording recording =
      recording_of({[](double t) { return t * t; }, [&](double t) { return std::sin(half(t)) * std::cos(t / 3); },
                    [&](double t) { return std::sin(half(t)) * std::sin(t / 3); }, [](double) { return 0.0; },
                    [&](double t) { return std::cos(half(t)); }},
                   400, 0.02, 0.1);
  for (const FitKeys kind : {FitKeys::tcb, FitKeys::hermite}) {
    constexpr double angle = 0.004;
    recording.groups = {{{0}, 0.1}, {{1, 2, 3, 4}, 0.0018, angle}};
    const auto result = fit(recording, times_of(recording), {.keys = kind});
    ASSERT_TRUE(result);
    spline::CurveRules<double> rules;
    rules.rotations = {{{1, 2, 3, 4}}};
    const auto segments = spline::segments(spline::Window<double>{result->keys}, rules);
    for (std::size_t i = 0, segment = 0; i < recording.size(); ++i) {
      while (segments.times[segment + 1].hi < recording.times[i]) ++segment;
      const double start = segments.times[segment].hi, end = segments.times[segment + 1].hi;
      const double u = (recording.times[i] - start) / (end - start);
      const auto q = segments.rotations[segment].at({u, u - 1});
      const double cosine = q.x * recording.position(i, 1) + q.y * recording.position(i, 2) +
                            q.z * recording.position(i, 3) + q.w * recording.position(i, 4);
      EXPECT_LE(2 * std::acos(std::min(std::abs(cosine), 1.0)), angle + 1e-7);  // the cosine is rounded
    }
    EXPECT_EQ(result->least_keys, 2);  // of the parabola
    EXPECT_LT(result->keys.size(), 40);
  }
}

TEST(Fit, takes_a_tolerance_for_each_group) {
  Recording recording = noisy_recording(8, 0, 1);
  recording.groups = {{{0}, 0.1}, {{1}, 0.001}};
  const auto result = fit(recording, times_of(recording), {});
  ASSERT_TRUE(result);
  EXPECT_LE(largest_distance(recording, result->keys), 1);
}

TEST(Fit, corners_are_where_samples_turn) {
  const auto along = [](double t) { return std::min(t, 3.0); };
  const auto across = [](double t) { return std::max(t - 3, 0.0); };
  const Recording recording = recording_of({along, across}, 601, 0.01, 1e-4);
  EXPECT_EQ(corners_of(recording, 30), (std::vector<std::size_t>{300}));
  EXPECT_TRUE(corners_of(recording, 100).empty());
  const auto result = fit(recording, times_of(recording), {.corner = 30});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->keys.size(), 3U);
  EXPECT_LE(largest_distance(recording, result->keys), 1);
}

TEST(Fit, repeated_positions_with_a_slope_need_velocities) {
  // Equal positions at 0, 2, 4, … and between them waves: no tension gives a slope between equal positions.
  Recording recording = recording_of({[](double t) { return std::sin(3.141592653589793 * t); }}, 41, 0.5, 1e-4);
  std::vector<std::size_t> fixed;
  for (std::size_t i = 2; i < 40; i += 2) fixed.push_back(i);
  const auto result = fit(recording, times_of(recording), {.keys = FitKeys::hermite, .fixed = fixed});
  ASSERT_TRUE(result);
  EXPECT_LE(largest_distance(recording, result->keys), 1);
}

}  // namespace
}  // namespace tcb
