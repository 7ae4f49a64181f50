// Every tangent rule and end rule against the tabled values of one small example.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "tcb/spline/rules.hpp"
#include "tcb/spline/window_segments.hpp"

namespace tcb::spline {
namespace {

Keys<double> five_keys() {
  Keys<double> keys;
  keys.channels = 1;
  keys.times = {0.0, 1.0, 3.0, 4.0, 6.0};
  keys.positions = {0, 2, -1, 3, 1};
  keys.tcbs = {{.2, -.3, .4}, {0, .5, -.25}, {-.5, .25, .5}, {.3, -.6, -.2}, {.1, .4, .3}};
  return keys;
}

CurveRules<double> rules(std::string_view tangents, std::string_view ends) {
  const EndRule end = id_named(end_rules<double>, ends).value();
  return {id_named(tangent_rules<double>, tangents).value(), {end, {}}, {end, {}}, false, {}};
}

double rule_at(const Segments<double>& curve, double t) {
  std::size_t i = 0;
  while (i + 1 < curve.size() && curve.times[i + 1].hi <= t) ++i;
  return position(curve[i][0], TimeMap<double>(curve.times[i], curve.times[i + 1])({t}));
}

struct TabledRule {
  std::string_view tangents, ends;
  std::array<double, 6> positions;
};

TEST(Rules, give_the_tabled_positions) {
  const std::array<TabledRule, 14> table{{
      {"uniform", "half", {.514507812, 1.3826875, .60546875, .43128125, 1.97575, 1.36921875}},
      {"interval", "one-sided", {.564171875, 1.359125, .640625, .620854167, 2.02616667, 1.4539375}},
      {"interval", "mirror", {.586671875, 1.379125, .640625, .620854167, 2.04866667, 1.47925}},
      {"interval", "zero", {.388671875, 1.203125, .640625, .620854167, 1.85066667, 1.2565}},
      {"interval", "natural", {.924804688, 1.6796875, .640625, .620854167, 2.151, 1.594375}},
      {"velocity", "half", {.44858984375, 1.20690625, .51171875, .673953125, 2.03175, 1.39021875}},
      {"velocity", "one-sided", {.536339844, 1.28490625, .51171875, .673953125, 2.1195, 1.4889375}},
      {"interval-c", "chord", {.688964844, 1.50390625, .629882812, .552227604, 2.12306667, 1.54615}},
      {"interval-c", "mirror", {.605714844, 1.42990625, .629882812, .552227604, 2.07106667, 1.48765}},
      {"interval-c", "natural-tension", {.859472656, 1.65546875, .629882812, .552227604, 2.15344667, 1.5803275}},
      {"interval-c", "cry", {1.08798828, 1.85859375, .629882812, .552227604, 2.03920667, 1.4518075}},
      {"finite-difference", "natural", {.785644531, 1.45703125, .3828125, .727052083, 2.431, 1.769375}},
      {"synfig", "chord", {.662304688, 1.4328125, .658203125, .65876875, 2.082, 1.53075}},
      {"kb1984", "mirror", {.66284375, 1.58225, .5703125, .241708333, 2.12333333, 1.50725}},
  }};
  for (const TabledRule& row : table) {
    const auto curve = segments<double>({five_keys()}, rules(row.tangents, row.ends));
    for (std::size_t i = 0; i < 6; ++i) {
      constexpr std::array times{.25, .5, 2., 3.5, 5., 5.5};
      EXPECT_NEAR(rule_at(curve, times[i]), row.positions[i], 5e-9)
          << row.tangents << " " << row.ends << " " << times[i];
    }
  }
}

TEST(Rules, give_the_tabled_inner_tangents) {
  struct Slopes {
    std::string_view rule;
    std::array<double, 3> in, out;
  };
  const std::array<Slopes, 4> table{{
      {"interval", {-1.625, -.875, .970666667}, {.25, -2.0625, -1.19466667}},
      {"velocity", {-1.03125, 1.21875, 1.624}, {1.3125, -.984375, -.448}},
      {"finite-difference", {-.4375, 3.3125, 2.27733333}, {2.375, .09375, .298666667}},
      {"uniform", {-2.4375, -.65625, 1.456}, {.1875, -3.09375, -.896}},
  }};
  for (const Slopes& row : table) {
    const auto chosen = rules(row.rule, "half");
    const Window<double> window{five_keys()};
    const Tangents<double> tangents(window, chosen);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(tangents.incoming(i + 1)[0].hi, row.in[i], 5e-9) << row.rule;
      EXPECT_NEAR(tangents.outgoing(i + 1)[0].hi, row.out[i], 5e-9) << row.rule;
    }
  }
}

TEST(Rules, equal_speed_gives_the_tabled_positions) {
  auto chosen = rules("velocity", "half");
  chosen.equal_speed = true;
  const auto curve = segments<double>({five_keys()}, chosen);
  constexpr std::array<std::array<double, 2>, 6> table{{{.25, .43784765625},
                                                        {.5, 1.17826041667},
                                                        {2, .512331495098},
                                                        {3.5, .85669320967},
                                                        {5, 1.98932575758},
                                                        {5.5, 1.37430965909}}};
  for (const auto& [t, x] : table) EXPECT_NEAR(rule_at(curve, t), x, 5e-12);
}

TEST(Rules, equal_speed_measures_the_metric_channels_and_scales_all) {
  Keys<double> keys;
  keys.channels = 2;
  keys.times = {0.0, 1.0, 2.0};
  keys.positions = {0, 0, 1, 5, 4, 6};
  keys.common_tcb = {0, 0.5, 0};
  auto chosen = rules("velocity", "half");
  chosen.equal_speed = true;
  chosen.metric = {0};
  const Window<double> window{keys};
  const Tangents<double> equal(window, chosen);
  // D0 = (1, 5), D1 = (3, 1): in = (.5 D0 + 1.5 D1)/2 = (2.5, 2), out = (1.5 D0 + .5 D1)/2 = (1.5, 4).
  // Over the first channel both speeds become 2 * 2.5 * 1.5 / 4 = 1.875.
  EXPECT_DOUBLE_EQ(equal.incoming(1)[0].hi, 1.875);
  EXPECT_DOUBLE_EQ(equal.outgoing(1)[0].hi, 1.875);
  EXPECT_DOUBLE_EQ(equal.incoming(1)[1].hi, 1.5);
  EXPECT_DOUBLE_EQ(equal.outgoing(1)[1].hi, 5);
}

TEST(Rules, all_tangent_rules_but_linear_agree_on_equal_steps) {
  auto keys = five_keys();
  keys.times = {0.0, 0.5, 1.0, 1.5, 2.0};
  const auto uniform = rules("uniform", "half");
  const Window<double> window{keys};
  const Tangents<double> expected(window, uniform);
  for (const auto& rule : tangent_rules<double>) {
    if (rule.id == TangentRule::linear) continue;
    const auto chosen = rules(rule.name, "half");
    const Tangents<double> tangents(window, chosen);
    for (std::size_t key = 1; key < 4; ++key) {
      EXPECT_NEAR(tangents.incoming(key)[0].hi, expected.incoming(key)[0].hi, 1e-15) << rule.name;
      EXPECT_NEAR(tangents.outgoing(key)[0].hi, expected.outgoing(key)[0].hi, 1e-15) << rule.name;
    }
  }
}

TEST(Rules, without_continuity_some_rules_have_one_velocity_at_a_key) {
  auto keys = five_keys();
  for (auto& tcb : keys.tcbs) tcb.continuity = 0;
  const Window<double> window{keys};
  for (const std::string_view name : {"interval", "interval-c", "velocity", "finite-difference"}) {
    const auto chosen = rules(name, "half");
    const Tangents<double> tangents(window, chosen);
    for (std::size_t key = 1; key < 4; ++key) {
      const auto h0 = keys.times[key] - keys.times[key - 1];
      const auto h1 = keys.times[key + 1] - keys.times[key];
      EXPECT_NEAR((tangents.incoming(key)[0] / h0).hi, (tangents.outgoing(key)[0] / h1).hi, 1e-15) << name;
    }
  }
}

TEST(Rules, two_keys_follow_the_formulas_but_for_natural_ends) {
  Keys<double> keys;
  keys.channels = 1;
  keys.times = {0.0, 2.0};
  keys.positions = {1, 5};
  keys.tcbs = {{.5, .25, .25}, {.25, -.5, .5}};
  struct Expected {
    std::string_view rule;
    double out, in;
  };
  // D = 4; b = .5 * .75 * .75, a = .5 * 1.25 * 1.25; c = .75 * 1.5 * 1.5, d = .75 * .5 * .5.
  const std::array<Expected, 8> table{{{"half", .5625, 3.375},
                                       {"one-sided", 1.125, 6.75},
                                       {"mirror", 2.125, 3.75},
                                       {"chord", 4, 4},
                                       {"zero", 0, 0},
                                       {"natural", 4, 4},
                                       {"natural-tension", 2, 3},
                                       {"cry", 2, 3}}};
  const Window<double> window{keys};
  for (const Expected& row : table) {
    const auto chosen = rules("velocity", row.rule);
    const Tangents<double> tangents(window, chosen);
    EXPECT_EQ(tangents.outgoing(0)[0].hi, row.out) << row.rule;
    EXPECT_EQ(tangents.incoming(1)[0].hi, row.in) << row.rule;
  }
}

TEST(Rules, natural_ends_have_zero_acceleration) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-100, 100), step(0.01, 3), parameter(-1.5, 1.5);
  for (const auto& rule : tangent_rules<double>) {
    for (int i = 0; i < 200; ++i) {
      Keys<double> keys;
      keys.channels = 1;
      double t = place(random);
      for (int key = 0; key < 4; ++key, t += step(random)) {
        keys.times.emplace_back(t);
        keys.positions.push_back(place(random));
        keys.tcbs.push_back({parameter(random), parameter(random), parameter(random)});
      }
      const auto curve = segments<double>({keys}, rules(rule.name, "natural"));
      ASSERT_EQ(curve[0][0].c, 0) << rule.name;
      ASSERT_EQ(curve[2][0].e, 0) << rule.name;
    }
  }
}

TEST(Rules, given_velocities_are_per_unit_of_time) {
  auto chosen = rules("velocity", "velocity");
  chosen.start.velocity = {3};
  chosen.end.velocity = {-1};
  const Window<double> window{five_keys()};
  const Tangents<double> tangents(window, chosen);
  EXPECT_EQ(tangents.outgoing(0)[0].hi, 3);
  EXPECT_EQ(tangents.incoming(4)[0].hi, -2);
}

TEST(Rules, lightwave_ends_are_one_sided_but_for_a_3600th) {
  const auto chosen = rules("interval", "lightwave");
  const Window<double> window{five_keys()};
  const Tangents<double> tangents(window, chosen);
  // b D = .8 * 1.3 * .6 * 2 = 1.248 over h/(h + 1/3600) = 3600/3601; c D = .9 * .6 * 1.3 * -2 over 7200/7201.
  EXPECT_NEAR(tangents.outgoing(0)[0].hi, 1.248 * 3600 / 3601, 1e-15);
  EXPECT_NEAR(tangents.incoming(4)[0].hi, -1.404 * 7200 / 7201, 1e-15);
}

TEST(Rules, names_and_ids_correspond) {
  for (const auto& row : tangent_rules<double>) EXPECT_EQ(id_named(tangent_rules<double>, name_of(row.id)), row.id);
  for (const auto& row : end_rules<double>) EXPECT_EQ(id_named(end_rules<double>, name_of(row.id)), row.id);
  for (const auto& row : presets) EXPECT_EQ(id_named(presets, name_of(row.id)), row.id);
  EXPECT_EQ(id_named(presets, "maya"), std::nullopt);
  EXPECT_EQ(name_of(Preset::max3ds), "3dsmax");
}

TEST(Rules, the_default_preset_has_the_default_rules) {
  const CurveRules<double> rules;
  EXPECT_EQ(row_of(Preset::tcb).tangents, rules.tangents);
  EXPECT_EQ(row_of(Preset::tcb).ends, rules.start.rule);
  EXPECT_EQ(name_of(rules.start.rule), "one-sided");
}

}  // namespace
}  // namespace tcb::spline
