// Operands of arithmetic with bounds on its errors, for tests: of any size, at the edges of their bounds, and
// cancelling.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "exact/float_scalar.hpp"
#include "tcb/spline/double_double.hpp"

namespace tcb {

using Exact = Float<664>;

inline Exact exactly(const spline::DoubleDouble& number) { return Exact(number.hi) + Exact(number.lo); }

/// Makes numbers of a type with a bound, from a double-double and the bound, and exact ones within it.
template <class T>
class HostileOperands {
 public:
  struct Operand {
    Exact number;
    T held;
  };

  explicit HostileOperands(unsigned seed) : random_(seed) {}

  /// Doubles and double-doubles of any size, with and without a bound, whose low part may be at its limit.
  Operand next() {
    const double high = std::ldexp(sign() * (1 + unit()), static_cast<int>(random_() % 200) - 100);
    const double largest_low = std::abs(high) * 0x1p-54;
    const int kind = static_cast<int>(random_() % 4);
    const double low = kind == 0 ? 0 : kind == 1 ? sign() * largest_low : sign() * unit() * largest_low;
    const double bound = random_() % 3 == 0 ? 0 : std::ldexp(std::abs(high), -static_cast<int>(random_() % 120));
    const double at = random_() % 2 == 0 ? sign() : 2 * unit() - 1;  // the edge of the bound, or inside
    const auto near = spline::DoubleDouble::normalized(high, low);
    return {exactly(near) + Exact(at) * Exact(bound), T(near, bound)};
  }

  /// Nearly the negative of a double-double.
  Operand negative(const spline::DoubleDouble& other) {
    const double high = -std::nextafter(other.hi, sign() * std::numeric_limits<double>::infinity());
    const auto near = spline::DoubleDouble::normalized(high, random_() % 2 == 0 ? -other.lo : 0);
    return {exactly(near), T(near, 0.0)};
  }

 private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double sign() { return random_() % 2 == 0 ? 1 : -1; }

  std::mt19937_64 random_;
};

}  // namespace tcb
