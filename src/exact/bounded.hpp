// Bounded: a double-double with a bound on its error, for numbers without roots.
//
// Every operation adds a bound on its own error to those of its operands, so that the value is proved to be within
// `error` of the exact one. The bounds on the operations of double-doubles are at least twice those of the analysis in
//   M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
//   arithmetic", ACM Trans. Math. Softw. 44 (2017), doi:10.1145/3121432,
// and leave room for the operations of tcb/spline/double_double.hpp, which differ from theirs. Numbers compare by their
// values: where that may be wrong, both ways must lead to the same result, as they do where a cubic is expanded about
// either end. What overflows has no finite error, and decides nothing.
#pragma once

#include <cmath>
#include <compare>
#include <concepts>
#include <limits>

#include "tcb/spline/double_double.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

struct Bounded {
  spline::DoubleDouble value = {};
  double error = 0;

  Bounded() = default;
  Bounded(double number) : value(number) {}  // NOLINT(google-explicit-constructor): a double converts
  /// Requires: |number| < 2^53.
  template <std::integral Integer>
  explicit Bounded(Integer number) : value(static_cast<double>(number)) {}
  Bounded(const spline::DoubleDouble& middle, double bound) : value(middle), error(bound) {}

  /// It is exactly 0.
  bool is_zero() const { return value.hi == 0 && error == 0; }
  bool may_be_zero() const { return !(least() > 0); }
  /// No number within the bound is larger in size, or smaller; this is 0 or less where 0 is within it.
  double most() const { return up(std::abs(value.hi) + error); }
  double least() const { return (1 - 0x1p-50) * std::abs(value.hi) - error; }

  friend Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    if (b.is_zero()) return a;
    if (a.is_zero()) return b;
    const bool is_exact = a.value.lo == 0 && b.value.lo == 0;  // by Knuth's sum
    const double own = is_exact ? 0 : 0x1p-101 * (std::abs(a.value.hi) + std::abs(b.value.hi)) + underflow;
    return {a.value + b.value, up(a.error + b.error + own)};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const spline::DoubleDouble product = a.value * b.value;
    const double given = a.error * std::abs(b.value.hi) + b.error * std::abs(a.value.hi) + a.error * b.error;
    return {product, up(given + 0x1p-100 * std::abs(product.hi) + underflow)};
  }
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const double divisor = b.least();
    if (!(divisor > smallest_divisor)) return {a.value / b.value, std::numeric_limits<double>::infinity()};
    if (a.is_zero()) return {};
    const spline::DoubleDouble quotient = a.value / b.value;
    const double given = (a.error + std::abs(quotient.hi) * b.error + underflow) / divisor;
    return {quotient, up(up(given) + 0x1p-99 * std::abs(quotient.hi)) + smallest};
  }
  Bounded& operator+=(const Bounded& other) { return *this = *this + other; }
  Bounded& operator-=(const Bounded& other) { return *this = *this - other; }
  Bounded& operator*=(const Bounded& other) { return *this = *this * other; }
  Bounded& operator/=(const Bounded& other) { return *this = *this / other; }

  friend Bounded abs(const Bounded& a) { return a.value.hi < 0 ? -a : a; }
  /// Only numbers without errors are known to be equal.
  friend bool operator==(const Bounded& a, const Bounded& b) {
    return a.value == b.value && a.error == 0 && b.error == 0;
  }
  friend std::partial_ordering operator<=>(const Bounded& a, const Bounded& b) { return a.value <=> b.value; }

 private:
  /// More than a sum of positive numbers that was rounded a few times.
  static double up(double sum) { return sum * (1 + 0x1p-48); }

  static constexpr double underflow = 0x1p-1000;  ///< more than what products lose there
  static constexpr double smallest_divisor = 0x1p-500;
  static constexpr double smallest = 0x1p-1074;  ///< more than what quotients of errors lose there
};

/// The greatest whole number that is not above a number; without a finite error where the bound leaves a choice.
inline Bounded whole_below(const Bounded& number) {
  const spline::DoubleDouble whole = floor(number.value), beyond = number.value - whole;
  const bool is_clear = beyond.hi >= number.error && (number.error == 0 || 1 - beyond.hi > 2 * number.error);
  return {whole, is_clear ? 0 : std::numeric_limits<double>::infinity()};
}
inline Bounded floor(const Bounded& number) { return whole_below(number); }

/// An angle without whole turns, as tcb/spline/angle.hpp has it. Requires: degrees, as radians are not rational.
inline Bounded wrapped(const Bounded& angle, bool /*degrees*/, bool is_signed) {
  const Bounded turn(360.0), low(is_signed ? -180.0 : 0.0);
  return angle - turn * whole_below((angle - low) / turn);
}

}  // namespace tcb

/// As for rationals: code that needs roots is not compiled for it.
template <>
struct std::numeric_limits<tcb::Bounded> {
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = true;
  static constexpr int digits = 100, digits10 = 30;
};
