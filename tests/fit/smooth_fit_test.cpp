// Smooth fits: curves of cubics are found again, and the largest distance is made small.
#include "fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/recordings.hpp"

namespace tcb {
namespace {

FitKey key_at(std::size_t sample, std::size_t channels = 1) {
  return {sample, std::vector<double>(channels), std::vector<double>(channels)};
}

TEST(SmoothFit, finds_a_curve_of_cubics) {
  const auto curve = [](double t) { return t < 1 ? t * t * t : 1 + 3 * (t - 1) - (t - 1) * (t - 1); };
  const auto other = [&](double t) { return 5 - 2 * curve(t); };
  const Recording recording = recording_of({curve, other}, 201, 0.01, 1e-3);
  std::vector<FitKey> keys{key_at(0, 2), key_at(100, 2), key_at(200, 2)};
  const auto worst = fit_smoothly(recording, keys, {});
  EXPECT_LE(*std::ranges::max_element(worst), 0.02);
  EXPECT_NEAR(keys[1].position[0], 1, 1e-5);
  EXPECT_NEAR(keys[1].slope[0], 3, 1e-4);
  EXPECT_NEAR(keys[2].position[1], -1, 1e-5);
  EXPECT_NEAR(keys[2].slope[1], -2, 1e-4);
}

TEST(SmoothFit, balances_the_largest_distances) {
  // The best quadratic (by symmetry) for t^4 on [-1, 1] is off by 1/8; least squares alone by more.
  const auto power = [](double t) { return (t - 1) * (t - 1) * (t - 1) * (t - 1); };
  const Recording recording = recording_of({power}, 401, 0.005, 1e-3);
  std::vector<FitKey> keys{key_at(0), key_at(400)};
  const double least_squares = fit_smoothly(recording, keys, {}, {0, 1e-6, false})[0];
  const double balanced = fit_smoothly(recording, keys, {}, {40, 1e-6, false})[0];
  EXPECT_GT(least_squares, 200);
  EXPECT_NEAR(balanced, 125, 2);
}

TEST(SmoothFit, is_given_up_where_no_curve_is_near_enough) {
  const auto power = [](double t) { return (t - 1) * (t - 1) * (t - 1) * (t - 1); };
  const Recording recording = recording_of({power}, 401, 0.005, 0.124);  // 1/8 is the least
  std::vector<FitKey> keys{key_at(0), key_at(400)};
  EXPECT_GT(fit_smoothly(recording, keys, {}, {100, 1e-6, true})[0], 1);
  const Recording wider = recording_of({power}, 401, 0.005, 0.127);
  EXPECT_LE(fit_smoothly(wider, keys, {}, {100, 1e-6, true})[0], 1);
}

TEST(SmoothFit, is_the_same_on_any_number_of_threads) {
  const auto sine = [](double t) { return std::sin(9 * t); };
  const Recording recording = recording_of({sine, sine, sine, sine}, 100'001, 0.001, 1e-3);
  const auto fitted = [&](unsigned threads) {
    std::vector<FitKey> keys;
    for (std::size_t sample = 0; sample <= 100'000; sample += 100) keys.push_back(key_at(sample, 4));
    fit_smoothly(recording, keys, {}, {3, 1e-6, false}, threads);
    return keys;
  };
  const auto one = fitted(1), three = fitted(3);
  for (std::size_t key = 0; key < one.size(); ++key) {
    EXPECT_EQ(one[key].position, three[key].position) << key;
    EXPECT_EQ(one[key].slope, three[key].slope) << key;
  }
}

TEST(SmoothFit, keeps_fixed_ends) {
  const Recording recording = recording_of({[](double t) { return t * t; }}, 101, 0.01, 1e-3);
  std::vector<FitKey> keys{key_at(0), key_at(50), key_at(100)};
  keys[0].position = {0.25};
  keys[0].slope = {-1};
  fit_smoothly(recording, keys, {true, false});
  EXPECT_EQ(keys[0].position[0], 0.25);
  EXPECT_EQ(keys[0].slope[0], -1);
}

TEST(SmoothFit, a_corner_has_the_position_of_its_sample) {
  Recording recording = recording_of({[](double t) { return std::sin(9 * t); }}, 101, 0.01, 1e-3);
  recording.ends_at_corner = true;
  std::vector<FitKey> keys{key_at(0), key_at(100)};
  fit_smoothly(recording, keys, {});
  EXPECT_EQ(keys[1].position[0], recording.positions.back());
  EXPECT_NE(keys[0].position[0], recording.positions.front());
}

}  // namespace
}  // namespace tcb
