// Rotations: the curves of quaternions against tabled values, their derivatives, and laws.
#include "tcb/spline/rotation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "tcb/spline/window_segments.hpp"

namespace tcb::spline {
namespace {

using Reference =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// A turn by degrees around an axis that need not be normalized.
template <class S>
Quaternion<S> turn(const std::array<double, 3>& axis, double degrees) {
  using std::sqrt;
  const S x(axis[0]), y(axis[1]), z(axis[2]), size = sqrt(x * x + y * y + z * z);
  const S half = angle_of(S(0), S(-1)) * S(degrees) / S(360);
  return exponential<S>({half * x / size, half * y / size, half * z / size});
}

/// Keys at uneven times, with tension, continuity and bias.
template <class S>
Window<S> example_keys() {
  constexpr std::array times{0, 1, 3, 4, 6};
  constexpr std::array<std::array<double, 3>, 5> axes{{{1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 1, 1}, {1, 1, 1}}};
  constexpr std::array<double, 5> degrees{0, 60, 100, 80, 150};
  constexpr std::array<Tcb<double>, 5> tcbs{
      {{.2, -.3, .4}, {0, .5, -.25}, {-.5, .25, .5}, {.3, -.6, -.2}, {.1, .4, .3}}};
  Window<S> window;
  window.keys.channels = 4;
  for (std::size_t i = 0; i < times.size(); ++i) {
    window.keys.times.push_back(Time<S>(S(times[i])));
    const auto [x, y, z, w] = turn<S>(axes[i], degrees[i]);
    for (const S& number : {x, y, z, w}) window.keys.positions.push_back(number);
    window.keys.tcbs.push_back({S(tcbs[i].tension), S(tcbs[i].continuity), S(tcbs[i].bias)});
  }
  return window;
}

template <class S>
CurveRules<S> rules_with(TangentRule tangents, RotationCurve curve, EndRule ends) {
  CurveRules<S> rules;
  rules.tangents = tangents;
  rules.start.rule = rules.end.rule = ends;
  rules.rotations = {{{0, 1, 2, 3}}};
  rules.rotation_rules.curve = curve;
  return rules;
}

template <class S>
LocalParameter<S> place(double u) {
  return {S(u), S(u) - S(1)};
}

struct RotationRow {
  TangentRule tangents;
  RotationCurve curve;
  EndRule ends;
  std::size_t segment;
  double u;
  std::array<double, 4> expected;  // w, x, y, z
};

TEST(Rotation, tabled_values) {
  using enum RotationCurve;
  const std::vector<RotationRow> rows{
      {TangentRule::interval,
       squad,
       EndRule::half,
       1,
       0.5,
       {.779176692337, .540451134321, .314552826549, -.043043847883}},
      {TangentRule::interval,
       squad,
       EndRule::half,
       2,
       0.5,
       {.687872486392, .131877994085, .673875620837, .235226029133}},
      {TangentRule::finite_difference,
       casteljau,
       EndRule::natural,
       0,
       0.5,
       {.940820154506, .337589624763, -.029844298071, 0}},
      {TangentRule::finite_difference,
       casteljau,
       EndRule::natural,
       1,
       0.5,
       {.718135420408, .595129990211, .351580872026, -.080577311520}},
      {TangentRule::interval_c, squad, EndRule::mirror, 0, 0.5, {.953175406424, .291688986113, -.079838461709, 0}},
      {TangentRule::interval_c,
       squad,
       EndRule::mirror,
       1,
       0.5,
       {.783629966631, .533543549069, .315578343863, -.040812565826}},
  };
  for (const RotationRow& row : rows) {
    const auto curve = segments(example_keys<double>(), rules_with<double>(row.tangents, row.curve, row.ends));
    const auto [x, y, z, w] = curve.rotations_of(row.segment)[0].at(place<double>(row.u));
    EXPECT_NEAR(w, row.expected[0], 1e-12);
    EXPECT_NEAR(x, row.expected[1], 1e-12);
    EXPECT_NEAR(y, row.expected[2], 1e-12);
    EXPECT_NEAR(z, row.expected[3], 1e-12);
  }
}

TEST(Rotation, linear_tangents_make_every_spherical_curve_a_slerp) {
  const auto slerp =
      segments(example_keys<double>(), rules_with<double>(TangentRule::velocity, RotationCurve::slerp, EndRule::half));
  for (const RotationCurve curve : {RotationCurve::squad, RotationCurve::casteljau}) {
    const auto linear = segments(example_keys<double>(), rules_with<double>(TangentRule::linear, curve, EndRule::zero));
    for (std::size_t segment = 0; segment < 4; ++segment) {
      for (const double u : {0.0, 0.125, 0.4, 0.5, 0.875, 1.0}) {
        const auto q = linear.rotations_of(segment)[0].at(place<double>(u));
        const auto r = slerp.rotations_of(segment)[0].at(place<double>(u));
        EXPECT_NEAR(dot(q, r), 1, 1e-15);
      }
    }
  }
}

TEST(Rotation, doubles_are_near_many_digits_and_unit) {
  for (const RotationCurveRow& row : rotation_curves) {
    const auto fast =
        segments(example_keys<double>(), rules_with<double>(TangentRule::velocity, row.id, EndRule::half));
    const auto slow =
        segments(example_keys<Reference>(), rules_with<Reference>(TangentRule::velocity, row.id, EndRule::half));
    for (std::size_t segment = 0; segment < 4; ++segment) {
      for (const double u : {0.0, 0.125, 0.4, 0.5, 0.875, 1.0}) {
        const auto q = fast.rotations_of(segment)[0].at(place<double>(u));
        const auto r = slow.rotations_of(segment)[0].at(place<Reference>(u));
        EXPECT_NEAR(q.x, static_cast<double>(r.x), 1e-15);
        EXPECT_NEAR(q.y, static_cast<double>(r.y), 1e-15);
        EXPECT_NEAR(q.z, static_cast<double>(r.z), 1e-15);
        EXPECT_NEAR(q.w, static_cast<double>(r.w), 1e-15);
        const Quaternion<Reference> exact{q.x, q.y, q.z, q.w};
        EXPECT_LE(abs(sqrt(dot(exact, exact)) - 1), Reference(0x1p-51)) << row.name;
      }
    }
  }
}

TEST(Rotation, the_rate_is_the_derivative) {
  for (const RotationCurveRow& row : rotation_curves) {
    const auto curve =
        segments(example_keys<Reference>(), rules_with<Reference>(TangentRule::velocity, row.id, EndRule::half));
    for (std::size_t segment = 0; segment < 4; ++segment) {
      const RotationSegment<Reference>& one = curve.rotations_of(segment)[0];
      const Reference u(0.3), step(1e-15);
      const auto before = one.at({u - step, u - step - 1}), after = one.at({u + step, u + step - 1});
      const auto measured = (after + -before) * Reference(1 / step) * conjugate(one.at({u, u - 1}));
      const Vector3<Reference> rate = one.rate({u, u - 1});
      EXPECT_LT(abs(rate[0] - measured.x), 1e-25) << row.name;
      EXPECT_LT(abs(rate[1] - measured.y), 1e-25) << row.name;
      EXPECT_LT(abs(rate[2] - measured.z), 1e-25) << row.name;
    }
  }
}

TEST(Rotation, turns_around_one_axis_are_the_curve_of_the_angle) {
  const std::vector<double> degrees{0, 60, -40, 50, 120};
  Window<double> turns = example_keys<double>(), angles = turns;
  angles.keys.channels = 1;
  angles.keys.positions = degrees;
  turns.keys.positions.clear();
  for (const double angle : degrees) {
    const auto [x, y, z, w] = turn<double>({1, 2, 2}, angle);
    for (const double number : {x, y, z, w}) turns.keys.positions.push_back(number);
  }
  const auto rules = rules_with<double>(TangentRule::finite_difference, RotationCurve::casteljau, EndRule::half);
  auto plain = rules;
  plain.rotations.clear();
  const auto curve = segments(turns, rules), expected = segments(angles, plain);
  for (std::size_t segment = 0; segment < 4; ++segment) {
    const auto at = place<double>(0.375);
    const auto found = curve.rotations_of(segment)[0].at(at);
    const auto wanted = turn<double>({1, 2, 2}, position(expected[segment][0], at));
    EXPECT_NEAR(std::abs(dot(found, wanted)), 1, 1e-15);
  }
}

TEST(Rotation, the_rules_of_a_preset_for_rotations_replace_those_of_positions) {
  CurveRules<double> nel = rules_of<double>(Preset::nel);
  nel.rotations = {{{0, 1, 2, 3}}};
  const auto curve = segments(example_keys<double>(), nel);
  const auto mirrored = segments(example_keys<double>(),
                                 rules_with<double>(TangentRule::interval_c, RotationCurve::squad, EndRule::mirror));
  for (const std::size_t segment : {0U, 3U}) {
    const auto p = curve.rotations_of(segment)[0].at(place<double>(0.5));
    const auto q = mirrored.rotations_of(segment)[0].at(place<double>(0.5));
    EXPECT_EQ(p.x, q.x);
    EXPECT_EQ(p.w, q.w);
  }
}

TEST(Rotation, takes_the_tension_continuity_and_bias_of_its_first_channel) {
  const auto rules = rules_with<double>(TangentRule::velocity, RotationCurve::squad, EndRule::half);
  Window<double> common = example_keys<double>(), of_channels = common;
  ASSERT_FALSE(common.keys.has_channel_tcbs());
  of_channels.keys.tcbs.clear();
  for (std::size_t key = 0; key < common.keys.size(); ++key) {
    const Tcb<double>& tcb = common.keys.tcb(key);
    of_channels.keys.tcbs.insert(of_channels.keys.tcbs.end(), {tcb, {1, 1, 1}, {-1, 0, 0}, {0, -1, 0}});
  }
  const auto one = segments(common, rules), other = segments(of_channels, rules);
  for (std::size_t segment = 0; segment < 4; ++segment) {
    const auto p = one.rotations_of(segment)[0].at(place<double>(0.25));
    const auto q = other.rotations_of(segment)[0].at(place<double>(0.25));
    EXPECT_TRUE(p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w);
  }
}

TEST(Rotation, the_sign_of_a_key_does_not_change_the_rotation) {
  const auto rules = rules_with<double>(TangentRule::velocity, RotationCurve::squad, EndRule::half);
  Window<double> negated = example_keys<double>();
  for (std::size_t i = 8; i < 12; ++i) negated.keys.positions[i] *= -1;
  const auto one = segments(example_keys<double>(), rules), other = segments(negated, rules);
  for (std::size_t segment = 0; segment < 4; ++segment) {
    const auto p = one.rotations_of(segment)[0].at(place<double>(0.25));
    const auto q = other.rotations_of(segment)[0].at(place<double>(0.25));
    EXPECT_EQ(p.x, q.x);
    EXPECT_EQ(p.w, q.w);
  }
}

TEST(Rotation, parts_are_on_the_whole_curve) {
  const auto rules = rules_with<double>(TangentRule::velocity, RotationCurve::squad, EndRule::half);
  const auto curve = segments(example_keys<double>(), rules);
  const RotationSegment<double>& whole = curve.rotations_of(1)[0];
  const RotationSegment<double> part = whole.part(0.25, 0.5, 0.25);
  EXPECT_EQ(part.at(place<double>(0.5)).x, whole.at(place<double>(0.5)).x);
  EXPECT_EQ(part.rate(place<double>(0.5))[0], whole.rate(place<double>(0.5))[0] * 0.5);
  EXPECT_EQ(whole.part(0.5, 0.5, 0).at(place<double>(1)).w, whole.at(place<double>(1)).w);
}

/// Values of an independent program that follows the text on turns in rotation.hpp.
TEST(Rotation, whole_turns_run_along_a_great_circle) {
  const double pi = angle_of(0.0, -1.0);
  const auto half_angle = [&](double degrees) { return degrees / 360 * pi; };
  const TurnVector<double> turns{half_angle(300), half_angle(600), half_angle(600)};  // 900 degrees around (1, 2, 2)
  const Quaternion<double> first{0, 0, 0, 1}, second = exponential(turns);
  const Quaternion<double> third = second * turn<double>({0, 1, 0}, 60);
  Window<double> window;
  window.keys.channels = 4;
  window.keys.times = {0.0, 1.0, 3.0};
  for (const auto& [x, y, z, w] : {first, second, third}) {
    for (const double number : {x, y, z, w}) window.keys.positions.push_back(number);
  }
  window.keys.tcbs = {{0, 0, 0}, {.25, -.5, .5}, {0, 0, 0}};
  window.keys.turns = {{}, turns, {}};
  auto rules = rules_with<double>(TangentRule::uniform, RotationCurve::squad, EndRule::chord);
  rules.rotations[0].turn = 0;
  const auto rotations_of = [&] {
    Segments<double> segments;
    set_rotations(segments, window, rules);
    return segments.rotations;
  };
  const auto curve = rotations_of();
  const auto expect_at = [&](std::size_t segment, double u, const std::array<double, 4>& expected) {
    const auto [x, y, z, w] = curve[segment].at(place<double>(u));
    EXPECT_NEAR(x, expected[0], 1e-12) << u;
    EXPECT_NEAR(y, expected[1], 1e-12) << u;
    EXPECT_NEAR(z, expected[2], 1e-12) << u;
    EXPECT_NEAR(w, expected[3], 1e-12) << u;
  };
  const double root = std::sqrt(0.5);
  expect_at(0, .1, {root / 3, root * 2 / 3, root * 2 / 3, root});
  expect_at(0, .5, {-root / 3, -root * 2 / 3, -root * 2 / 3, -root});
  expect_at(0, .95, {.31749309676401, .62325559810495, .62032294924918, .35489439495834});
  expect_at(1, .5, {.1816192270224, .64493766010493, .71536246161996, -.19830889909228});
  rules.rotation_rules.curve = RotationCurve::slerp;
  const auto at_one_rate = rotations_of()[0];
  for (const double u : {0.0, .25, .7, .99}) {
    const auto rate = at_one_rate.rate(place<double>(u));
    EXPECT_NEAR(std::sqrt(rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2]), 5 * pi, 1e-13) << u;
  }
}

TEST(Rotation, logarithm_and_exponential_are_inverse) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> near(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3<double> v{near(random), near(random), near(random) * (i % 2 == 0 ? 1 : 1e-12)};
    const Vector3<double> back = logarithm(exponential(v));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], v[k], 1e-15);
  }
  EXPECT_EQ(exponential<double>({0, 0, 0}).w, 1);
  EXPECT_EQ(logarithm(Quaternion<double>{0, 0, 0, 1})[0], 0);
}

}  // namespace
}  // namespace tcb::spline
