// Scalars: double-double arithmetic, the working type of a scalar, and powers by square roots.
//
// Source: T. J. Dekker, "A floating-point technique for extending the available precision",
//   Numer. Math. 18 (1971), doi:10.1007/BF01397083; D. E. Knuth, TAOCP vol. 2, 4.2.2.
// Differs: the factors of a product are split by masking bits, which cannot overflow.
// Requires: round to nearest, no contraction (-ffp-contract=off), no -ffast-math.
#pragma once

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <type_traits>

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

/// Half of a number.
template <class W>
constexpr W halved(const W& value) {
  return W(0.5) * value;
}
constexpr DoubleDouble halved(const DoubleDouble& value) { return {0.5 * value.hi, 0.5 * value.lo}; }

/// The square root, accurate to 2^-100. Requires: value >= 0.
inline DoubleDouble sqrt(const DoubleDouble& value) {
  if (value.hi == 0) return {};
  const double root = std::sqrt(value.hi);
  const DoubleDouble remainder = value - DoubleDouble(root) * DoubleDouble(root);
  return DoubleDouble::normalized(root, remainder.hi / (2 * root));
}

/// x^exponent. With exponent = n + 0.b1 b2 b3... in binary, x^0.b1b2b3... is the nested root
/// sqrt(x^b1 sqrt(x^b2 sqrt(x^b3 ...))), computed from inside.
/// Requires: x > 0, 0 <= exponent <= 16. Promises: accurate to about 2^-95.
template <class W>
W power_by_roots(const W& x, double exponent) {
  constexpr int fraction_bits = 62;  // further bits change the exponent by less than 2^-62
  W whole_part(1.0);
  for (; exponent >= 1; exponent -= 1) whole_part = whole_part * x;
  auto bits = static_cast<std::uint64_t>(exponent * 0x1p62);
  const W root_of_x = sqrt(x);
  W root(1.0);
  for (int bit = 0; bit < fraction_bits; ++bit, bits >>= 1) {
    root = (bits & 1U) != 0 ? sqrt(root) * root_of_x : sqrt(root);
  }
  return whole_part * root;
}

/// x^exponent of a double-double, as power_by_roots() has it.
inline DoubleDouble power(const DoubleDouble& x, double exponent) { return power_by_roots(x, exponent); }

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

/// A scalar with square roots. Exact rationals have none; code that needs roots is not compiled for them.
template <class S>
inline constexpr bool has_roots = !std::numeric_limits<S>::is_exact;

/// A scalar that carries bounds on its errors, and refuses comparisons that these leave open.
template <class S>
inline constexpr bool bounds_errors = false;

/// Whether a number is 0, and known to be so.
template <class S>
bool is_exactly_zero(const S& number) {
  return number == S(0);
}

/// A time. For double it holds every integer up to 2^106 exactly, so nanoseconds since 1970 do.
template <class S>
using Time = working_t<S>;

/// A working value rounded to the scalar.
template <class S>
constexpr S high_part(const working_t<S>& value) {
  if constexpr (std::is_same_v<S, double>) {
    return value.hi;
  } else {
    return value;
  }
}

/// a - b, exact unless it overflows.
template <class S>
constexpr working_t<S> exact_difference(const S& a, const S& b) {
  if constexpr (std::is_same_v<S, double>) {
    const auto [value, error] = two_sum(a, -b);
    return {value, error};
  } else {
    return a - b;
  }
}

/// a - b, to within a rounding or two.
template <class S>
constexpr S difference(const working_t<S>& a, const working_t<S>& b) {
  if constexpr (std::is_same_v<S, double>) {
    return (a.hi - b.hi) + (a.lo - b.lo);
  } else {
    return a - b;
  }
}

/// The time from start to end, exact where both are doubles or whole numbers.
template <class S>
constexpr Time<S> elapsed(const Time<S>& start, const Time<S>& end) {
  if constexpr (std::is_same_v<S, double>) {
    const auto high = two_sum(end.hi, -start.hi);
    return DoubleDouble::normalized(high.value, high.error + (end.lo - start.lo));
  } else {
    return end - start;
  }
}

/// value times a power of two, exactly.
template <class S>
constexpr working_t<S> scaled(const working_t<S>& value, const S& power_of_two) {
  if constexpr (std::is_same_v<S, double>) {
    return {value.hi * power_of_two, value.lo * power_of_two};
  } else {
    return value * power_of_two;
  }
}

/// The larger of two numbers from which a unit is made; either, where a scalar with bounds on its errors cannot tell.
template <class S>
S rough_max(const S& a, const S& b) {
  return a < b ? b : a;
}

/// The largest power of two that is at most a number, but at least 2^-1000, so that its reciprocal is a double.
/// Requires: value > 0, finite.
template <class S>
S power_of_two_below(const S& value) {
  using std::frexp, std::ldexp;
  int exponent = 0;
  (void)frexp(value, &exponent);
  return ldexp(S(1), exponent > -999 ? exponent - 1 : -1000);
}
inline double power_of_two_below(double value) {
  constexpr std::uint64_t exponent = 0x7FF0'0000'0000'0000;
  const auto power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & exponent);  // 0 where subnormal
  return power > 0x1p-1000 ? power : 0x1p-1000;
}

/// What high_part() of a working value omits, rounded to the scalar.
template <class S>
constexpr S low_part(const working_t<S>& value) {
  if constexpr (std::is_same_v<S, double>) {
    return value.lo;
  } else {
    return S(0);
  }
}

}  // namespace tcb::spline
