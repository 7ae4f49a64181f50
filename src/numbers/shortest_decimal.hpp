// Shortest decimals: from a double to the decimal digits that identify it, and from digits to the bytes of their text.
//
// Powers of ten have 128 bits:
//   10^p = g 2^(floor(log2 10^p) - 127) (1 - d),  2^127 <= g < 2^128,  0 <= d < 2^-127,  d = 0 for 0 <= p <= 55
//
// Each conversion is one multiplication m g, of which the upper 128 bits are kept: F. They are enough because
//   1. g is rounded up, by less than 2^-127 of itself, and the low bits of the product are cut off. Hence F is whole,
//   or
//      half of a whole, where the exact product is.
//   2. No other exact product is so near to a whole or a half that F is on its other side.
//   tests/numbers/decimal_proof.py
//      searches all powers and finds none.
// shortest_if_easy() needs no proof: it returns nothing if a limit is nearer than the error of F.
//
// Source: R. Giulietti, "The Schubfach way to render doubles" (2020); R. Cox, "Floating-point printing and parsing
//   can be simple and fast" (2026), https://research.swtch.com/fp; for digits to bytes the divisions by multiplication
//   of H. S. Warren, Hacker's Delight, ch. 10, on two, four and eight fields of a word at once.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace tcb {

__extension__ using Uint128 = unsigned __int128;

// Powers of ten.

inline constexpr int least_power = -308;  ///< those that 17 digits of a double need
inline constexpr int most_power = 340;

/// The significands g of the formula above, from least_power on.
inline constexpr auto power_significands = [] {
  // Significands of 256 bits, high 2^128 + low, normalized so that the highest bit is set: powers of two do not matter
  // here. The steps lose less than 12 units of the last bit, so the upper 128 bits are right.
  struct Wide {
    Uint128 high, low;
    constexpr Wide shifted_right(int bits) const { return {high >> bits, low >> bits | high << (128 - bits)}; }
    constexpr Wide normalized() const {
      return high >> 127 != 0 ? *this : Wide{high << 1 | low >> 127, low << 1}.normalized();
    }
    constexpr Wide times_five() const {  // 5 / 8 is 1 / 2 + 1 / 8
      const Wide half = shifted_right(1), eighth = shifted_right(3);
      const Uint128 sum = half.low + eighth.low;
      return Wide{half.high + eighth.high + (sum < half.low ? 1 : 0), sum}.normalized();
    }
    constexpr Wide fifth() const {
      constexpr Uint128 fifth_of_2_to_128 = ~Uint128{0} / 5;  // remainder 1
      const Uint128 rest = high % 5;
      return Wide{high / 5, rest * fifth_of_2_to_128 + low / 5 + (rest + low % 5) / 5}.normalized();
    }
    constexpr Uint128 rounded_up() const { return high + (low != 0 ? 1 : 0); }
  };
  std::array<Uint128, most_power - least_power + 1> table{};
  constexpr Wide one{Uint128{1} << 127, 0};
  auto entry = table.begin() - least_power;
  for (Wide w = one; entry != table.end(); w = w.times_five()) *entry++ = w.rounded_up();
  entry = table.begin() - least_power;
  for (Wide w = one; entry != table.begin();) *--entry = (w = w.fifth()).rounded_up();
  return table;
}();

/// Requires: least_power <= p <= most_power.
inline Uint128 power_significand(int p) { return power_significands[static_cast<std::size_t>(p - least_power)]; }

// The factors approximate logarithms; exact for |q| <= 1200 and |p| <= 400, as the tests show.
constexpr int floor_log2_power_of_ten(int p) { return (p * 1741647) >> 19; }
constexpr int floor_log10_power_of_two(int q) { return (q * 1262611) >> 22; }
constexpr int floor_log10_of_three_quarters(int q) { return (q * 1262611 - 524031) >> 22; }  ///< of 3/4 2^q

inline constexpr auto whole_powers_of_ten = [] {
  std::array<std::uint64_t, 20> table{1};
  for (std::size_t i = 1; i < table.size(); ++i) table[i] = 10 * table[i - 1];
  return table;
}();

/// 10^n as an integer. Requires: 0 <= n <= 19.
constexpr std::uint64_t whole_power_of_ten(int n) { return whole_powers_of_ten[static_cast<std::size_t>(n)]; }

/// The product of 64 and 128 bits without its lowest 64 bits.
inline Uint128 high_product(std::uint64_t x, Uint128 g) {
  const auto high = static_cast<std::uint64_t>(g >> 64);
  const auto low = static_cast<std::uint64_t>(g);
  return static_cast<Uint128>(x) * high + ((static_cast<Uint128>(x) * low) >> 64);
}

// Doubles to decimals.

/// digits 10^exponent.
struct Decimal {
  std::uint64_t digits;
  int exponent;
};

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

/// One of two numbers, without a branch that the processor could not predict.
constexpr std::uint64_t choose(bool first, std::uint64_t a, std::uint64_t b) {
  return b ^ ((a ^ b) & -static_cast<std::uint64_t>(first));
}

/// A number with 17 digits in place of fewer. Requires: 0 < digits < 10^17.
inline Decimal widened(const Decimal& decimal) {
  const int below = (static_cast<int>(std::bit_width(decimal.digits)) * 1233) >> 12;  // 1233 / 2^12: the logarithm of 2
  const int width = below + (decimal.digits >= whole_power_of_ten(below) ? 1 : 0);
  return {decimal.digits * whole_power_of_ten(17 - width), decimal.exponent - (17 - width)};
}

/// The decimal nearest to the value among the shortest ones that read back as it, with zeros at its end up to 17
/// digits. Not inlined: few numbers need it. Requires: value > 0, finite.
[[gnu::noinline]] inline Decimal shortest(double value) {
  const Binary v(value);
  const bool odd = v.m % 2 != 0;
  const bool at_power_of_two = v.m == Binary::hidden && v.bits > Binary::hidden;  // the double below is nearer

  // In units of 10^-p the doubles that read back as the value fill an interval at least 1 and less than 10 wide: at
  // most one of its integers ends in 0, and is then shorter than all others. With 70 bits after the point no product
  // seems to be whole, or half, that is not.
  const int p = -(at_power_of_two ? floor_log10_of_three_quarters(v.q) : floor_log10_power_of_two(v.q));
  const Uint128 g = power_significand(p);
  const int shift = v.q + floor_log2_power_of_ten(p) + 5;
  constexpr int point = 70;
  const auto scaled = [&](std::uint64_t quarters) { return high_product(quarters << shift, g); };

  const Uint128 middle = scaled(4 * v.m);
  const Uint128 lower = scaled(4 * v.m - (at_power_of_two ? 1 : 2)) - (odd ? 0 : 1);  // an even m has its ends
  const Uint128 upper = scaled(4 * v.m + 2) - (odd ? 1 : 0);
  const auto below = static_cast<std::uint64_t>(lower >> point);
  const auto last = static_cast<std::uint64_t>(upper >> point);
  const auto whole = static_cast<std::uint64_t>(middle >> point);
  constexpr Uint128 almost_half = (Uint128{1} << (point - 1)) - 1;
  const auto nearest = static_cast<std::uint64_t>((middle + almost_half + whole % 2) >> point);

  const std::uint64_t round = last / 10 * 10;
  return widened({round > below ? round : std::max(nearest, below + 1), -p});
}

/// (10 tens + last) 10^exponent.
struct SplitDecimal {
  std::uint64_t tens, last;
  int exponent;
};

/// The shortest decimal in less time, where it has 16 or 17 digits; nothing if that is not certain, or the value is not
/// above 0.
inline std::optional<SplitDecimal> shortest_if_easy(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>(bits >> 52);
  const bool regular = (biased > 0) & (biased < 2047) & (bits % Binary::hidden != 0);
  if (!regular) return std::nullopt;  // a power of two, subnormal, or not finite

  // In units of 10^-p the doubles that read back as the value fill an interval at least 1/10 and less than 1 wide: at
  // most one integer is in it, and is then shorter than all other decimals there.
  const int q = biased - 1075;
  const int p = -floor_log10_power_of_two(q) - 1;
  const Uint128 g = power_significand(p);
  const int shift = q + floor_log2_power_of_ten(p) + 4;  // 0 to 3
  const Uint128 product = high_product((bits % Binary::hidden + Binary::hidden) << shift, g);
  const auto whole = static_cast<std::uint64_t>(product >> 67);
  const auto part = static_cast<std::uint64_t>(product >> 3);  // in units of 2^-64, about one too small at most

  // The distance of the nearest integer, against half the interval; and the nearest tenth. The error of their
  // difference is little more than one unit, that of the tenths ten: within twice that of a limit the result is not
  // certain. A tenth that rounds to a whole is inside then, as the interval is so wide.
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
  const int point = 74 - v.q - floor_log2_power_of_ten(p);  // how many bits of the product follow the point
  if (point > 128) return 0;                                // less than a half
  const Uint128 doubled = product >> (point - 1);
  const bool inexact = doubled << (point - 1) != product;
  const auto whole = static_cast<std::uint64_t>(doubled >> 1);
  return whole + (doubled % 2 != 0 && (inexact || whole % 2 != 0) ? 1 : 0);
}

// Digits to bytes.

static_assert(std::endian::native == std::endian::little, "the first digit is the lowest byte of a word");

inline constexpr std::uint64_t eight_zeros = 0x3030303030303030;  ///< "00000000"

/// The digits of n in eight bytes, the first digit lowest. Requires: n < 10^8.
constexpr std::uint64_t eight_digits(std::uint64_t n) {
  // Each step halves the fields: a = 100 q + r becomes q + (r << 16), as (a << 16) - q ((100 << 16) - 1).
  const std::uint64_t upper = (n * 109951163) >> 40;  // 109951163 / 2^40: a ten-thousandth
  const std::uint64_t fours = (n << 32) - upper * ((10000ULL << 32) - 1);
  const std::uint64_t hundreds = ((fours * 10486) >> 20) & 0x0000007F0000007F;  // 10486 / 2^20: a hundredth
  const std::uint64_t twos = (fours << 16) - hundreds * ((100ULL << 16) - 1);
  const std::uint64_t tens = ((twos * 103) >> 10) & 0x000F000F000F000F;  // 103 / 2^10: a tenth
  return (twos << 8) - tens * ((10ULL << 8) - 1);
}

/// Sixteen digits of a number below 10^16, on any processor.
class SixteenDigitsInWords {
 public:
  explicit SixteenDigitsInWords(std::uint64_t n)
      : early_(eight_digits(n / 100'000'000)), late_(eight_digits(n % 100'000'000)) {}

  /// How many there are without the zeros at the end, but one at least; 17 if one more follows that is not zero.
  int count(bool more) const {
    const int zeros = (late_ != 0 ? std::countl_zero(late_) : 64 + std::countl_zero(early_ | 1)) / 8;
    return 17 - (zeros + 1) * (more ? 0 : 1);
  }

  /// Writes all of them, the first one first.
  void write(char* out) const {
    const std::uint64_t words[] = {early_ | eight_zeros, late_ | eight_zeros};
    std::memcpy(out, words, sizeof words);
  }

 private:
  std::uint64_t early_, late_;  ///< the first digit lowest
};

#if defined(__SSE2__)

/// Sixteen digits in the vectors of every 64-bit x86.
class SixteenDigitsInVector {
 public:
  explicit SixteenDigitsInVector(std::uint64_t n) {
    // Each step halves the fields: of a = d q + r, q stays in the lower half, and r goes to the upper.
    const std::uint64_t eight = n / 100'000'000;
    const auto two_eights = _mm_set_epi64x(signed_bits(n - eight * 100'000'000), signed_bits(eight));
    const auto upper = _mm_srli_epi64(_mm_mul_epu32(two_eights, _mm_set1_epi64x(109951163)), 40);  // / 2^40: 10^-4
    const auto lower = _mm_sub_epi32(two_eights, _mm_mul_epu32(upper, _mm_set1_epi64x(10000)));
    const auto fours = _mm_or_si128(upper, _mm_slli_epi64(lower, 32));
    const auto hundreds = _mm_srli_epi16(_mm_mulhi_epu16(fours, _mm_set1_epi16(5243)), 3);  // / 2^19: 10^-2
    const auto below = _mm_sub_epi16(fours, _mm_mullo_epi16(hundreds, _mm_set1_epi32(100)));
    const auto twos = _mm_or_si128(hundreds, _mm_slli_epi32(below, 16));
    const auto tens = _mm_mulhi_epu16(twos, _mm_set1_epi16(6554));  // / 2^16: 10^-1
    const auto ones = _mm_sub_epi16(twos, _mm_mullo_epi16(tens, _mm_set1_epi16(10)));
    digits_ = _mm_or_si128(tens, _mm_slli_epi16(ones, 8));
  }

  int count(bool more) const {
    const auto others = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpgt_epi8(digits_, _mm_setzero_si128())));
    return 32 - std::countl_zero(static_cast<unsigned>(more) << 16 | others | 1);
  }

  void write(char* out) const {
    const auto text = _mm_or_si128(digits_, _mm_set1_epi8('0'));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), text);
  }

 private:
  static long long signed_bits(std::uint64_t n) { return static_cast<long long>(n); }

  __m128i digits_;  ///< the first one lowest
};

using SixteenDigits = SixteenDigitsInVector;

#else

using SixteenDigits = SixteenDigitsInWords;

#endif

}  // namespace tcb
