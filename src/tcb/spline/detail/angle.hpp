// Angles: sine and cosine, and the angle of a vector, for doubles without the C library, so that their bits are the
// same everywhere.
//
// Method: Taylor series after a reduction of the argument in more digits; the rests are carried to the end.
// Source: W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980, chapters 8 and 11.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

template <class T>
struct SineCosine {
  T sine, cosine;
};

/// The sine and cosine of an angle in radians, at a scalar that has its own.
template <class S>
SineCosine<S> sine_cosine(const S& angle) {
  return {sin(angle), cos(angle)};
}

/// For doubles. Requires: |angle| <= 2^20. Promises: within 1 ulp.
inline SineCosine<double> sine_cosine(double angle) {
  // pi/2 in three parts; the first two have 33 bits, so that their products with `quarters` are exact.
  constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  const double quarters = static_cast<double>(static_cast<int>(angle * two_over_pi + (angle < 0 ? -0.5 : 0.5)));
  const auto rest = two_sum(angle - quarters * first, -quarters * second);
  const auto [x, low] = DoubleDouble::normalized(rest.value, rest.error - quarters * third);
  const double z = x * x;
  const double sine_tail =
      z * x *
      (-1.0 / 6 +
       z * (1.0 / 120 +
            z * (-1.0 / 5040 + z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                                        z * (1.0 / 6227020800 + z * (-1.0 / 1307674368000 +
                                                                                     z * (1.0 / 355687428096000))))))));
  const double sine = x + (sine_tail + low * (1 - 0.5 * z));
  const double half = 0.5 * z;
  const double cosine_tail =
      z * z *
      (1.0 / 24 +
       z * (-1.0 / 720 +
            z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                    z * (1.0 / 479001600 + z * (-1.0 / 87178291200 + z * (1.0 / 20922789888000)))))));
  const double one_less = 1 - half;
  const double cosine = one_less + (((1 - one_less) - half) + (cosine_tail - x * low));
  switch (static_cast<int>(quarters) & 3) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

/// The angle of the vector (x, y) in [0, pi], at a scalar that has its own. Requires: y >= 0.
template <class S>
S angle_of(const S& y, const S& x) {
  return atan2(y, x);
}

/// For doubles. Requires: y >= 0, not both 0. Promises: within 1 ulp.
inline double angle_of(double y, double x) {
  // The arc tangents of 0, 1/8, ..., 1. Up to 3/16 the series is used alone, as the first of them would cancel.
  static constexpr std::array<DoubleDouble, 9> eighths{DoubleDouble{0, 0},
                                                       DoubleDouble{0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                       DoubleDouble{0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                       DoubleDouble{0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                       DoubleDouble{0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                       DoubleDouble{0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                       DoubleDouble{0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                       DoubleDouble{0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                       DoubleDouble{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
  constexpr DoubleDouble half_turn{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
  const double width = x < 0 ? -x : x;
  const bool steep = y > width;
  const double shorter = steep ? width : y, longer = steep ? y : width;
  const double ratio = shorter / longer;
  const std::size_t index = ratio <= 0.1875 ? 0 : static_cast<std::size_t>(ratio * 8 + 0.5);
  const double tangent = 0.125 * static_cast<double>(index);
  const DoubleDouble r = (DoubleDouble(shorter) - DoubleDouble(longer) * tangent) /
                         (DoubleDouble(longer) + DoubleDouble(shorter) * tangent);
  const double z = r.hi * r.hi;
  double series = 0;
  for (int n = 25; n >= 3; n -= 2) series = (n % 4 == 1 ? 1.0 : -1.0) / n + z * series;
  const DoubleDouble angle = eighths[index] + DoubleDouble::normalized(r.hi, r.lo + r.hi * z * series);
  if (steep) return (halved(half_turn) + (x < 0 ? angle : -angle)).hi;
  return x < 0 ? (half_turn - angle).hi : angle.hi;
}

}  // namespace tcb::spline
