// Extremes: maxima that are known by hand, the places where they are, and corners.
#include "limits/extremes.hpp"

#include <gmock/gmock.h>

#include <memory>

namespace tcb::limits {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A cubic from p0 to p1 with the tangents `out` and `in`, in each of two channels.
struct TwoChannels {
  Rational p0, p1, out, in;
  Rational q0 = 0, q1 = 0, q_out = 0, q_in = 0;
};

/// A curve of these segments, each of the duration 1 from time 0.
MeasuredCurve curve_of(const std::vector<TwoChannels>& cubics) {
  const auto exact = std::make_shared<std::vector<spline::Segments<Rational>>>();
  for (const auto& x : cubics) {
    const Rational begin = exact->size();
    exact->push_back({2, {begin, begin + 1}, {}, {}});
    exact->back().cubics = {spline::cubic<Rational>(x.p0, x.p1, x.out, x.in),
                            spline::cubic<Rational>(x.q0, x.q1, x.q_out, x.q_in)};
  }
  return {exact->size(),
          [](std::size_t number) { return Time(static_cast<double>(number)); },
          [](std::size_t, std::size_t) { return std::optional<spline::Segments<Bounded>>(); },
          [exact](std::size_t number) { return exact->at(number); },
          true,
          {},
          {}};
}

const Measure velocity{"velocity_x", Measure::Kind::size, 1, {0}, true};
const Measure largest{"position_x", Measure::Kind::largest, 0, {0}, true};
const Measure speed{"speed", Measure::Kind::size, 1, {0, 1}};
const Measure curvature{"curvature", Measure::Kind::curvature, 0, {0, 1}};

Extreme maximum(const MeasuredCurve& curve, const Measure& measure) {
  return extremes(curve, {measure}, {0, 1}).maxima.at(0).value();
}

TEST(Extremes, a_maximum_inside_a_segment_is_exact) {
  const Extreme found = maximum(curve_of({{0, 1, 0, 0}}), velocity);  // 6u - 6u^2
  EXPECT_EQ(found.low, Rational(9) / 4);
  EXPECT_EQ(found.high, Rational(9) / 4);
  EXPECT_EQ(found.time, Rational(1) / 2);
  EXPECT_FALSE(found.is_at_key);
}

TEST(Extremes, a_maximum_that_is_irrational_is_between_two_numbers) {
  const Extreme found = maximum(curve_of({{0, 0, 1, -2}}), largest);  // u - u^3
  EXPECT_LT(found.low, found.high);
  EXPECT_LT(27 * found.low * found.low, 4);  // the maximum is the root of 4/27
  EXPECT_GT(27 * found.high * found.high, 4);
  EXPECT_LT(found.high - found.low, Rational(0x1p-70));
}

TEST(Extremes, at_a_key_it_has_a_side) {
  MeasuredCurve curve = curve_of({{0, 1, 0, 3}, {1, 2, 1, 1}});
  curve.has_positions = true;
  const Extreme found = maximum(curve, velocity);
  EXPECT_EQ(found.high, 9);
  EXPECT_EQ(found.time, 1);
  EXPECT_EQ(found.side, spline::Side::left);
  EXPECT_TRUE(found.is_at_key);
  EXPECT_THAT(found.position, ElementsAre(1, 0));
}

TEST(Extremes, a_range_of_times_is_measured_alone) {
  MeasuredCurve curve = curve_of({{0, 1, 0, 0}, {1, 2, 0, 0}});
  curve.from = Rational(5) / 4;
  curve.to = Rational(5) / 4 + Rational(1) / 8;
  const Extreme found = maximum(curve, velocity);
  EXPECT_EQ(found.time, Rational(11) / 8);
  EXPECT_EQ(found.low, Rational(45 * 45) / (32 * 32));
  curve.from = curve.to = 7;
  EXPECT_FALSE(extremes(curve, {velocity}, {0, 1}).maxima.at(0));
}

TEST(Extremes, a_curvature_is_that_of_the_vertex) {
  const Extreme found = maximum(curve_of({{-1, 1, 2, 2, 1, 1, -4, 4}}), curvature);  // y = x^2
  EXPECT_EQ(found.low, 4);
  EXPECT_LT(found.high, 4 + Rational(0x1p-70));
  EXPECT_EQ(found.time, Rational(1) / 2);
}

TEST(Extremes, beside_a_rest_a_curvature_has_no_bound) {
  const Extreme found = maximum(curve_of({{0, 1, 0, 2, 0, 1, 0, 3}}), curvature);  // u^2, u^3
  EXPECT_TRUE(found.is_unbounded);
  EXPECT_EQ(found.time, 0);
}

TEST(Extremes, at_a_rest_between_two_directions_a_curvature_has_no_bound) {
  const TwoChannels right{0, 1, 0, 0, 0, 0, 0, 0}, up{1, 1, 0, 0, 0, 1, 0, 0}, back{1, 0, 0, 0, 0, 0, 0, 0};
  const Extreme found = maximum(curve_of({right, up}), curvature);
  EXPECT_TRUE(found.is_unbounded);
  EXPECT_EQ(found.time, 1);
  EXPECT_EQ(found.side, spline::Side::left);
  EXPECT_EQ(maximum(curve_of({right, back}), curvature).high, 0);  // there and back on a line
}

TEST(Extremes, a_curvature_beside_a_slow_end_has_all_digits) {
  const Rational slow = Rational(1e-80);  // at the end: velocity (slow, 0), acceleration (-3 + 2 slow, -2)
  const Extreme found = maximum(curve_of({{0, 1, Rational(3) / 2, slow, 0, 1, 2, 0}}), curvature);
  const Rational exact = 2 / (slow * slow);
  EXPECT_EQ(found.low, exact * exact);
  EXPECT_EQ(found.high, exact * exact);
}

TEST(Extremes, of_equal_maxima_the_earliest_is_told) {
  const TwoChannels rise{0, 1, 0, 0}, fall{1, 0, 0, 0};
  EXPECT_EQ(maximum(curve_of({rise, fall, rise}), velocity).time, Rational(1) / 2);
}

TEST(Extremes, a_time_that_is_printed_as_that_of_a_key_is_that_key) {
  MeasuredCurve curve = curve_of({{0, 1, 9, 9}, {1, 2, 0, 0}, {2, 3, 9, 9}});
  curve.from = 1 - Rational(0x1p-60);
  curve.to = 2 + Rational(0x1p-60);
  const Extreme found = maximum(curve, velocity);
  EXPECT_EQ(found.high, Rational(9) / 4);
  EXPECT_EQ(found.time, Rational(3) / 2);
}

TEST(Extremes, many_channels_have_the_curvature_of_their_plane) {  // y = x^2 in each of three pairs of channels
  spline::Segments<Rational> one{6, {0, 1}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    one.cubics.push_back(spline::cubic<Rational>(-1, 1, 2, 2));
    one.cubics.push_back(spline::cubic<Rational>(1, 1, -4, 4));
  }
  MeasuredCurve curve = curve_of({{}});
  curve.exact = [one](std::size_t) { return one; };
  const Measure all{"curvature", Measure::Kind::curvature, 0, {0, 1, 2, 3, 4, 5}};
  const Extreme found = extremes(curve, {all}, {0}).maxima.at(0).value();
  EXPECT_EQ(found.low, Rational(4) / 3);  // a parabola of sqrt(3) x and sqrt(3) x^2
  EXPECT_EQ(found.time, Rational(1) / 2);
}

TEST(Extremes, on_a_line_there_is_none) {
  const Extreme found = maximum(curve_of({{0, 1, 0, 2, 0, 3, 0, 6}}), curvature);
  EXPECT_EQ(found.low, 0);
  EXPECT_EQ(found.high, 0);
}

TEST(Extremes, segments_that_repeat_have_one_maximum) {
  const TwoChannels there{0, 1, 0, 0}, back{1, 0, 0, 0};
  const Extreme found = maximum(curve_of({there, back, there, back}), speed);
  EXPECT_EQ(found.low, Rational(9) / 4);
  EXPECT_EQ(found.high, Rational(9) / 4);
}

TEST(Extremes, sizes_that_are_far_apart_are_bounded) {
  const Rational tiny = Rational(1e-300), huge = Rational(1e300);
  const Extreme found = maximum(curve_of({{0, tiny, 0, 0}, {0, huge, 0, 0}}), velocity);
  EXPECT_EQ(found.low, Rational(9) / 4 * huge * huge);
  EXPECT_EQ(found.high, found.low);
}

TEST(Extremes, a_jump_of_the_velocity_is_a_corner) {
  const TwoChannels line{0, 1, 1, 1, 0, 1, 1, 1};
  TwoChannels other = line;
  other.out = 4;
  const Extremes found = extremes(curve_of({line, line, other}), {}, {0, 1});
  ASSERT_THAT(found.corners, SizeIs(1));
  EXPECT_EQ(found.corners[0].time, Time(2.0));
  EXPECT_EQ(found.corners[0].jump, 3);
  EXPECT_THAT(found.corners[0].channels, ElementsAre(0));
  MeasuredCurve closed = curve_of({other});
  closed.closed = true;
  EXPECT_THAT(extremes(closed, {}, {0, 1}).corners, SizeIs(1));
  EXPECT_THAT(extremes(curve_of({line, line}), {}, {0, 1}).corners, IsEmpty());
}

}  // namespace
}  // namespace tcb::limits
