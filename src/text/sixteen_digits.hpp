// Sixteen digits at once: from a number to the bytes of its text.
//
// Source: H. S. Warren, Hacker's Delight, ch. 10, for the divisions by multiplication, in lanes that are cut in two at
//   each step: eight digits, four, two, one.
#pragma once

#include <bit>
#include <cstdint>

#include "text/digits.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace tcb {

/// In the words of any processor.
class SixteenDigitsInWords {
 public:
  /// Requires: n < 10^16.
  explicit SixteenDigitsInWords(std::uint64_t n)
      : early_(eight_digits(n / 100'000'000)), late_(eight_digits(n % 100'000'000)) {}

  /// How many there are without the zeros at the end, but one at least; 17 if one more follows that is no zero.
  int count(bool more) const {
    const int zeros = (late_ != 0 ? std::countl_zero(late_) : 64 + std::countl_zero(early_ | 1)) / 8;
    return 17 - (zeros + 1) * (more ? 0 : 1);
  }

  /// Writes all of them, the first one first.
  void write(char* out) const {
    store(out, early_ | eight_zeros);
    store(out + 8, late_ | eight_zeros);
  }

 private:
  std::uint64_t early_, late_;  ///< the first digit lowest
};

#if defined(__SSE2__)

/// The same in the vectors that every 64-bit x86 has.
class SixteenDigitsInVector {
 public:
  explicit SixteenDigitsInVector(std::uint64_t n) {
    // Each step cuts all lanes in two: of a = d q + r, q stays in the lower half, and r goes to the upper.
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
