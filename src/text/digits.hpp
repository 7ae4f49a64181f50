// Eight digits at a time: from a number to the bytes of its text and back, by arithmetic on all bytes at once.
//
// Source: for printing, the divisions by multiplication of H. S. Warren, Hacker's Delight, ch. 10, in two, four
//   and eight lanes, and for zero bytes ch. 6; for reading, the sums of neighbours in D. Lemire, doi:10.1002/spe.2984.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "text/power_of_ten.hpp"

namespace tcb {

static_assert(std::endian::native == std::endian::little, "the first digit is the lowest byte of a word");

inline constexpr std::uint64_t eight_zeros = 0x3030303030303030;  ///< "00000000"

/// The digits of n in eight bytes, the first digit lowest. Requires: n < 10^8.
constexpr std::uint64_t eight_digits(std::uint64_t n) {
  // Each step cuts the lanes in two: a = 100 q + r becomes q + (r << 16), as (a << 16) - q ((100 << 16) - 1).
  const std::uint64_t upper = (n * 109951163) >> 40;  // 109951163 / 2^40: a ten-thousandth
  const std::uint64_t fours = (n << 32) - upper * ((10000ULL << 32) - 1);
  const std::uint64_t hundreds = ((fours * 10486) >> 20) & 0x0000007F0000007F;  // 10486 / 2^20: a hundredth
  const std::uint64_t twos = (fours << 16) - hundreds * ((100ULL << 16) - 1);
  const std::uint64_t tens = ((twos * 103) >> 10) & 0x000F000F000F000F;  // 103 / 2^10: a tenth
  return (twos << 8) - tens * ((10ULL << 8) - 1);
}

/// The number that eight digits stand for, the first digit lowest.
constexpr std::uint64_t number_of(std::uint64_t digits) {
  const std::uint64_t twos = digits * 10 + (digits >> 8);  // in every other byte
  constexpr std::uint64_t lanes = 0x000000FF000000FF;
  const std::uint64_t odd = (twos & lanes) * ((1'000'000ULL << 32) + 100);
  const std::uint64_t even = ((twos >> 16) & lanes) * ((10'000ULL << 32) + 1);
  return (odd + even) >> 32;
}

/// All eight bytes are below 10.
constexpr bool are_digits(std::uint64_t values) {
  return (((values + 0x7676767676767676) | values) & 0x8080808080808080) == 0;  // 0x76 + 9 = 0x7F
}

/// Marks the first of eight bytes that is zero by its upper bit, and none before it; marks behind it may be wrong.
constexpr std::uint64_t zero_bytes(std::uint64_t bytes) {
  return (bytes - 0x0101010101010101) & ~bytes & 0x8080808080808080;
}

/// One of two numbers, without a branch where the processor could not foresee it.
constexpr std::uint64_t choose(bool first, std::uint64_t a, std::uint64_t b) {
  return b ^ ((a ^ b) & -static_cast<std::uint64_t>(first));
}

template <class Word>
Word load(const char* text) {
  Word bytes;
  std::memcpy(&bytes, text, sizeof bytes);
  return bytes;
}

template <class Word>
void store(char* out, Word bytes) {
  std::memcpy(out, &bytes, sizeof bytes);
}

}  // namespace tcb
