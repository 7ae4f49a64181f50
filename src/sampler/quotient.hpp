// The quotient of two integers, rounded once: the only rounding that a row's time undergoes.
#pragma once

#include <bit>
#include <cstdint>

#include "spline/scalar.hpp"

namespace tcb::sampler {

__extension__ using Int128 = __int128;

/// How many bits a positive integer has.
template <class Int>
int bit_width(const Int& value) {
  return static_cast<int>(msb(value)) + 1;
}
inline int bit_width(const Int128& value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  const auto low = static_cast<std::uint64_t>(value);
  return static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(low));
}

/// 2^exponent, for exponents in [-1022, 1023].
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// value * 2^exponent, exactly. Requires: value <= 2^53, and a result that a double can hold.
inline double scaled(double value, int exponent) {
  for (; exponent < -1022; exponent += 1022) value *= power_of_two(-1022);
  for (; exponent > 1023; exponent -= 1023) value *= power_of_two(1023);
  return value * power_of_two(exponent);
}

/// n / d rounded to the nearest whole number, ties to even. Requires: n >= 0, d > 0.
template <class Int>
Int nearest_whole(const Int& n, const Int& d) {
  const Int quotient = n / d;
  const Int twice_rest = (n - quotient * d) * 2;
  const bool up = twice_rest > d || (twice_rest == d && (quotient % 2) != 0);
  return up ? Int(quotient + 1) : quotient;
}

/// A whole number of at most 106 bits as a time, exactly. Requires: n >= 0.
template <class Int>
spline::Time<double> whole_time(const Int& n) {
  const auto high = static_cast<double>(n);
  return spline::Twice::normalized(high, static_cast<double>(n - Int(high)));
}

/// n * 2^shift, for a shift to either side. Requires: nothing is lost to the right.
template <class Int>
Int shifted(const Int& n, int shift) {
  return shift > 0 ? Int(n << shift) : n;
}

/// n / d as the nearest double, ties to even. Requires: n > 0, d > 0.
template <class Int>
double nearest_double(const Int& n, const Int& d) {
  // Scale n/d by a power of two so that its whole part has the 53 bits of a double (fewer where the
  // double is subnormal), then round to a whole number.
  constexpr int bits = 53;
  constexpr int last_bit = 1074;  // the smallest double is 2^-1074
  int shift = bits - (bit_width(n) - bit_width(d));
  if (shifted<Int>(n, shift) >> bits >= shifted<Int>(d, -shift)) --shift;
  if (shift > last_bit) shift = last_bit;
  const Int whole = nearest_whole<Int>(shifted<Int>(n, shift), shifted<Int>(d, -shift));
  return scaled(static_cast<double>(whole), -shift);
}

/// n / d as the nearest time: a double, or beyond 2^53 the nearest whole number. Requires: d > 0.
template <class Int>
spline::Time<double> nearest_quotient(const Int& n, const Int& d) {
  if (n == 0) return {0.0};
  const Int size = n < 0 ? Int(-n) : n;
  const bool beyond_doubles = size >> 53 >= d;
  const spline::Time<double> time = beyond_doubles ? whole_time<Int>(nearest_whole<Int>(size, d))
                                                   : spline::Time<double>(nearest_double<Int>(size, d));
  return n < 0 ? -time : time;
}

}  // namespace tcb::sampler
