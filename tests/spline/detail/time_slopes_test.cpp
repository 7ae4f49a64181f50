// Time slopes: the monotone cubic, against numbers of SciPy's PchipInterpolator.
#include "tcb/spline/detail/time_slopes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace tcb::spline {
namespace {

/// The number of a key, with fractions between keys, at a time of a window. Its first segment begins at key 0.
double number_at(const Window<double>& window, double t) {
  const auto& times = window.keys.times;
  std::size_t key = window.first_key();
  while (key + 1 < window.last_key() && times[key + 1].hi <= t) ++key;
  const auto at = TimeMap<double>(times[key], times[key + 1], TimeSlopes<double>(window).warp(key))({t});
  return static_cast<double>(key - window.first_key()) + at.u;
}

Window<double> window_of(const std::vector<double>& times, bool has_context) {
  Window<double> window;
  window.keys.channels = 1;
  for (const double time : times) window.keys.times.emplace_back(time);
  window.keys.positions.resize(times.size());
  window.starts = window.ends = !has_context;
  return window;
}

Warp<double> warp_of(const std::vector<double>& times, std::size_t key) {
  const auto window = window_of(times, false);
  return TimeSlopes<double>(window).warp(key);
}

using Values = std::vector<std::array<double, 2>>;  // times, numbers

void expect_values(const Window<double>& window, const Values& values) {
  for (const auto& [t, number] : values) EXPECT_NEAR(number_at(window, t), number, 1e-15) << t;
}

TEST(TimeSlopes, are_those_of_pchip) {
  expect_values(window_of({0, 1, 1.5, 4, 4.2}, false), {{0.25, 0.13822115384615383},
                                                        {1.25, 1.537625418060201},
                                                        {2, 2.2762683169874656},
                                                        {3.75, 2.7917498295484346},
                                                        {4.1, 3.390908501988113}});
}

TEST(TimeSlopes, are_not_below_0_at_an_end) {
  expect_values(window_of({0, 5, 5.5, 6}, false),
                {{0.25, 0.001691489361702128}, {1, 0.029106382978723408}, {4.5, 0.7824255319148936}, {5.75, 2.5}});
}

TEST(TimeSlopes, take_the_neighbours_of_a_closed_curve) {
  expect_values(window_of({-0.5, 0, 1, 3, 3.5, 4.5}, true),
                {{0.25, 0.31850961538461536}, {2, 1.4458041958041958}, {3.25, 2.47027972027972}});
}

TEST(TimeSlopes, are_1_at_equal_times_and_between_two_keys) {
  EXPECT_TRUE(warp_of({0, 7}, 0).is_identity());
  EXPECT_TRUE(warp_of({0, 2, 4, 6}, 1).is_identity());
}

TEST(TimeSlopes, do_not_overflow) {
  for (const double size : {1e-300, 1e300}) {
    const auto window = window_of({0, size, 3 * size}, false);
    EXPECT_NEAR(number_at(window, 2 * size), number_at(window_of({0, 1, 3}, false), 2), 1e-15);
  }
}

}  // namespace
}  // namespace tcb::spline
