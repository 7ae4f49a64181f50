// Angles: sine and cosine, and the angle of a vector, for doubles without the C library, so that their bits are the
// same everywhere.
//
// Method: Taylor series after a reduction of the argument in more digits; the rests are carried to the end.
// Source: W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980, chapters 8 and 11.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

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

/// The sine alone.
template <class S>
S sine(const S& angle) {
  return sin(angle);
}

/// A double as whole quarters of a turn and a rest x + low in [-pi/4, pi/4]. That of 2^90 or more is not a number.
class ReducedAngle {
 public:
  explicit ReducedAngle(double angle) {
    if (!(std::abs(angle) <= 0x1p20)) {
      reduce_large(angle);
      return;
    }
    quarters_ = static_cast<int>(angle * two_over_pi + (angle < 0 ? -0.5 : 0.5));
    // pi/2 in three parts; the first two have 33 bits, so that their products with `count` are exact.
    constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;
    const auto count = static_cast<double>(quarters_);
    const auto rest = two_sum(angle - count * first, -count * second);
    const auto reduced = DoubleDouble::normalized(rest.value, rest.error - count * third);
    x_ = reduced.hi;
    low_ = reduced.lo;
  }

  /// An angle in degrees: multiples of 90 are exact. Requires: |degrees| <= 2^26.
  static ReducedAngle of_degrees(double degrees) {
    constexpr double high = 0x1.1df46a2529d39p-6, low = 0x1.5c1d8becdd291p-62;  // pi/180
    ReducedAngle result;
    result.quarters_ = static_cast<int>(degrees / 90 + (degrees < 0 ? -0.5 : 0.5));
    const double rest = degrees - 90.0 * result.quarters_;
    const auto product = two_product(rest, high);
    const auto reduced = DoubleDouble::normalized(product.value, product.error + rest * low);
    result.x_ = reduced.hi;
    result.low_ = reduced.lo;
    return result;
  }

  double sine() const {
    switch (quarters_ & 3) {
      case 0: return sine_of_rest();
      case 1: return cosine_of_rest();
      case 2: return -sine_of_rest();
      default: return -cosine_of_rest();
    }
  }
  double cosine() const {
    switch (quarters_ & 3) {
      case 0: return cosine_of_rest();
      case 1: return -sine_of_rest();
      case 2: return -cosine_of_rest();
      default: return sine_of_rest();
    }
  }

 private:
  static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

  ReducedAngle() = default;

  /// By pi/2 in 159 bits: the first count of quarters is known to 53 bits.
  void reduce_large(double angle) {
    constexpr std::array half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110};
    if (!(std::abs(angle) < 0x1p90)) {
      x_ = low_ = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    DoubleDouble rest(angle);
    for (int step = 0; step < 3; ++step) {
      const double count = std::floor(rest.hi * two_over_pi + 0.5);
      quarters_ += static_cast<int>(count - 4 * std::floor(count / 4));
      for (const double part : half_pi) {
        const auto product = two_product(count, part);
        rest = rest - DoubleDouble(product.value, product.error);
      }
    }
    x_ = rest.hi;
    low_ = rest.lo;
  }

  double sine_of_rest() const {
    const double z = x_ * x_;
    double series = 1.0 / 355687428096000;
    for (const double factor :
         {-1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6}) {
      series = factor + z * series;
    }
    return x_ + (z * x_ * series + low_ * (1 - 0.5 * z));
  }
  double cosine_of_rest() const {
    const double z = x_ * x_;
    double series = 1.0 / 20922789888000;
    for (const double factor :
         {-1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24}) {
      series = factor + z * series;
    }
    const double half = 0.5 * z, rest = 1 - half;
    return rest + (((1 - rest) - half) + (z * z * series - x_ * low_));
  }

  int quarters_ = 0;
  double x_ = 0, low_ = 0;
};

/// For doubles. Promises: within 1 ulp for |angle| <= 2^20; within 2^-52 for others below 2^90.
inline SineCosine<double> sine_cosine(double angle) {
  const ReducedAngle reduced(angle);
  return {reduced.sine(), reduced.cosine()};
}
inline double sine(double angle) { return ReducedAngle(angle).sine(); }

/// For floats, by doubles.
inline SineCosine<float> sine_cosine(float angle) {
  const ReducedAngle reduced(static_cast<double>(angle));
  return {static_cast<float>(reduced.sine()), static_cast<float>(reduced.cosine())};
}
inline float sine(float angle) { return static_cast<float>(sine(static_cast<double>(angle))); }

/// The angle of the vector (x, y) in [0, pi], at a scalar that has its own. Requires: y >= 0.
template <class S>
S angle_of(const S& y, const S& x) {
  return atan2(y, x);
}

/// For doubles. Requires: y >= 0, not both 0, or NaN. Promises: within 1 ulp; NaN for NaN.
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
  const std::size_t index = ratio > 0.1875 ? static_cast<std::size_t>(ratio * 16 + 1) / 2 : 0;
  const double tangent = 0.125 * static_cast<double>(index);
  const DoubleDouble r = (DoubleDouble(shorter) - DoubleDouble(longer) * tangent) /
                         (DoubleDouble(longer) + DoubleDouble(shorter) * tangent);
  const double z = r.hi * r.hi;
  double series = 1.0 / 25;
  for (const double factor : {-1.0 / 23, 1.0 / 21, -1.0 / 19, 1.0 / 17, -1.0 / 15, 1.0 / 13, -1.0 / 11, 1.0 / 9,
                              -1.0 / 7, 1.0 / 5, -1.0 / 3}) {
    series = factor + z * series;
  }
  const DoubleDouble angle = eighths[index] + DoubleDouble::normalized(r.hi, r.lo + r.hi * z * series);
  if (steep) return (halved(half_turn) + (x < 0 ? angle : -angle)).hi;
  return x < 0 ? (half_turn - angle).hi : angle.hi;
}

/// For floats, by doubles.
inline float angle_of(float y, float x) {
  return static_cast<float>(angle_of(static_cast<double>(y), static_cast<double>(x)));
}

/// For double-doubles, by Taylor series after whole quarters of a turn. Promises: within 2^-96 for |angle| <= 2^20.
inline SineCosine<DoubleDouble> sine_cosine(const DoubleDouble& angle) {
  constexpr DoubleDouble quarter{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
  constexpr double rest_of_quarter = -0x1.f1976b7ed8fbcp-110;
  const double quarters = std::floor(angle.hi / quarter.hi + 0.5);
  if (!(std::abs(quarters) < 0x1p40)) {
    constexpr DoubleDouble none = std::numeric_limits<DoubleDouble>::quiet_NaN();
    return {none, none};
  }
  const DoubleDouble x = angle - quarter * quarters - DoubleDouble(quarters * rest_of_quarter), z = -(x * x), one(1.0);
  DoubleDouble odd = one, even = one;
  for (double k = 28; k > 0; k -= 2) {
    odd = one + z * odd / DoubleDouble(k * (k + 1));
    even = one + z * even / DoubleDouble(k * (k - 1));
  }
  odd = x * odd;
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 0: return {odd, even};
    case 1: return {even, -odd};
    case 2: return {-odd, -even};
    default: return {-even, odd};
  }
}
inline DoubleDouble sine(const DoubleDouble& angle) { return sine_cosine(angle).sine; }

/// For double-doubles: that of doubles, and the small rest when the vector is turned back by it. Requires: y >= 0, not
/// both 0. Promises: within 2^-98 of the angle.
inline DoubleDouble angle_of(const DoubleDouble& y, const DoubleDouble& x) {
  if (y.hi == 0) return x.hi > 0 ? DoubleDouble() : DoubleDouble(0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53);
  const DoubleDouble rough(angle_of(y.hi, x.hi));
  const auto [sine, cosine] = sine_cosine(rough);
  const DoubleDouble tangent = (y * cosine - x * sine) / (x * cosine + y * sine);
  return rough + tangent * (DoubleDouble(1.0) - tangent * tangent * DoubleDouble(1.0 / 3));
}

template <class S>
S pi() {
  return angle_of(S(0), S(-1));
}

/// A whole turn in degrees or radians. Requires: degrees, or a scalar with roots.
template <class S>
working_t<S> whole_turn(bool degrees) {
  if (degrees) return working_t<S>(360);
  if constexpr (std::is_same_v<S, double>) {
    return {0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52};
  } else if constexpr (has_roots<S>) {
    return S(2) * pi<S>();
  } else {
    return {};
  }
}

/// The greatest whole number that is not above a value.
template <class S>
S whole_below(const S& value) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::floor(value);
  } else {
    const S size = value < S(0) ? S(-value) : value;
    S whole(0), step(1);
    while (step <= size) step = step + step;
    for (; step >= S(1); step = step / S(2)) {
      if (whole + step <= size) whole = whole + step;
    }
    return value >= S(0) ? whole : S(whole == size ? -whole : S(-whole - S(1)));
  }
}

/// The whole turns that are nearest to an angle, as an angle.
template <class S, class W = working_t<S>>
W nearest_turns(const W& angle, bool degrees) {
  const W turn = whole_turn<S>(degrees);
  return turn * whole_below(S(high_part<S>(angle / turn) + S(1) / S(2)));
}

/// An angle without whole turns: from 0 to less than a whole turn, or if it is signed, from half a turn below 0.
template <class S>
S wrapped(const S& value, bool degrees, bool is_signed) {
  const working_t<S> turn = whole_turn<S>(degrees);
  const S whole = high_part<S>(turn), low = is_signed ? S(-whole / S(2)) : S(0), high = low + whole;
  if (value >= low && value < high) return value;
  const S turns = whole_below(S((value - low) / whole));
  const S result = high_part<S>(working_t<S>(value) - turn * working_t<S>(turns));
  return result >= high || result < low ? low : result;
}

}  // namespace tcb::spline
