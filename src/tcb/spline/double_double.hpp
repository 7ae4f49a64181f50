// Double-doubles: sums of two doubles as numbers of 106 bits; times, and the type in which a scalar is computed.
//
// Source: T. J. Dekker, "A floating-point technique for extending the available precision",
//   Numer. Math. 18 (1971), doi:10.1007/BF01397083; D. E. Knuth, TAOCP vol. 2, 4.2.2.
// Differs: the factors of a product are split by masking bits, which cannot overflow.
// Requires: round to nearest, no contraction (-ffp-contract=off), no -ffast-math.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <limits>

namespace tcb::spline {

/// A rounded result and the error that the rounding made: value + error is exact.
template <class S>
struct Rounded {
  S value, error;
};

/// a + b and its rounding error, for any magnitudes.
template <class S>
constexpr Rounded<S> two_sum(const S& a, const S& b) {
  const S sum = a + b;
  const S b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The upper 26 bits of a double; the other 27 are the difference.
inline constexpr std::uint64_t upper_half_mask = 0xFFFF'FFFF'F800'0000;
constexpr double upper_half(double value) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & upper_half_mask);
}

/// a * b and its rounding error (exact to 2^-104 of the product, unless something underflows).
template <class D>
constexpr Rounded<D> two_product(const D& a, const D& b) {
  const D a1 = upper_half(a);
  const D b1 = upper_half(b);
  const D a2 = a - a1;
  const D b2 = b - b1;
  const D product = a * b;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

/// The unevaluated sum hi + lo, |lo| <= ulp(hi)/2: about 106 bits. D is double, or a pair of doubles.
/// Promises: + and - are accurate to 2^-100 of the larger operand, * and / to 2^-100 of the result.
template <class D>
struct DoubleDoubleOf {
  D hi{0};
  D lo{0};

  constexpr DoubleDoubleOf() = default;
  constexpr DoubleDoubleOf(D value) : hi(value) {}  // NOLINT(google-explicit-constructor): a double converts
  constexpr DoubleDoubleOf(D high, D low) : hi(high), lo(low) {}

  friend constexpr DoubleDoubleOf operator-(const DoubleDoubleOf& a) { return {-a.hi, -a.lo}; }
  friend constexpr DoubleDoubleOf operator+(const DoubleDoubleOf& a, const DoubleDoubleOf& b) {
    const auto high = two_sum(a.hi, b.hi);
    return normalized(high.value, high.error + (a.lo + b.lo));
  }
  friend constexpr DoubleDoubleOf operator+(const DoubleDoubleOf& a, const D& b) {
    const auto high = two_sum(a.hi, b);
    return normalized(high.value, high.error + a.lo);
  }
  friend constexpr DoubleDoubleOf operator-(const DoubleDoubleOf& a, const DoubleDoubleOf& b) { return a + -b; }
  friend constexpr DoubleDoubleOf operator*(const DoubleDoubleOf& a, const DoubleDoubleOf& b) {
    const auto product = two_product(a.hi, b.hi);
    return normalized(product.value, product.error + (a.hi * b.lo + a.lo * b.hi));
  }
  friend constexpr DoubleDoubleOf operator*(const DoubleDoubleOf& a, const D& b) {
    const auto product = two_product(a.hi, b);
    return normalized(product.value, product.error + a.lo * b);
  }
  friend constexpr DoubleDoubleOf operator/(const DoubleDoubleOf& a, const DoubleDoubleOf& b) {
    const D quotient = a.hi / b.hi;
    const auto product = two_product(quotient, b.hi);
    const D remainder = ((a.hi - product.value) - product.error) + (a.lo - quotient * b.lo);  // the first - is exact
    return normalized(quotient, remainder / b.hi);
  }
  constexpr DoubleDoubleOf& operator+=(const DoubleDoubleOf& other) { return *this = *this + other; }
  constexpr DoubleDoubleOf& operator-=(const DoubleDoubleOf& other) { return *this = *this - other; }
  constexpr DoubleDoubleOf& operator*=(const DoubleDoubleOf& other) { return *this = *this * other; }
  constexpr DoubleDoubleOf& operator/=(const DoubleDoubleOf& other) { return *this = *this / other; }

  /// The whole number that it is.
  explicit constexpr operator int() const { return static_cast<int>(hi); }

  friend constexpr bool operator==(const DoubleDoubleOf&, const DoubleDoubleOf&) = default;
  friend constexpr auto operator<=>(const DoubleDoubleOf& a, const DoubleDoubleOf& b) {
    return a.hi == b.hi ? a.lo <=> b.lo : a.hi <=> b.hi;
  }

  /// high + low as a double-double. Requires: |high| >= |low|, or high a multiple of low's last bit.
  static constexpr DoubleDoubleOf normalized(D high, D low) {
    const D sum = high + low;
    return {sum, low - (sum - high)};
  }
};

using DoubleDouble = DoubleDoubleOf<double>;

/// The type in which tangents and local parameters are computed before they are rounded to S.
template <class S>
struct Working {
  using type = S;
};
template <>
struct Working<double> {
  using type = DoubleDouble;
};
template <class S>
using working_t = typename Working<S>::type;

/// A time. For double it holds every integer up to 2^106 exactly, so nanoseconds since 1970 do.
template <class S>
using Time = working_t<S>;

}  // namespace tcb::spline

template <>
struct std::numeric_limits<tcb::spline::DoubleDouble> {
  using Number = tcb::spline::DoubleDouble;
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false;
  static constexpr bool has_infinity = true, has_quiet_NaN = true;  // NOLINT(readability-identifier-naming)
  static constexpr int digits = 102, digits10 = 30;
  static constexpr Number epsilon() { return 0x1p-101; }
  static constexpr Number infinity() { return std::numeric_limits<double>::infinity(); }
  static constexpr Number quiet_NaN() {  // NOLINT(readability-identifier-naming): names of the standard
    return std::numeric_limits<double>::quiet_NaN();
  }
};
