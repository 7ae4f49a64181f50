// Decimals: from a double to the digits that stand for it, and from digits to the nearest double.
//
// Each product is one multiplication by a power of ten of 128 bits, of which the upper 128 bits are kept: F.
// That they are enough rests on two facts. The power is rounded up, by less than 2^-127 of itself, and the low bits
// of the product are cut off; so where the true product is whole or half, so is F. And nowhere else is the true
// product so near to a whole or a half that F lies on another side of it. This holds for all numbers that come here:
// tests/format/decimal_proof.py searches all powers for others, and finds none. Only shortest_if_easy() needs no
// proof: it leaves alone what is nearer to a limit than F may be wrong.
//
// Source: R. Giulietti, "The Schubfach way to render doubles" (2020); R. Cox, "Floating-point printing and parsing
//   can be simple and fast" (2026), https://research.swtch.com/fp; D. Lemire, doi:10.1002/spe.2984, and
//   N. Mushtak and D. Lemire, doi:10.1002/spe.3198, for reading.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>

#include "text/digits.hpp"
#include "text/power_of_ten.hpp"

namespace tcb {

/// digits 10^exponent.
struct Decimal {
  std::uint64_t digits;
  int exponent;
};

inline constexpr std::uint64_t infinity = 0x7FF0'0000'0000'0000;  ///< its bits

/// A positive double as m 2^q.
struct Binary {
  static constexpr std::uint64_t hidden = std::uint64_t{1} << 52;

  explicit Binary(double value)
      : bits(std::bit_cast<std::uint64_t>(value)),
        m(bits < hidden ? bits : bits % hidden + hidden),
        q(std::max(static_cast<int>(bits >> 52), 1) - 1075) {}

  std::uint64_t bits, m;
  int q;
};

/// The same number with 17 digits. Requires: 0 < digits < 10^17.
Decimal widened(const Decimal& decimal);

/// The decimal nearest to the value among the shortest ones that read back as it; zeros at its end fill it up to 17
/// digits. Requires: value > 0, finite.
Decimal shortest(double value);

/// (10 tens + last) 10^exponent.
struct SplitDecimal {
  std::uint64_t tens, last;
  int exponent;
};

/// The same in less time, with 16 or 17 digits; nothing where it takes more care, or the value is no number above 0.
inline std::optional<SplitDecimal> shortest_if_easy(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>(bits >> 52);
  const bool regular = (biased > 0) & (biased < 2047) & (bits % Binary::hidden != 0);
  if (!regular) return std::nullopt;  // a power of two, subnormal, or no number at all

  // In units of 10^-p the doubles that read back as the value fill an interval at least 1/10 and less than 1 wide: at
  // most one integer is in it, and is then shorter than all other decimals there.
  const int q = biased - 1075;
  const int p = -floor_log10_power_of_two(q) - 1;
  const Uint128 g = power_significand(p);
  const int shift = q + floor_log2_power_of_ten(p) + 4;  // 0 to 3
  const Uint128 product = high_product((bits % Binary::hidden + Binary::hidden) << shift, g);
  const auto whole = static_cast<std::uint64_t>(product >> 67);
  const auto part = static_cast<std::uint64_t>(product >> 3);  // in units of 2^-64, about one too small at most

  // How far the nearest integer is, against half the interval; and the nearest tenth. Their difference is wrong by
  // little more than one, and the tenths by ten: nearer than twice that to a limit, more care is due. A tenth that
  // rounds to a whole is inside then, as the interval is so wide.
  const std::uint64_t up = part >> 63;
  const std::uint64_t distance = part ^ -up;
  const std::uint64_t half = static_cast<std::uint64_t>(g >> 64) >> (4 - shift);
  const std::uint64_t tenths = part / 16 * 10 + (std::uint64_t{1} << 59);  // in units of 2^-60
  const bool certain = (distance - half + 2 > 4) & ((tenths + 20) % (std::uint64_t{1} << 60) > 20);
  if (!certain) return std::nullopt;
  const bool inside = distance < half;
  return SplitDecimal{whole + (up & (inside ? 1 : 0)), choose(inside, 0, tenths >> 60), -p - 1};
}

/// value 10^p, rounded to an integer, half to even.
/// Requires: the value positive; p from -308 to 340; the result below 2^60, and 0 if the value is subnormal.
inline std::uint64_t rounded(double value, int p) {
  const Binary v(value);
  const Uint128 product = high_product(v.m << 11, power_significand(p));
  const int point = 74 - v.q - floor_log2_power_of_ten(p);  // how many bits of the product are behind it
  if (point > 128) return 0;                                // less than a half
  const Uint128 doubled = product >> (point - 1);
  const bool inexact = doubled << (point - 1) != product;
  const auto whole = static_cast<std::uint64_t>(doubled >> 1);
  return whole + (doubled % 2 != 0 && (inexact || whole % 2 != 0) ? 1 : 0);
}

/// The double nearest to a decimal, half to even; not a number where it would be subnormal, zero or too large.
/// Requires: digits > 0.
inline double nearest(const Decimal& decimal) {
  const int p = decimal.exponent;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (p < least_power || p > 308) return unknown;
  const int shift = std::countl_zero(decimal.digits);
  const Uint128 product = high_product(decimal.digits << shift, power_significand(p));
  const auto high = static_cast<std::uint64_t>(product >> 64);
  const auto low = static_cast<std::uint64_t>(product);
  const int carry = static_cast<int>(high >> 63);
  const std::uint64_t top = high << (1 - carry) | (low != 0 ? 1 : 0);  // its last bit stands for all that follow
  const int exponent = floor_log2_power_of_ten(p) - shift + carry + 1086;
  if (exponent < 1 || exponent > 2046) return unknown;
  const std::uint64_t m = top / 2048;
  const std::uint64_t up = (top % 2048 + 1023 + m % 2) / 2048;  // half to even
  const std::uint64_t bits = (static_cast<std::uint64_t>(exponent) << 52) + (m - Binary::hidden) + up;
  return bits < infinity ? std::bit_cast<double>(bits) : unknown;
}

}  // namespace tcb
