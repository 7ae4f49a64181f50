// Doubles to try numbers with: those at the edges of all exponents, those that are known to be hard, and random ones.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace tcb {

inline double from_text(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Calls what for the value and three finite neighbours on each side, with both signs.
template <class What>
void around(double value, const What& what) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  for (std::int64_t other = std::max<std::int64_t>(bits - 3, 0); other <= bits + 3; ++other) {
    if (!std::isfinite(std::bit_cast<double>(other))) return;
    what(std::bit_cast<double>(other));
    what(-std::bit_cast<double>(other));
  }
}

/// The first, middle and last doubles of every exponent, and the powers of ten.
template <class What>
void for_all_edges(const What& what) {
  constexpr std::uint64_t binade = std::uint64_t{1} << 52;
  for (std::uint64_t bits = 0; bits < 2047 * binade; bits += binade) {
    around(std::bit_cast<double>(bits), what);
    around(std::bit_cast<double>(bits + binade / 2), what);
  }
  for (int i = 0; i < 52; ++i) around(std::bit_cast<double>(std::uint64_t{1} << i), what);  // subnormal
  for (int p = -323; p <= 308; ++p) {
    for (int digit = 1; digit <= 9; ++digit) {
      if (p < 308 || digit == 1) around(from_text(std::to_string(digit) + "e" + std::to_string(p)), what);
    }
  }
}

/// Integers near powers of two and at 2^53, and doubles that caught out printers and readers before: from
/// V. Paxson, "A program for testing IEEE decimal-binary conversion" (1991), and the tests of Ryu and Grisu.
template <class What>
void for_hard_ones(const What& what) {
  for (int i = 0; i < 70; ++i) around(std::ldexp(1.0, i), what);
  for (int i = -100; i <= 100; ++i) what(9007199254740992.0 + i);
  for (const double value : {9.5e-3,
                             5e-324,
                             2.2250738585072014e-308,
                             2.2250738585072011e-308,
                             1.7976931348623157e308,
                             4.1855804968213567e298,
                             5.5626846462680035e-309,
                             2.109808898695963e16,
                             4.940656e-318,
                             1.18575755e-316,
                             2.989102097996e-312,
                             9.0608011534336e15,
                             4.708356024711512e18,
                             9.409340012568248e18,
                             1.2345678e0,
                             5.764607523034235e39,
                             1.152921504606847e40,
                             2.305843009213694e40,
                             9007199254740991.0,
                             1.8014398509481984e16,
                             2.9802322387695312e-8,
                             7.120190517612959e63,
                             8.41e21,
                             2.0919495182368195e19,
                             2.6153245263757307e19,
                             3.5844466002796428e298,
                             4.35e-5,
                             1.9156918820264798e-56,
                             5.0052077379577523e-147,
                             6.080469016670379e-260,
                             9.5367431640625e-7,
                             8.589973428413488e9,
                             1.3076622631878654e65,
                             4.611686018427388e19,
                             1e22,
                             1e23,
                             123456789012345678.0,
                             3.0540412e5,
                             8.0990312e3,
                             4.4501477170144023e-308,
                             1.234e-7}) {
    around(value, what);
  }
}

/// Random doubles of the kinds that tables hold.
class RandomDoubles {
 public:
  explicit RandomDoubles(std::uint64_t seed) : random_(seed) {}

  std::uint64_t bits() { return random_(); }

  /// Any double but infinities and NaN.
  double any() {
    for (;;) {
      const auto value = std::bit_cast<double>(random_());
      if (std::isfinite(value)) return value;
    }
  }

  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  /// A few digits, with the point somewhere.
  double short_decimal() {
    const auto digits = static_cast<std::int64_t>(random_()) % whole_power(1 + random_() % 12);
    return static_cast<double>(digits) / static_cast<double>(whole_power(random_() % 10));
  }

  /// A random mantissa at the exponents where coordinates and times are.
  double near() { return std::ldexp(1 + unit(), static_cast<int>(random_() % 120) - 50); }

 private:
  static std::int64_t whole_power(std::uint64_t n) {
    std::int64_t power = 1;
    for (; n > 0; --n) power *= 10;
    return power;
  }

  std::mt19937_64 random_;
};

}  // namespace tcb
