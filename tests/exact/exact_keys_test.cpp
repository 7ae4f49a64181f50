// Exact keys: numbers are doubles or the decimals as written; times by distance; what is certain about channels.
#include "exact/exact_keys.hpp"

#include <gtest/gtest.h>

#include "exact/exact_curve.hpp"
#include "exact/float_scalar.hpp"

namespace tcb {
namespace {

/// Keys of two channels, (0, 0.1), (3, 0.1), (3, 4.1), with their decimals.
KeyBlock block() {
  KeyBlock result;
  result.keys.channels = 2;
  result.keys.times = {0.0, 0.1, 0.2};
  result.keys.positions = {0, 0.1, 3, 0.1, 3, 4.1};
  result.text_positions.lines = {1, 2, 3};
  for (const char* time : {"0", "0.1", "0.2"}) {
    for (const char* text : {time, "", "", "", "", "", "", ""}) result.decimals.add(text);
  }
  return result;
}

TEST(ExactKeys, a_number_is_its_double_or_its_decimal) {
  EXPECT_EQ(exact_number(0.1, true), Rational(1, 10));
  EXPECT_EQ(exact_number(0.1, false), Rational(0.1));
  for (const bool decimal : {true, false}) {
    ExactKeys keys(decimal);
    keys.add(block());
    const ExactCurve curve = keys.curve(3, {}, std::nullopt);
    EXPECT_EQ(curve.keys.times[1], exact_number(0.1, decimal));
    EXPECT_TRUE(curve.is_rational());
  }
}

TEST(ExactKeys, distances_make_times) {
  ExactKeys keys(false);
  KeyBlock own = block();
  keys.add(own);
  keys.set_times(own, 1, {});
  EXPECT_EQ(own.keys.times[1].hi, 3);
  EXPECT_EQ(own.keys.times[2].hi, 7);
  EXPECT_EQ(keys.time_back(1, {}).hi, 12);
}

TEST(ExactKeys, channels_are_constant_or_zero_only_if_all_keys_are) {
  ExactKeys keys(true);
  keys.add(block());
  const ChannelFacts two = channel_facts(keys.curve(2, {}, std::nullopt));
  EXPECT_EQ(two.constant, (std::vector<bool>{false, true}));
  EXPECT_EQ(two.zero, (std::vector<bool>{false, false}));
  EXPECT_EQ(two.cycle, (std::vector<Rational>{3, 0}));
}

TEST(ExactKeys, the_curve_of_all_scalars_has_the_same_segments) {
  ExactKeys keys(false);
  keys.add(block());
  const ExactCurve curve = keys.curve(3, {}, std::nullopt);
  const auto exact = curve_at<Rational>(curve)->segments(0, 2);
  const auto rough = curve_at<spline::DoubleDouble>(curve)->segments(0, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    const double expected = nearest_double(exact[i / 2][i % 2].out);
    EXPECT_EQ(rough[i / 2][i % 2].out.hi, expected);
  }
}

TEST(ExactKeys, rotations_in_other_forms_are_converted_at_each_scalar) {
  KeyBlock keys_about_x;  // 60 degrees twice, each after the key before; the second quaternion has the other sign
  RotationColumns columns;
  columns.channels = {0, 1, 2, 3};
  const spline::RotationNotation notation{spline::RotationForm::axis_angle, {}, true, true};
  keys_about_x.keys.channels = 4;
  keys_about_x.keys.times = {0.0, 1.0};
  keys_about_x.keys.positions = {0.5, 0, 0, 0.866, -0.866, 0, 0, -0.5};
  keys_about_x.rotations.numbers = {{2, 0, 0, 60}, {2, 0, 0, 60}};
  keys_about_x.text_positions.lines = {1, 2};
  ExactKeys keys(false, {{columns, notation, true, false}});
  keys.add(keys_about_x);
  const auto curve = curve_at<ShortFloat>(keys.curve(2, {}, std::nullopt))->segments(0, 1);
  const ShortFloat half(0.5), root = sqrt(ShortFloat(3)) / 2;
  const auto is_near = [](const ShortFloat& a, const ShortFloat& b) { return abs(a - b) < 1e-55; };
  EXPECT_TRUE(is_near(curve[0][0].p0, half));
  EXPECT_TRUE(is_near(curve[0][3].p0, root));
  EXPECT_TRUE(is_near(curve[0][0].p1, -root));
  EXPECT_TRUE(is_near(curve[0][3].p1, -half));
  EXPECT_EQ(curve[0][1].p1, 0);
}

}  // namespace
}  // namespace tcb
