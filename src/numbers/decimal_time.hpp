// Times as decimals of up to 31 digits: reading, printing and rounding those that a double does not hold.
//
// A time is a double-double, in which all decimals of 31 digits are different. Where its low part is 0, it is the
// shortest decimal of its double, as nearly all times are; otherwise it is the decimal of 31 digits nearest to it, and
// a whole number is itself. Each decimal has one double-double, so equal decimals are equal times.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "numbers/rational.hpp"

namespace tcb {

/// So many digits distinguish a decimal from all others as a time.
inline constexpr int digits_of_time = 31;

/// A decimal of at most 31 digits, which does not end in 0: digits 10^exponent, with its sign.
struct LongDecimal {
  __extension__ using Digits = unsigned __int128;
  Digits digits = 0;
  int exponent = 0;
  bool negative = false;

  /// The number of its digits.
  int size() const;
  Rational value() const;
};

/// Whether a time is neither a double nor a whole number below 2^63, so that it has to be printed as a decimal.
inline bool is_long_decimal(const Time& time) {
  constexpr double two_to_63 = 0x1p63;
  if (time.lo == 0) return false;
  return std::abs(time.hi) > two_to_63 || std::abs(time.hi) < 0x1p53 || time.lo != std::trunc(time.lo);
}

/// The decimal of a time. Requires: finite.
LongDecimal decimal_of(const Time& time);

/// The decimal that a time is, as exact_time() has it; nothing for whole numbers from 2^100 on.
std::optional<LongDecimal> exact_decimal_of(const Time& time);

/// The time that is exactly a - b; nothing if it has more than 31 digits.
std::optional<Time> exact_difference(const LongDecimal& a, const LongDecimal& b);

/// A decimal rounded to `decimals` decimals, ties to even; a result of 0 also has that many.
LongDecimal rounded(const LongDecimal& decimal, int decimals);

/// The time of a decimal; a double alone where that is 0, or too small for a low part.
Time time_of(const LongDecimal& decimal);

/// A decimal number with 16 digits or more as it is written, but the 31 first digits rounded; nothing for any other
/// text, for fewer digits, and for a number beyond the doubles. A double's shortest decimal has no low part.
/// `nearest`: the double nearest to the number.
std::optional<Time> parse_long_time(std::string_view text, double nearest);

/// Whether a time has more than 17 digits and is not whole, as no double needs them.
bool has_many_digits(const Time& time);

/// The time without the digits that its double does not hold; whole numbers remain.
inline Time as_double(const Time& time) {
  const bool is_whole = std::abs(time.hi) >= 0x1p53 && time.lo == std::trunc(time.lo);
  return is_whole ? time : Time(time.hi);
}

/// The time of a double's shortest decimal, with all its digits; other times remain.
Time with_all_digits(const Time& time);

/// How many decimals a time has; 0 where it is not a long decimal.
int decimals_of(const Time& time);

/// A double's own value; with `decimal` its shortest decimal. Whole numbers and long decimals of times are what they
/// are.
Rational exact_number(const Time& time, bool decimal);

/// The order of times as decimals: one that is a double is its shortest decimal.
inline bool is_earlier(const Time& a, const Time& b) {
  if (a.hi != b.hi || a.lo == b.lo) return a < b;
  return with_all_digits(a).lo < with_all_digits(b).lo;
}

/// Instead of a number of decimals: the nearest double, also beyond 2^53, as arc lengths are.
inline constexpr int only_doubles = -1;

/// The time nearest to a rational among times with `decimals` decimals: exactly the rational where it is a decimal of
/// 31 digits at most, otherwise rounded to so many decimals, ties to even. 0 decimals: as nearest_time(value).
Time nearest_time(const Rational& value, int decimals);

/// A number rounded to so many decimals, or 31 digits, ties to even. 0 decimals: as nearest_time(value).
Time rounded_to(const Rational& value, int decimals);

}  // namespace tcb
