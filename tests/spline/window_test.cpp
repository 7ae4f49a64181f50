// Windows: tabled values of their segments, and the laws of the splines.
#include "tcb/spline/window.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "example_keys.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb::spline {
namespace {

TEST(Segments, default_rules_have_the_tabled_values) {
  const auto curve = segments<double>({keys_of(example)}, {});
  const std::array<std::array<double, 2>, 6> table{
      {{.25, .53633984375}, {.5, 1.28490625}, {2, .51171875}, {3.5, .673953125}, {5, 2.1195}, {5.5, 1.4889375}}};
  for (const auto& [t, x] : table) EXPECT_NEAR(at(curve, t), x, 1e-15 * 4) << t;
}

TEST(Segments, interior_tangents_of_velocity_has_the_tabled_values) {
  const auto keys = keys_of(example);
  const Window<double> window{keys};
  const CurveRules<double> rules;
  const Tangents<double> slopes(window, rules);
  const std::array incoming{-1.03125, 1.21875, 1.624}, outgoing{1.3125, -.984375, -.448};
  for (std::size_t i = 0; i < incoming.size(); ++i) {
    EXPECT_NEAR(slopes.incoming(i + 1)[0].hi, incoming[i], 1e-15);
    EXPECT_NEAR(slopes.outgoing(i + 1)[0].hi, outgoing[i], 1e-15);
  }
}

TEST(Segments, passes_through_every_key_bit_for_bit) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    const auto keys = random_keys(random, 8, 3);
    const auto curve = segments<double>({keys}, {});
    for (std::size_t i = 0; i < keys.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(at(curve, keys.times[i].hi, c), keys.position(i)[c]);
    }
  }
}

/// A channel of keys alone, with its own tension, continuity and bias.
Keys<double> channel_of(const Keys<double>& keys, std::size_t channel) {
  Keys<double> one{1, keys.times, {}, {}, {}, keys.eases};
  for (std::size_t key = 0; key < keys.size(); ++key) {
    one.positions.push_back(keys.position(key)[channel]);
    one.tcbs.push_back(keys.tcb(key, channel));
  }
  return one;
}

TEST(Segments, channels_with_tension_of_their_own_are_as_if_alone) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> parameter(-1.5, 1.5);
  for (const PresetRow& preset : presets) {
    for (const std::size_t count : {2U, 3U, 7U}) {
      auto keys = random_keys(random, count, 3);
      keys.tcbs.clear();
      for (std::size_t i = 0; i < 3 * count; ++i) {
        keys.tcbs.push_back({parameter(random), parameter(random), parameter(random)});
      }
      for (const bool closed : {false, true}) {
        const auto build = [&](const Keys<double>& given) {
          const auto rules = rules_of<double>(preset.id);
          return *(
              closed ? Curve<double>::build_closed(given, rules, given.times.back() - given.times[0] + Time<double>(1))
                     : Curve<double>::build(given, rules));
        };
        const auto all = build(keys);
        for (std::size_t channel = 0; channel < 3; ++channel) {
          const auto one = build(channel_of(keys, channel));
          for (std::size_t i = 0; i < all.segment_count(); ++i) {
            const auto a = all.segment(i).cubics[channel], b = one.segment(i).cubics[0];
            ASSERT_TRUE(a.out == b.out && a.in == b.in && a.c == b.c && a.d == b.d && a.p0 == b.p0) << preset.name;
          }
        }
      }
    }
  }
}

TEST(Segments, channels_with_tension_of_their_own_have_these_tangents) {
  // At key 1 with D0 = 2 and D1 = -3, h = 1, 2, T = 1/2 and C = B = 0: (1-T)/2 (D0 + D1/2), and twice that.
  Keys<double> keys{2, {0, 1, 3}, {0, 0, 2, 2, -1, -1}, {{}, {}, {0.5}, {}, {}, {}}, {}, {}};
  const Window<double> window{keys};
  const Tangents<double> slopes(window, {});
  EXPECT_EQ(slopes.incoming(1)[0].hi, 0.125);
  EXPECT_EQ(slopes.outgoing(1)[0].hi, 0.25);
  EXPECT_EQ(slopes.incoming(1)[1].hi, 0.25);
  EXPECT_EQ(slopes.outgoing(1)[1].hi, 0.5);
}

TEST(Segments, given_velocities_are_those_of_the_curve) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const PresetRow& preset : presets) {
    Keys<double> keys{2, {0, 1, 3}, {0, 5, 2, 4, -1, 8}, {{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}, {}, {}};
    const auto plain = segments<double>({keys}, rules_of<double>(preset.id));
    keys.velocities = {{none, 0.25}, {none, none}, {-3, 7}, {none, none}, {0.75, none}, {none, none}};
    keys.given = {true, false};
    const auto curve = segments<double>({keys}, rules_of<double>(preset.id));
    EXPECT_EQ(curve[0][0].out, 0.25) << preset.name;
    EXPECT_EQ(curve[0][0].in, -3);
    EXPECT_EQ(curve[1][0].out, 14);
    EXPECT_EQ(curve[1][0].in, 1.5);
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(curve[i][1].out, plain[i][1].out) << "the other channel has the tangents of the rules";
      EXPECT_EQ(curve[i][1].in, plain[i][1].in);
    }
  }
}

TEST(Segments, given_velocities_make_a_closed_curve) {
  // The piece before the seam ends with the incoming velocity of the last key, the first begins with the first's.
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Keys<double> keys{1, {0, 1, 3}, {0, 2, 0}, {}, {}, {}, {{none, 4}, {5, 6}, {7, none}}, {true}};
  const auto repeated = Curve<double>::build_closed(keys);
  ASSERT_TRUE(repeated) << repeated.error().message();
  EXPECT_EQ(repeated->segment(0).cubics[0].out, 4);
  EXPECT_EQ(repeated->segment(0).cubics[0].in, 5);
  EXPECT_EQ(repeated->segment(1).cubics[0].out, 12);
  EXPECT_EQ(repeated->segment(1).cubics[0].in, 14);
  Keys<double> once{1, {0, 1}, {0, 2}, {}, {}, {}, {{7, 4}, {5, 6}}, {true}};
  const auto same = Curve<double>::build_closed(once, {}, Time<double>(3));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->segment(1).cubics[0].in, 14);
  once.velocities[0].in = none;
  EXPECT_EQ(Curve<double>::build_closed(once, {}, Time<double>(3)).error().code, BuildErrorCode::seam_velocity_missing);
}

TEST(Segments, tension_of_one_stops_at_the_key) {
  auto table = example;
  for (Key& key : table) key[2] = 1;
  const Window<double> window{keys_of(table)};
  const CurveRules<double> rules;
  const Tangents<double> slopes(window, rules);
  for (std::size_t key = 0; key < table.size(); ++key) {
    EXPECT_EQ(slopes.incoming(key)[0].hi, 0);
    EXPECT_EQ(slopes.outgoing(key)[0].hi, 0);
  }
}

TEST(Segments, continuity_of_minus_one_makes_straight_segments_at_constant_speed) {
  const auto curve =
      segments<double>({keys_of({{0, 0, 0, -1, 0}, {1, 8, 0, -1, 0}, {3, -8, 0, -1, 0}, {4, 1, 0, -1, 0}})}, {});
  for (double u = 0; u <= 1; u += 0.125) EXPECT_EQ(at(curve, 1 + 2 * u), 8 - 16 * u);
}

TEST(Segments, reversed_keys_with_opposite_bias_give_the_same_points) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 100; ++round) {
    const auto keys = random_keys(random, 6, 2);
    Keys<double> reversed = keys;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::size_t j = keys.size() - 1 - i;
      reversed.times[i] = -keys.times[j];
      reversed.tcbs[i] = {keys.tcbs[j].tension, keys.tcbs[j].continuity, -keys.tcbs[j].bias};
      for (std::size_t c = 0; c < 2; ++c) reversed.positions[i * 2 + c] = keys.positions[j * 2 + c];
    }
    const auto forth = segments<double>({keys}, {});
    const auto back = segments<double>({reversed}, {});
    for (double f = 0.01; f < 1; f += 0.1) {
      const double t = keys.times[0].hi + f * (keys.times[5].hi - keys.times[0].hi);
      for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(at(forth, t, c), at(back, -t, c), 1e-12);
    }
  }
}

TEST(Segments, affine_maps_of_the_keys_map_the_points) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 100; ++round) {
    const auto keys = random_keys(random, 6, 1);
    auto mapped = keys;
    for (double& x : mapped.positions) x = 3 * x - 7;
    const auto curve = segments<double>({keys}, {});
    const auto image = segments<double>({mapped}, {});
    for (double f = 0.01; f < 1; f += 0.1) {
      const double t = keys.times[0].hi + f * (keys.times[5].hi - keys.times[0].hi);
      EXPECT_NEAR(at(image, t), 3 * at(curve, t) - 7, 1e-11);
    }
  }
}

TEST(Segments, powers_of_two_scale_every_mantissa_exactly) {
  std::mt19937_64 random(4);
  for (int round = 0; round < 100; ++round) {
    const auto keys = random_keys(random, 6, 1);
    auto scaled = keys;
    for (double& x : scaled.positions) x = std::ldexp(x, 40);
    for (auto& t : scaled.times) t = std::ldexp(t.hi, -20);
    const auto curve = segments<double>({keys}, {});
    const auto image = segments<double>({scaled}, {});
    for (double f = 0.01; f < 1; f += 0.1) {
      const double t = keys.times[0].hi + f * (keys.times[5].hi - keys.times[0].hi);
      EXPECT_EQ(at(image, std::ldexp(t, -20)), std::ldexp(at(curve, t), 40));
    }
  }
}

TEST(Segments, a_channel_does_not_depend_on_the_others) {
  std::mt19937_64 random(5);
  const auto keys = random_keys(random, 7, 3);
  auto alone = keys;
  alone.channels = 1;
  alone.positions.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) alone.positions.push_back(keys.position(i)[1]);
  const auto all = segments<double>({keys}, {});
  const auto one = segments<double>({alone}, {});
  for (double f = 0; f < 1; f += 0.01) {
    const double t = keys.times[0].hi + f * (keys.times[6].hi - keys.times[0].hi);
    EXPECT_EQ(at(all, t, 1), at(one, t));
  }
}

}  // namespace
}  // namespace tcb::spline
