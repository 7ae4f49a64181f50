// Arc length: curves with a known length, cusps, holds, and another scalar.
#include "tcb/spline/arc_length.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "plane_segments.hpp"
#include "tcb/spline/arc_inverse.hpp"

namespace tcb::spline {
namespace {

double total(const PlaneSegment& curve) { return ArcLength<double>(curve, {}).total().value; }

TEST(ArcLength, of_a_parabola) { EXPECT_NEAR(total(parabola), parabola_length, 1e-15 * 4); }

TEST(ArcLength, of_a_cusp) { EXPECT_NEAR(total(cusp), (std::pow(13, 1.5) - 8) / 27, 1e-12); }

TEST(ArcLength, of_a_hold_is_zero) {
  const PlaneSegment hold = segment({3, 4}, {3, 4}, {0, 0}, {0, 0});
  EXPECT_EQ(total(hold), 0);
}

TEST(ArcLength, of_an_overflow_is_infinite) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
    PlaneSegment bent = parabola;
    bent[1].e = bad;
    const ArcLength<double> arc(bent, {});
    EXPECT_EQ(arc.total().value, infinite);
    EXPECT_EQ(arc.to({0.25, -0.75}).value, infinite);
  }
}

TEST(ArcLength, of_a_reversal_counts_both_ways) {
  const PlaneSegment back_and_forth = segment({0, 0}, {0, 0}, {4, 0}, {-4, 0});  // x = 4u - 4u^2, up to 1 and back
  EXPECT_NEAR(total(back_and_forth), 2, 1e-12);
}

TEST(ArcLength, scales_exactly_by_powers_of_two) {
  for (const int exponent : {-900, -40, 40, 900}) {
    PlaneSegment scaled = parabola;
    for (auto& x : scaled) {
      for (double* value : {&x.p0, &x.out, &x.c, &x.c_low, &x.p1, &x.in, &x.e, &x.e_low, &x.d}) {
        *value = std::ldexp(*value, exponent);
      }
    }
    EXPECT_EQ(total(scaled), std::ldexp(total(parabola), exponent));
  }
}

TEST(ArcLength, is_that_of_the_metric_channels) {
  const std::array<std::size_t, 1> x_only{0};
  EXPECT_NEAR(ArcLength<double>(parabola, x_only).total().value, 1, 1e-15);
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

TEST(ArcLength, agrees_with_an_extended_scalar_near_a_cusp) {
  for (const double distance : {1e-1, 1e-2, 1e-4, 1e-8, 1e-12, 1e-16, 0.0}) {
    for (const double slope : {0.0, 1e-6, 1.0}) {
      SCOPED_TRACE(distance);
      expect_as_in_extended(near_cusp(0.375, slope, distance));
    }
  }
}

TEST(ArcLength, is_accurate_where_the_square_of_the_least_speed_is_within_rounding) {
  std::mt19937_64 random(1984);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const double u0 = 0.5 + 0.4 * uniform(random);
    std::array<Cubic<double>, 3> segment;
    for (auto& x : segment) {
      const double curvature = uniform(random), twist = uniform(random), drift = 1e-8 * uniform(random);
      const auto value = [&](double v) { return v * (drift + v * (curvature / 2 + v * twist / 3)); };
      const auto slope = [&](double v) { return drift + v * (curvature + v * twist); };
      x = cubic<double>(value(-u0), value(1 - u0), slope(-u0), slope(1 - u0));
    }
    expect_as_in_extended(segment);
  }
}

}  // namespace
}  // namespace tcb::spline
