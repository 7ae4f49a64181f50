// Arc length: curves whose length is known, cusps, holds, and the inverse.
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/arc_inverse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace tcb::spline {
namespace {

using Segment = std::array<Cubic<double>, 2>;

Segment segment(std::array<double, 2> p0, std::array<double, 2> p1, std::array<double, 2> out,
                std::array<double, 2> in) {
  return {cubic<double>(p0[0], p1[0], out[0], in[0]), cubic<double>(p0[1], p1[1], out[1], in[1])};
}

double total(const Segment& curve) { return ArcLength<double>(curve, {}).total().value; }

/// y = x^2 for x from 0 to 1.
const Segment parabola = segment({0, 0}, {1, 1}, {1, 0}, {1, 2});
const double parabola_length = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;

/// (u^2, u^3): a cusp at the start; its length is (13^1.5 - 8) / 27.
const Segment cusp = segment({0, 0}, {1, 1}, {0, 0}, {2, 3});

TEST(ArcLength, of_a_parabola) { EXPECT_NEAR(total(parabola), parabola_length, 1e-15 * 4); }

TEST(ArcLength, of_a_cusp) { EXPECT_NEAR(total(cusp), (std::pow(13, 1.5) - 8) / 27, 1e-12); }

TEST(ArcLength, of_a_hold_is_zero) {
  const Segment hold = segment({3, 4}, {3, 4}, {0, 0}, {0, 0});
  EXPECT_EQ(total(hold), 0);
}

TEST(ArcLength, of_what_is_beyond_doubles_is_infinite) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
    Segment bent = parabola;
    bent[1].e = bad;
    const ArcLength<double> arc(bent, {});
    EXPECT_EQ(arc.total().value, infinite);
    EXPECT_EQ(arc.to({0.25, -0.75}).value, infinite);
  }
}

TEST(ArcLength, of_a_reversal_counts_both_ways) {
  const Segment back_and_forth = segment({0, 0}, {0, 0}, {4, 0}, {-4, 0});  // x = 4u - 4u^2, up to 1 and back
  EXPECT_NEAR(total(back_and_forth), 2, 1e-12);
}

TEST(ArcLength, scales_exactly_by_powers_of_two) {
  for (const int exponent : {-900, -40, 40, 900}) {
    Segment scaled = parabola;
    for (auto& x : scaled) {
      for (double* value : {&x.p0, &x.out, &x.c, &x.c_low, &x.p1, &x.in, &x.e, &x.e_low, &x.d}) {
        *value = std::ldexp(*value, exponent);
      }
    }
    EXPECT_EQ(total(scaled), std::ldexp(total(parabola), exponent));
  }
}

TEST(ArcLength, looks_at_the_metric_channels_only) {
  const std::array<std::size_t, 1> x_only{0};
  EXPECT_NEAR(ArcLength<double>(parabola, x_only).total().value, 1, 1e-15);
}

TEST(ArcLength, inverse_comes_back_to_the_length) {
  for (const Segment& curve :
       {parabola, cusp, segment({0, 0}, {1, 0}, {5, 5}, {5, 5}), segment({0, 0}, {0, 0}, {4, 0}, {-4, 0})}) {
    const ArcLength<double> arc(curve, {});
    const double whole = arc.total().value;
    ArcInverse<double> inverse(arc, 0.0, whole);
    for (double s = 0; s <= whole; s += whole / 97) {
      EXPECT_NEAR(arc.to(inverse.at(s)).value, s, 1e-15 * whole);
    }
    EXPECT_EQ(inverse.at(whole).w, 0);
    EXPECT_EQ(inverse.at(0).u, 0);
  }
}

using Extended = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>>;

/// The same polynomials, in a scalar with more digits.
std::vector<Cubic<Extended>> extended(std::span<const Cubic<double>> segment) {
  std::vector<Cubic<Extended>> result;
  for (const auto& x : segment) {
    result.push_back({x.p0, x.out, Extended(x.c) + x.c_low, 0, x.p1, x.in, Extended(x.e) + x.e_low, 0, x.d});
  }
  return result;
}

/// Velocities (u - a)^2, slope (u - a) and `distance`: the nearer the distance to 0, the nearer the curve to a cusp.
std::array<Cubic<double>, 3> near_cusp(double a, double slope, double distance) {
  const auto channel = [](double k0, double k1, double k2) {
    return cubic<double>(0, k0 + k1 / 2 + k2 / 3, k0, k0 + k1 + k2);
  };
  return {channel(a * a, -2 * a, 1), channel(-a * slope, slope, 0), channel(distance, 0, 0)};
}

void expect_as_in_extended(std::span<const Cubic<double>> segment) {
  const auto reference = extended(segment);
  const ArcLength<double> arc(segment, {});
  const ArcLength<Extended> exact(reference, {});
  const auto [length, bound] = arc.total();
  const auto error = static_cast<double>(abs(exact.total().value - length));
  EXPECT_LE(error, bound);
  EXPECT_LE(error, 4 * (std::nextafter(length, HUGE_VAL) - length));
  ArcInverse<double> inverse(arc, 0.0, length);
  for (int row = 1; row < 8; ++row) {
    const DoubleDouble s = DoubleDouble(length) * DoubleDouble(row / 8.0);
    const LocalParameter<double> at = inverse.at(s);
    const LocalParameter<Extended> place = at.near_start() ? LocalParameter<Extended>{at.u, Extended(at.u) - 1}
                                                           : LocalParameter<Extended>{Extended(at.w) + 1, at.w};
    EXPECT_LE(static_cast<double>(abs(exact.to(place).value - (Extended(s.hi) + s.lo))), 2e-15 * length);
  }
}

TEST(ArcLength, agrees_with_an_extended_scalar) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-10, 10);
  for (int i = 0; i < 20; ++i) {
    std::array<Cubic<double>, 3> segment;
    for (auto& x : segment) x = cubic<double>(uniform(random), uniform(random), uniform(random), uniform(random));
    expect_as_in_extended(segment);
  }
}

TEST(ArcLength, agrees_with_an_extended_scalar_however_near_a_cusp_is) {
  for (const double distance : {1e-1, 1e-2, 1e-4, 1e-8, 1e-12, 1e-16, 0.0}) {
    for (const double slope : {0.0, 1e-6, 1.0}) {
      SCOPED_TRACE(distance);
      expect_as_in_extended(near_cusp(0.375, slope, distance));
    }
  }
}

TEST(ArcLength, loses_nothing_where_the_square_of_the_least_speed_is_a_rounding) {
  std::mt19937_64 random(1984);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const double u0 = 0.5 + 0.4 * uniform(random);
    std::array<Cubic<double>, 3> segment;
    for (auto& x : segment) {
      const double bend = uniform(random), twist = uniform(random), drift = 1e-8 * uniform(random);
      const auto value = [&](double v) { return v * (drift + v * (bend / 2 + v * twist / 3)); };
      const auto slope = [&](double v) { return drift + v * (bend + v * twist); };
      x = cubic<double>(value(-u0), value(1 - u0), slope(-u0), slope(1 - u0));
    }
    expect_as_in_extended(segment);
  }
}

TEST(ArcInverse, does_not_depend_on_what_was_asked_before) {
  const ArcLength<double> arc(parabola, {});
  ArcInverse<double> one_by_one(arc, 0.0, arc.total().value);
  for (double s = 1.4; s > 0; s -= 0.1) {
    ArcInverse<double> fresh(arc, 0.0, arc.total().value);
    EXPECT_EQ(one_by_one.at(s).u, fresh.at(s).u);
  }
}

TEST(ArcInverse, tells_places_apart_beside_a_flat_near_stop) {
  for (const double slowest : {1e-7, 5e-7, 1e-6, 2e-6, 1e-5}) {  // the root of the least speed, at the start
    const double drift = slowest * slowest;
    const Segment curve = segment({0, 0}, {1.0 / 3, drift}, {0, drift}, {1, drift});
    const ArcLength<double> arc(curve, {});
    const double whole = arc.total().value;
    ArcInverse<double> inverse(arc, 0.0, whole);
    double before = 0;
    for (double s = whole * 1e-19; s < whole * 1e-14; s *= 2) {
      const double u = inverse.at(s).u;
      EXPECT_GT(u, before) << slowest << " at " << s;
      before = u;
    }
  }
}

TEST(ArcInverse, finds_many_places_as_it_finds_each) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 100; ++i) {
    Segment curve;
    for (auto& x : curve) x = cubic<double>(uniform(random), uniform(random), uniform(random), uniform(random));
    const ArcLength<double> arc(curve, {});
    const DoubleDouble start(uniform(random)), end = start + DoubleDouble(arc.total().value);
    std::vector<DoubleDouble> lengths;
    for (int row = 0; row <= i % 13; ++row)
      lengths.push_back(start + DoubleDouble(arc.total().value * (uniform(random) + 1) / 2));
    std::vector<LocalParameter<double>> places(lengths.size());
    ArcInverse<double>(arc, start, end).at(lengths, places);
    for (std::size_t row = 0; row < lengths.size(); ++row) {
      const LocalParameter<double> alone = ArcInverse<double>(arc, start, end).at(lengths[row]);
      EXPECT_EQ(places[row].u, alone.u);
      EXPECT_EQ(places[row].w, alone.w);
    }
  }
}

}  // namespace
}  // namespace tcb::spline
