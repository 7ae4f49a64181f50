// Key times: few keys, within the tolerances at all samples.
#include "fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/recordings.hpp"

namespace tcb {
namespace {

/// The samples of the keys, once they are within the tolerances.
std::vector<std::size_t> samples_of(const Recording& recording, std::vector<std::size_t> fixed = {}) {
  fixed.insert(fixed.begin(), 0);
  fixed.push_back(recording.size() - 1);
  const std::vector<std::size_t> cubics = longest_cubics(recording);
  auto keys = fitting_keys(recording, {cubics, knots_of(recording, cubics.size())}, fixed);
  std::vector<std::size_t> samples;
  for (const FitKey& key : keys) samples.push_back(key.sample);
  EXPECT_TRUE(std::ranges::is_sorted(samples));
  // Each pair of keys alone, as they are.
  for (std::size_t i = 1; i < keys.size(); ++i) {
    std::vector<FitKey> pair{keys[i - 1], keys[i]};
    EXPECT_LE(fit_smoothly(recording, pair, {true, true}, {0, 0})[0], 1 + 1e-9) << i;
  }
  return samples;
}

TEST(KeyTimes, a_line_has_two) {
  EXPECT_EQ(samples_of(recording_of({[](double t) { return 2 * t - 1; }}, 500, 0.1, 1e-6)),
            (std::vector<std::size_t>{0, 499}));
}

TEST(KeyTimes, a_sine_has_little_more_than_its_pieces) {
  const Recording recording = recording_of({[](double t) { return std::sin(t); }}, 20001, 0.01, 1e-4);
  const std::size_t cubics = longest_cubics(recording).size();
  EXPECT_LE(samples_of(recording).size(), cubics * 8 / 5 + 2);
}

TEST(KeyTimes, fixed_samples_have_keys) {
  const Recording recording = recording_of({[](double t) { return std::sin(t); }}, 1001, 0.01, 1e-2);
  const auto samples = samples_of(recording, {17, 18, 500});
  for (const std::size_t fixed : {17U, 18U, 500U}) EXPECT_EQ(std::ranges::count(samples, fixed), 1) << fixed;
}

TEST(KeyTimes, cubics_are_found_within_any_tolerance) {
  const auto rest_and_ramp = [](double t) {  // speed 0, 1, 0 with ramps of a second between
    const double phase = std::fmod(t, 4.0), whole = std::floor(t / 4) * 2;
    if (phase < 1) return whole + phase * phase / 2;
    if (phase < 2) return whole + phase - 0.5;
    if (phase < 3) return whole + 2 - (3 - phase) * (3 - phase) / 2;
    return whole + 2;
  };
  for (const double tolerance : {1e-2, 1e-4, 1e-8, 1e-11}) {
    const auto samples = samples_of(recording_of({rest_and_ramp}, 2561, 1.0 / 128, tolerance));  // to t = 20
    EXPECT_LE(samples.size(), 21U) << tolerance;                                                 // fewer within 0.01
  }
}

TEST(KeyTimes, every_sample_may_be_needed) {
  const auto zigzag = [](double t) { return std::fmod(t, 2.0) * (1 + t); };
  EXPECT_LE(samples_of(recording_of({zigzag}, 40, 1, 1e-6)).size(), 40U);
}

TEST(KeyTimes, of_long_recordings_are_the_same_on_any_number_of_threads) {
  const auto chirp = [](double t) { return std::sin(t * t / 50); };
  for (const std::size_t size : {90'000U, 160'000U}) {
    const Recording recording = recording_of({chirp}, size, 0.001, 1e-3);
    const FirstTimes times{longest_cubics(recording), {}};
    const auto one = fitting_keys(recording, times, {0, size - 1});
    const auto three = fitting_keys(recording, times, {0, size - 1}, {}, 3);
    ASSERT_EQ(one.size(), three.size());
    EXPECT_LE(one.size(), times.cubics.size() * 2);
    for (std::size_t key = 0; key < one.size(); ++key) {
      EXPECT_EQ(one[key].sample, three[key].sample) << key;
      EXPECT_EQ(one[key].slope, three[key].slope) << key;
    }
  }
}

}  // namespace
}  // namespace tcb
