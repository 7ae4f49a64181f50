// Key numbers: tension, continuity and bias give the slopes that they are made from, by the table of rules.
#include "fit/fit.hpp"

#include <gtest/gtest.h>

#include <random>

#include "fit/recordings.hpp"
#include "tcb/spline/window_segments.hpp"

namespace tcb {
namespace {

/// Keys of one channel at uneven times.
std::vector<CornerKey> random_keys(std::mt19937_64& random, const Recording& recording, bool corners) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  std::vector<CornerKey> keys;
  for (std::size_t sample = 0; sample < recording.size(); sample += 1 + random() % 5) {
    const double slope = uniform(random);
    keys.push_back({sample, {uniform(random)}, {slope}, {corners ? uniform(random) : slope}});
  }
  return keys;
}

TEST(KeyNumbers, give_the_slopes_by_the_default_rules) {
  std::mt19937_64 random(3);
  const Recording recording = recording_of({[](double) { return 0.0; }}, 60, 0.25, 1e-3);
  for (const bool corners : {false, true}) {
    for (int i = 0; i < 200; ++i) {
      const auto keys = random_keys(random, recording, corners);
      const spline::Window<double> window{numbered_keys(keys, recording, times_of(recording), {})};
      const spline::CurveRules<double> rules;
      const spline::Tangents<double> tangents(window, rules);
      for (std::size_t key = 0; key < keys.size(); ++key) {
        EXPECT_NEAR(window.keys.position(key)[0], keys[key].position[0], 1e-6);
        const auto duration = [&](std::size_t from) {
          return recording.times[keys[from + 1].sample] - recording.times[keys[from].sample];
        };
        const double slopes_step = 1e-4;
        if (key > 0) {
          EXPECT_NEAR(tangents.incoming(key)[0].hi / duration(key - 1), keys[key].incoming[0], slopes_step);
        }
        if (key + 1 < keys.size()) {
          EXPECT_NEAR(tangents.outgoing(key)[0].hi / duration(key), keys[key].outgoing[0], slopes_step);
        }
      }
    }
  }
}

TEST(KeyNumbers, are_short_decimals) {
  const Recording recording = recording_of({[](double) { return 0.0; }}, 3, 1, 0.5);
  const std::vector<CornerKey> keys{{0, {0.123456789}, {1}, {1}}, {2, {2.1234567}, {1}, {1}}};
  const Keys numbered = numbered_keys(keys, recording, times_of(recording), {});
  EXPECT_EQ(numbered.positions, (std::vector<double>{0.1235, 2.1235}));
  EXPECT_EQ(numbered.tcbs[0].tension, 0) << "the slope is that of the chord";
  const Keys hermite = numbered_keys(keys, recording, times_of(recording), {.keys = FitKeys::hermite});
  EXPECT_EQ(hermite.velocities[1].in, 1);
  EXPECT_TRUE(hermite.given[0]);
  EXPECT_TRUE(hermite.tcbs.empty());
}

TEST(KeyNumbers, a_slope_between_repeated_positions_becomes_0) {
  const Recording recording = recording_of({[](double) { return 0.0; }}, 3, 1, 0.5);
  const std::vector<CornerKey> keys{{0, {1}, {9}, {9}}, {1, {1}, {9}, {9}}, {2, {1}, {9}, {9}}};
  for (const auto& [tension, continuity, bias] : numbered_keys(keys, recording, times_of(recording), {}).tcbs) {
    EXPECT_EQ(tension, 1);
    EXPECT_EQ(continuity, 0);
    EXPECT_EQ(bias, 0);
  }
}

}  // namespace
}  // namespace tcb
