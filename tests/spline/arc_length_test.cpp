// Arc length: curves whose length is known, cusps, holds, and the inverse.
#include "spline/arc_length.hpp"
#include "spline/arc_inverse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

TEST(ArcLength, of_a_reversal_counts_both_ways) {
  const Segment back_and_forth = segment({0, 0}, {0, 0}, {4, 0}, {-4, 0});  // x = 4u - 4u^2, up to 1 and back
  EXPECT_NEAR(total(back_and_forth), 2, 1e-12);
}

TEST(ArcLength, scales_exactly_by_powers_of_two) {
  for (const int exponent : {-900, -40, 40, 900}) {
    Segment scaled = parabola;
    for (auto& x : scaled) {
      for (double* value : {&x.p0, &x.out, &x.c, &x.c_rest, &x.p1, &x.in, &x.e, &x.e_rest, &x.d}) {
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
    for (const double step : {0.0, whole / 97}) {
      const ArcInverse<double> inverse(arc, step);
      for (double s = 0; s <= whole; s += whole / 97) {
        EXPECT_NEAR(arc.to(inverse.at(s, Twice(whole) - Twice(s))).value, s, 1e-15 * whole);
      }
      EXPECT_EQ(inverse.at(whole, 0).w, 0);
      EXPECT_EQ(inverse.at(0, whole).u, 0);
    }
  }
}

}  // namespace
}  // namespace tcb::spline
