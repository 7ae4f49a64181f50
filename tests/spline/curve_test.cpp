// Curve: tabled values and laws of open and closed curves, derivatives, lengths, and no allocation per evaluation.
#include "tcb/spline/curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

#include "example_keys.hpp"
#include "spline/allocations.hpp"

namespace tcb::spline {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

CurveRules<double> rules_named(std::string_view tangents, std::string_view ends) {
  const EndRule end = id_named(end_rules<double>, ends).value();
  return {id_named(tangent_rules<double>, tangents).value(), {end, {}}, {end, {}}, false, {}};
}

double x_at(const Curve<double>& curve, double t) {
  double x = nan;
  curve.position(t, {&x, 1});
  return x;
}

double derivative_at(const Curve<double>& curve, std::size_t order, double t, Side side = Side::right) {
  double x = nan;
  curve.derivative(order, t, {&x, 1}, side);
  return x;
}

TEST(Curve, linear_tangents_make_straight_lines_whatever_the_other_rules_are) {
  CurveRules<double> rules = rules_named("linear", "zero");
  rules.equal_speed = rules.no_overshoot = true;
  const auto curve = Curve<double>::build(keys_of(example), rules);
  const std::array times{.25, .5, 2., 3.5, 5., 5.5};
  const std::array positions{.5, 1., .5, 1., 2., 1.5};  // of t = 0, 1, 3, 4, 6 and P = 0, 2, -1, 3, 1
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(x_at(*curve, times[i]), positions[i]);
  for (const double t : times) EXPECT_EQ(derivative_at(*curve, 2, t), 0);
}

TEST(Curve, open_curves_have_the_tabled_positions) {
  struct Row {
    std::string_view tangents, ends;
    std::array<double, 6> positions;
  };
  const std::array<Row, 14> table{{
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
  for (const Row& row : table) {
    const auto curve = Curve<double>::build(keys_of(example), rules_named(row.tangents, row.ends));
    ASSERT_TRUE(curve);
    constexpr std::array times{.25, .5, 2., 3.5, 5., 5.5};
    std::array<double, 6> found{};
    curve->positions(times, found);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], row.positions[i], 5e-9) << row.tangents << times[i];
  }
}

TEST(Curve, equal_speed_has_the_tabled_positions) {
  auto rules = rules_of<double>(Preset::gte);
  rules.equal_speed = true;
  const auto curve = Curve<double>::build(keys_of(example), rules);
  constexpr std::array<std::array<double, 2>, 6> table{{{.25, .43784765625},
                                                        {.5, 1.17826041667},
                                                        {2, .512331495098},
                                                        {3.5, .85669320967},
                                                        {5, 1.98932575758},
                                                        {5.5, 1.37430965909}}};
  for (const auto& [t, x] : table) EXPECT_NEAR(x_at(*curve, t), x, 5e-12);
}

/// x, an angle and a rotation, with unequal steps and a corner at the inner keys.
Keys<double> mixed() {
  return {6,
          {0, 1, 3, 4},
          {0, 350, 0, 0, 0, 1, 1, 20, 0, 0, .6, .8, 3, 90, 0, .6, 0, .8, 2, 10, 0, 0, 0, 1},
          {{}, {.5, -.5, .25}, {.25, -1, -.5}, {}},
          {},
          {}};
}

TEST(Curve, an_empty_metric_stands_for_the_same_channels_in_speeds_as_in_lengths) {
  CurveRules<double> named;
  named.equal_speed = true;
  named.rotations = {{{2, 3, 4, 5}}};
  named.angles = {{1, true}};
  named.metric = {0};
  CurveRules<double> empty = named, unequal = named;
  empty.metric.clear();
  unequal.equal_speed = false;
  for (const bool closed : {false, true}) {
    const auto build = [&](const CurveRules<double>& rules) {
      return closed ? *Curve<double>::build_closed(mixed(), rules, 6.0) : *Curve<double>::build(mixed(), rules);
    };
    const Curve<double> one = build(named), other = build(empty), without = build(unequal);
    EXPECT_EQ(one.length().value, other.length().value);
    for (const double t : {.5, 1.5, 2.5, 3.5}) {
      std::array<double, 6> x{}, y{};
      one.position(t, x);
      other.position(t, y);
      EXPECT_EQ(x, y);
    }
    EXPECT_NE(x_at(one, 1.5), x_at(without, 1.5));
  }
}

TEST(Curve, equal_speed_has_no_channels_of_turns) {  // and then is over all channels
  Keys<double> keys = mixed();
  keys.channels = 5;
  keys.positions = {350, 0, 0, 0, 1, 20, 0, 0, .6, .8, 90, 0, .6, 0, .8, 10, 0, 0, 0, 1};
  CurveRules<double> rules;
  rules.equal_speed = true;
  rules.rotations = {{{1, 2, 3, 4}}};
  rules.angles = {{0, true}};
  const auto curve = Curve<double>::build(keys, rules);
  ASSERT_TRUE(curve) << curve.error().message();
  for (const double t : {1.0, 3.0}) {  // both tangents of a key have the same speed
    double in = 0, out = 0;
    const Segment<double> before = curve->segment(curve->find_time(t, Side::left)),
                          after = curve->segment(curve->find_time(t));
    for (std::size_t i = 0; i < 5; ++i) {
      in += before.cubics[i].in * before.cubics[i].in;
      out += after.cubics[i].out * after.cubics[i].out;
    }
    EXPECT_NEAR(std::sqrt(in) / (before.end - before.start).hi, std::sqrt(out) / (after.end - after.start).hi, 1e-12);
  }
}

TEST(Curve, closed_curves_have_the_tabled_positions) {
  struct Row {
    std::string_view tangents;
    std::array<double, 5> positions;
  };
  const std::array<Row, 5> table{{
      {"uniform", {1.3336875, .60546875, .43128125, 2.030875, .320625}},
      {"interval", {1.226325, .640625, .620854167, 2.01395238, .36305}},
      {"velocity", {1.17423958, .51171875, .673953125, 2.10525, .3508125}},
      {"finite-difference", {1.12215417, .3828125, .727052083, 2.19654762, .338575}},
      {"interval-c", {1.27884625, .629882812, .552227604, 2.0281881, .34706}},
  }};
  for (const Row& row : table) {
    const auto curve = Curve<double>::build_closed(keys_of(example), rules_named(row.tangents, "half"), 7.5);
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->segment_count(), 5U);
    EXPECT_EQ(curve->end(), 7.5);
    constexpr std::array times{.5, 2., 3.5, 5., 6.75};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(x_at(*curve, times[i]), row.positions[i], 5e-9) << row.tangents;
  }
}

/// Straight segments between keys at t = 0, 1, 2, 4 with a hold from 1 to 2.
Curve<double> with_hold() { return *Curve<double>::build({1, {0, 1, 2, 4}, {0, 3, 3, 7}, {}, {.tension = 1}, {}}); }

TEST(Curve, finds_the_segment_for_a_time) {
  const Curve<double> curve = with_hold();
  for (const Side side : {Side::left, Side::right}) {
    EXPECT_EQ(curve.find_time(-1.0, side), 0U);
    EXPECT_EQ(curve.find_time(0.0, side), 0U);
    EXPECT_EQ(curve.find_time(0.5, side), 0U);
    EXPECT_EQ(curve.find_time(1.0, side), side == Side::left ? 0U : 1U);
    EXPECT_EQ(curve.find_time(3.0, side), 2U);
    EXPECT_EQ(curve.find_time(4.0, side), 2U);
    EXPECT_EQ(curve.find_time(9.0, side), 2U);
  }
}

TEST(Curve, finds_the_first_segment_that_reaches_a_length) {
  const Curve<double> curve = with_hold();
  EXPECT_EQ(curve.find_length(0.0), 0U);
  EXPECT_EQ(curve.find_length(2.0, Side::right), 0U);
  EXPECT_EQ(curve.find_length(3.0), 0U);
  EXPECT_EQ(curve.find_length(3.0, Side::right), 1U) << "the hold begins here, and with it its first key";
  EXPECT_EQ(curve.find_length(3.5, Side::right), 2U);
  EXPECT_EQ(curve.find_length(7.0, Side::right), 2U);
  EXPECT_EQ(curve.find_length(9.0), 2U);
}

TEST(Curve, appended_segments_are_the_curve_that_is_built) {
  std::mt19937_64 random(5);
  const auto keys = random_keys(random, 9, 2);
  const auto whole = Curve<double>::build(keys);
  Curve<double> measured({}), plain({}, false, 8);
  for (std::size_t i = 0; i < 8; ++i) {
    const Segment<double> segment = whole->segment(i);
    Segments<double> one{2, {segment.start, segment.end}, {segment.cubics.begin(), segment.cubics.end()}, {}};
    measured.append(one, lengths_of<double>(one, metric_of<double>({}, 2)));
    plain.append(std::move(one));
  }
  EXPECT_TRUE(measured.is_measured());
  EXPECT_FALSE(plain.is_measured());
  EXPECT_EQ(measured.length().value, whole->length().value);
  EXPECT_EQ(measured.length().error, whole->length().error);
  EXPECT_EQ(plain.segment_count(), 8U);
  EXPECT_EQ(plain.segment(3).length_end.hi, 0);
  for (double t = whole->start() - 1; t < whole->end() + 1; t += 0.3) {
    EXPECT_EQ(x_at(measured, t), x_at(*whole, t));
    EXPECT_EQ(x_at(plain, t), x_at(*whole, t));
    EXPECT_EQ(measured.length_to(t).value, whole->length_to(t).value);
  }
  for (int part = 0; part <= 20; ++part) {
    const double s = whole->length().value * part / 20;
    EXPECT_EQ(measured.at_length(s), whole->at_length(s));
  }
}

TEST(Curve, a_last_key_at_the_first_position_gives_the_period) {
  auto table = example;
  table.push_back({7.5, 0, .2, -.3, .4});
  const auto by_key = Curve<double>::build_closed(keys_of(table));
  const auto by_period = Curve<double>::build_closed(keys_of(example), {}, 7.5);
  ASSERT_TRUE(by_key);
  for (double t = -20; t < 20; t += 0.37) EXPECT_EQ(x_at(*by_key, t), x_at(*by_period, t));
}

TEST(Curve, closed_curves_are_periodic_and_open_curves_keep_their_ends) {
  const auto closed = Curve<double>::build_closed(keys_of(example), {}, 7.5);
  for (double t = 0.25; t < 7.5; t += 0.25) {
    for (const double periods : {-1000.0, -3.0, -1.0, 1.0, 2.0, 4096.0}) {
      EXPECT_EQ(x_at(*closed, t + periods * 7.5), x_at(*closed, t)) << t << " + " << periods;
      EXPECT_EQ(derivative_at(*closed, 1, t + periods * 7.5), derivative_at(*closed, 1, t));
    }
  }
  const auto open = Curve<double>::build(keys_of(example));
  EXPECT_EQ(x_at(*open, -1), 0);
  EXPECT_EQ(x_at(*open, 1e300), 1);
  EXPECT_EQ(x_at(*open, infinite), 1);
}

TEST(Curve, times_that_are_nan_give_nan) {
  const auto open = Curve<double>::build(keys_of(example));
  const auto closed = Curve<double>::build_closed(keys_of(example), {}, 7.5);
  EXPECT_TRUE(std::isnan(x_at(*open, nan)));
  EXPECT_TRUE(std::isnan(x_at(*closed, nan)));
  EXPECT_TRUE(std::isnan(x_at(*closed, infinite)));
  EXPECT_TRUE(std::isnan(derivative_at(*open, 2, nan)));
  EXPECT_TRUE(std::isnan(open->at_length(nan)));
}

TEST(Curve, passes_through_every_key_bit_for_bit) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 50; ++round) {
    const auto keys = random_keys(random, 8, 3);
    const auto open = Curve<double>::build(keys);
    const auto closed = Curve<double>::build_closed(keys, {}, 100.0);
    std::array<double, 3> x{}, y{};
    for (std::size_t i = 0; i < keys.size(); ++i) {
      open->position(keys.times[i], x);
      closed->position(keys.times[i], y);
      for (std::size_t c = 0; c < 3; ++c) ASSERT_TRUE(x[c] == keys.position(i)[c] && y[c] == keys.position(i)[c]);
    }
  }
}

TEST(Curve, tension_of_one_stops_at_the_key) {
  auto table = example;
  for (auto& key : table) key[2] = 1;
  const auto curve = Curve<double>::build(keys_of(table));
  for (const auto& key : table) {
    EXPECT_EQ(derivative_at(*curve, 1, key[0], Side::left), 0);
    EXPECT_EQ(derivative_at(*curve, 1, key[0], Side::right), 0);
  }
}

TEST(Curve, the_laws_of_reversal_and_of_affine_maps_hold) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 50; ++round) {
    const auto keys = random_keys(random, 6, 1);
    auto reversed = keys;
    auto mapped = keys;
    for (std::size_t i = 0; i < 6; ++i) {
      reversed.times[i] = -keys.times[5 - i];
      reversed.tcbs[i] = {keys.tcbs[5 - i].tension, keys.tcbs[5 - i].continuity, -keys.tcbs[5 - i].bias};
      reversed.positions[i] = keys.positions[5 - i];
      mapped.positions[i] = 3 * keys.positions[i] - 7;
    }
    const auto curve = Curve<double>::build(keys), back = Curve<double>::build(reversed);
    const auto image = Curve<double>::build(mapped);
    for (double f = 0.01; f < 1; f += 0.1) {
      const double t = curve->start() + f * (curve->end() - curve->start());
      EXPECT_NEAR(x_at(*curve, t), x_at(*back, -t), 1e-12);
      EXPECT_NEAR(x_at(*image, t), 3 * x_at(*curve, t) - 7, 1e-11);
    }
  }
}

TEST(Curve, derivatives_agree_with_differences_also_where_keys_have_ease) {
  auto keys = keys_of(example);
  for (const bool ease : {false, true}) {
    if (ease) keys.eases.assign(keys.size(), {0.35, 0.3});
    const auto curve = Curve<double>::build(keys);
    const double h = 1e-5;
    for (const double t : {0.1, 0.5, 1.3, 2.1, 2.9, 3.7, 4.2, 5.0, 5.9}) {
      for (std::size_t order = 0; order < 7; ++order) {
        const double slope = (derivative_at(*curve, order, t + h) - derivative_at(*curve, order, t - h)) / (2 * h);
        EXPECT_NEAR(derivative_at(*curve, order + 1, t), slope, 1e-4 * (1 + std::abs(slope))) << order << " at " << t;
      }
    }
    EXPECT_EQ(derivative_at(*curve, ease ? 7 : 4, 0.5), 0);
  }
}

TEST(Curve, a_corner_has_a_derivative_on_each_side) {
  const auto curve = Curve<double>::build(keys_of(example));
  EXPECT_NEAR(derivative_at(*curve, 1, 1, Side::left), -1.03125, 1e-15);
  EXPECT_NEAR(derivative_at(*curve, 1, 1, Side::right), 1.3125 / 2, 1e-15);
  EXPECT_EQ(derivative_at(*curve, 1, 6, Side::right), derivative_at(*curve, 1, 6, Side::left));
  const auto closed = Curve<double>::build_closed(keys_of(example), {}, 7.5);
  EXPECT_NE(derivative_at(*closed, 1, 0, Side::left), derivative_at(*closed, 1, 0, Side::right));
  EXPECT_EQ(derivative_at(*closed, 1, 0, Side::left), derivative_at(*closed, 1, 7.5, Side::left));
}

TEST(Curve, one_key_is_a_constant) {
  const auto curve = Curve<double>::build(keys_of({{2, 5, 0, 0, 0}}));
  ASSERT_TRUE(curve);
  EXPECT_EQ(x_at(*curve, 2), 5);
  EXPECT_EQ(x_at(*curve, -3), 5);
  EXPECT_EQ(derivative_at(*curve, 1, 2), 0);
  EXPECT_EQ(curve->length().value, 0);
  EXPECT_EQ(curve->at_length(1), 2);
}

TEST(Curve, segments_have_the_cubics_between_keys) {
  const auto curve = Curve<double>::build(keys_of(example));
  ASSERT_EQ(curve->segment_count(), 4U);
  const Segment<double> second = curve->segment(1);
  EXPECT_EQ(second.start.hi, 1);
  EXPECT_EQ(second.end.hi, 3);
  EXPECT_EQ(second.cubics[0].p0, 2);
  EXPECT_EQ(second.cubics[0].p1, -1);
  EXPECT_TRUE(second.warp.is_identity());
}

TEST(Curve, shorter_spans_take_the_first_channels) {
  std::mt19937_64 random(3);
  const auto curve = Curve<double>::build(random_keys(random, 5, 4));
  std::array<double, 4> all{};
  std::array<double, 2> some{};
  curve->velocity(curve->start() + 1, all);
  curve->velocity(curve->start() + 1, some);
  EXPECT_EQ(some, (std::array{all[0], all[1]}));
  curve->positions(std::array{0.0, 1.0}, some);  // has no room for a time
  EXPECT_EQ(some, (std::array{all[0], all[1]}));
}

TEST(Curve, at_length_and_length_to_are_inverse) {
  std::mt19937_64 random(4);
  for (const bool closed : {false, true}) {
    auto keys = random_keys(random, 9, 3);
    keys.eases.assign(keys.size(), {0.2, 0.1});
    const auto curve = closed ? Curve<double>::build_closed(keys, {}, 50.0) : Curve<double>::build(keys);
    const auto [length, error] = curve->length();
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1e-12 * length);
    std::array<double, 3> at{}, by_time{};
    for (double s = 0; s <= length; s += length / 64) {
      const double t = curve->at_length(s, at);
      EXPECT_NEAR(curve->length_to(t).value, s, 1e-13 * length);
      curve->position(t, by_time);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(at[i], by_time[i], 1e-12);
    }
    EXPECT_EQ(curve->at_length(0), curve->start());
    EXPECT_EQ(curve->at_length(2 * length), curve->end());  // also if it is closed
    EXPECT_EQ(curve->at_length(-length), curve->start());
    EXPECT_EQ(curve->length_to(curve->start()).value, 0);
    EXPECT_EQ(curve->length_to(curve->end() + 1).value, length);
  }
}

TEST(Curve, a_length_is_first_reached_before_a_hold) {
  const auto curve =
      Curve<double>::build(keys_of({{0, 0, 0, -1, 0}, {1, 3, 1, -1, 0}, {5, 3, 1, -1, 0}, {6, 4, 0, -1, 0}}));
  EXPECT_EQ(curve->at_length(3), 1);
  EXPECT_EQ(curve->length_to(4).value, 3);
  EXPECT_EQ(curve->length().value, 4);
}

TEST(Curve, lengths_are_those_of_the_metric_channels) {
  Keys<double> keys;
  keys.channels = 3;
  keys.times = {0.0, 1.0};
  keys.positions = {0, 100, 0, 3, -100, 4};
  CurveRules<double> rules;
  rules.metric = {0, 2};
  EXPECT_EQ(Curve<double>::build(keys, rules)->length().value, Curve<double>::build(keys, rules)->length_to(1).value);
  EXPECT_NEAR(Curve<double>::build(keys, rules)->length().value, 5, 1e-14);
}

/// Turns by a quarter about z and, at the last key, back to the first rotation with the other sign.
Keys<double> turning() {
  const double half = std::sqrt(0.5);
  return {5, {0, 1, 2}, {0, 0, 0, 0, 1, 1, 0, 0, half, half, 0, 0, 0, 0, -1}, {}, {}, {}};
}

TEST(Curve, rotations_pass_through_their_keys_and_turn_with_an_angular_velocity) {
  CurveRules<double> rules;
  rules.rotations = {{{1, 2, 3, 4}}};
  rules.rotation_rules.curve = RotationCurve::slerp;
  const auto curve = Curve<double>::build(turning(), rules);
  ASSERT_TRUE(curve) << curve.error().message();
  EXPECT_NEAR(curve->rotation(1.0).z, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(curve->rotation(0.5).z, std::sin(std::acos(-1) / 8), 1e-15);
  EXPECT_NEAR(curve->angular_velocity(0.5)[2], std::acos(-1) / 2, 1e-14);
  std::array<double, 5> x{}, v{};
  curve->position(0.5, x);
  EXPECT_EQ(x[3], curve->rotation(0.5).z);
  curve->velocity(0.5, v);
  EXPECT_NEAR(v[3], x[4] * std::acos(-1) / 4, 1e-14);
  curve->derivative(2, 0.5, v);
  EXPECT_TRUE(std::isfinite(v[0]));
  for (std::size_t i = 1; i < 5; ++i) EXPECT_TRUE(std::isnan(v[i]));
  EXPECT_EQ(curve->length().value, 2);  // of the first channel alone
}

TEST(Curve, a_closed_curve_of_rotations_ends_with_either_sign) {
  CurveRules<double> rules;
  rules.rotations = {{{1, 2, 3, 4}}};
  Keys<double> keys = turning();
  keys.positions[10] = 0;
  const auto curve = Curve<double>::build_closed(keys, rules);
  ASSERT_TRUE(curve) << curve.error().message();
  EXPECT_EQ(curve->segment_count(), 2U);
  EXPECT_EQ(curve->end(), 2);
  EXPECT_NEAR(std::abs(curve->rotation(1.9999999).w), 1, 1e-6);
}

TEST(Curve, angles_turn_the_shorter_way_and_stay_within_a_turn) {
  CurveRules<double> rules;
  rules.angles = {{0, true}};
  const auto curve = Curve<double>::build({1, {0, 1}, {350, 10}, {}, {}, {}}, rules);
  ASSERT_TRUE(curve);
  EXPECT_NEAR(x_at(*curve, 0.5), 0, 1e-12);
  EXPECT_EQ(x_at(*curve, 1), 10);
  const auto back = Curve<double>::build({1, {0, .01}, {10, 350}, {}, {}, {}}, rules);
  // Straight: everywhere dX/du is the chord -20. It is not wrapped to a turn.
  EXPECT_NEAR(derivative_at(*back, 1, .005), -2000, 1e-9);
}

TEST(Curve, channels_run_through_the_keys_that_have_a_position_in_them) {
  const auto curve = Curve<double>::build({2, {0, 1, 3, 4}, {0, 5, nan, 6, 7, 8, 9, 9}, {}, {}, {}});
  const auto alone = Curve<double>::build({1, {0, 3, 4}, {0, 7, 9}, {}, {}, {}});
  ASSERT_TRUE(curve && alone);
  for (const double t : {0.5, 1.0, 2.5, 3.5}) EXPECT_NEAR(x_at(*curve, t), x_at(*alone, t), 1e-14);
}

TEST(Curve, no_evaluation_allocates_memory) {
  std::mt19937_64 random(5);
  auto keys = random_keys(random, 40, 7);
  keys.eases.assign(keys.size(), {0.2, 0.3});
  const auto open = Curve<double>::build(keys), closed = Curve<double>::build_closed(keys, {}, 400.0);
  std::array<double, 7> x{};
  std::array<double, 70> rows{};
  const std::array times{0., 1., 2., 3., 4., 5., 6., 7., 8., 9.};
  const double length = open->length().value;
  const std::size_t before = allocations;
  for (const auto* curve : {&*open, &*closed}) {
    for (double t = -50; t < 500; t += 0.7) {
      curve->position(t, x);
      curve->velocity(t, x, Side::left);
      for (std::size_t order = 0; order < 8; ++order) curve->derivative(order, t, x);
      (void)curve->length_to(t);
      (void)curve->at_length((t + 50) / 550 * length, x);
    }
    curve->positions(times, rows);
    for (std::size_t i = 0; i < curve->segment_count(); ++i) (void)curve->segment(i);
    (void)curve->length();
  }
  EXPECT_EQ(allocations - before, 0U);
}

TEST(Curve, times_beyond_2_to_the_53_stay_exact) {
  auto keys = keys_of(example);
  const DoubleDouble epoch(0x1p60);
  for (auto& t : keys.times) t = t + epoch;
  const auto far = Curve<double>::build(keys), near = Curve<double>::build(keys_of(example));
  for (double t = 0; t < 6; t += 0.25) {
    double x = nan;
    far->position(epoch + DoubleDouble(t), {&x, 1});
    EXPECT_EQ(x, x_at(*near, t));
  }
}

TEST(Curve, straight_motion_at_constant_speed_stays_straight) {
  using Rational =
      boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
  const auto line = [](const Rational& t) { return Rational(3 * t - Rational(2, 7)); };
  for (const std::size_t size : {2U, 3U, 4U}) {
    Keys<Rational> keys;
    keys.channels = 1;
    keys.times = {Rational(0), Rational(1, 10), Rational(7, 10), Rational(3)};
    keys.times.resize(size);
    for (const auto& t : keys.times) keys.positions.push_back(line(t));
    const auto curve = Curve<Rational>::build(keys);
    ASSERT_TRUE(curve);
    for (int i = 0; i <= 20; ++i) {
      const Rational t = keys.times.back() * i / 20;
      Rational x;
      curve->position(t, {&x, 1});
      EXPECT_EQ(x, line(t)) << size << " keys, at " << t;
    }
  }
}

TEST(Curve, takes_scalars_with_more_digits_and_exact_ones) {
  using Extended = boost::multiprecision::cpp_bin_float_50;
  using Rational =
      boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
  const auto keys_in = [](auto scalar) {
    using S = decltype(scalar);
    Keys<S> keys;
    keys.channels = 1;
    for (const auto& [t, x, tension, continuity, bias] : example) {
      keys.times.emplace_back(t);
      keys.positions.emplace_back(x);
      keys.tcbs.push_back({S(tension), S(continuity), S(bias)});
    }
    return keys;
  };
  const auto extended = Curve<Extended>::build(keys_in(Extended()));
  const auto exact = Curve<Rational>::build_closed(keys_in(Rational()), {}, Rational(15) / 2);
  ASSERT_TRUE(extended && exact);
  Extended x;
  extended->position(Extended(2), {&x, 1});
  EXPECT_NEAR(static_cast<double>(x), .51171875, 1e-16);
  EXPECT_NEAR(static_cast<double>(extended->length_to(extended->at_length(Extended(3))).value), 3, 1e-16);
  Rational q;
  exact->position(Rational(2) + Rational(75), {&q, 1});
  EXPECT_NEAR(static_cast<double>(q), .51171875, 1e-16);
  const auto rootless = Curve<Rational>::build(keys_in(Rational()), {.equal_speed = true});
  ASSERT_FALSE(rootless);
  EXPECT_EQ(rootless.error().code, BuildErrorCode::scalar_without_roots);
}

}  // namespace
}  // namespace tcb::spline
