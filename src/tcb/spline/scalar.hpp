// Scalars: what the templates of curves need of a number besides its arithmetic, and powers by square roots.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "tcb/spline/double_double.hpp"

namespace tcb::spline {

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

/// How the square root of a scalar is computed: by sqrt() of its type, unless there is another way.
template <class S>
struct SquareRoot {
  static S of(const S& value) {
    using std::sqrt;
    return sqrt(value);
  }
};

template <class S>
S square_root(const S& value) {
  return SquareRoot<S>::of(value);
}

inline DoubleDouble abs(const DoubleDouble& value) { return value.hi < 0 ? -value : value; }

/// The largest whole number up to a value.
inline DoubleDouble floor(const DoubleDouble& value) {
  const double whole = std::floor(value.hi);
  return whole == value.hi ? DoubleDouble::normalized(whole, std::floor(value.lo)) : DoubleDouble(whole);
}

inline DoubleDouble ldexp(const DoubleDouble& value, int exponent) {
  return {std::ldexp(value.hi, exponent), std::ldexp(value.lo, exponent)};
}
/// The exponent is that of the high part.
inline DoubleDouble frexp(const DoubleDouble& value, int* exponent) {
  (void)std::frexp(value.hi, exponent);
  return ldexp(value, -*exponent);
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

/// A scalar with square roots. Exact rationals have none; code that needs roots is not compiled for them.
template <class S>
inline constexpr bool has_roots = !std::numeric_limits<S>::is_exact;

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
