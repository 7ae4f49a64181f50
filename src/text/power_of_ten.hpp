// Powers of ten to 128 bits, made by the compiler.
//
//   10^p = g 2^(floor(log2 10^p) - 127) (1 - d),  2^127 <= g < 2^128,  0 <= d < 2^-127,  d = 0 for 0 <= p <= 55
#pragma once

#include <array>
#include <cstdint>

namespace tcb {

__extension__ using Uint128 = unsigned __int128;

/// The powers that decimals of 17 digits need on their way out, and those of 19 digits on their way in.
inline constexpr int least_power = -342;
inline constexpr int most_power = 340;

extern const std::array<Uint128, most_power - least_power + 1> power_significands;

/// g of the formula above. Requires: least_power <= p <= most_power.
inline Uint128 power_significand(int p) { return power_significands[static_cast<std::size_t>(p - least_power)]; }

// Each quotient stands for the logarithm; exact for |q| <= 1200 and |p| <= 400, as the tests show.
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

}  // namespace tcb
