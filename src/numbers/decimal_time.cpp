// Times as decimals of up to 31 digits: reading, printing and rounding those that a double does not hold.
//
// Most of them have so many digits that integers of 128 bits hold all products; the others are computed as rationals.
#include "numbers/decimal_time.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "numbers/shortest_decimal.hpp"

namespace tcb {
namespace {

using Digits = LongDecimal::Digits;
__extension__ using SignedDigits = __int128;

constexpr double low_parts_from = 1e-270;      ///< below, the low part would be subnormal
constexpr int largest_power_in_128_bits = 38;  ///< of ten, in 128 bits

constexpr auto powers = [] {
  std::array<Digits, largest_power_in_128_bits + 1> all{1};
  for (std::size_t i = 1; i < all.size(); ++i) all[i] = all[i - 1] * 10;
  return all;
}();

Digits power_of_ten(int exponent) { return powers[static_cast<std::size_t>(exponent)]; }

Rational rational_power_of_ten(int exponent) {
  Rational power(1);
  for (; exponent > 18; exponent -= 18) power *= Rational(static_cast<std::int64_t>(power_of_ten(18)));
  return power * Rational(static_cast<std::int64_t>(power_of_ten(exponent)));
}

Rational times_ten_to(const Rational& value, int exponent) {
  return exponent < 0 ? value / rational_power_of_ten(-exponent) : value * rational_power_of_ten(exponent);
}

Rational rational_of(const Digits& digits) {
  const Digits split = power_of_ten(18);
  return Rational(static_cast<std::uint64_t>(digits / split)) * Rational(static_cast<std::int64_t>(split)) +
         Rational(static_cast<std::uint64_t>(digits % split));
}

/// Requires: whole, 0 <= value < 10^37.
Digits digits_of(const Rational& whole) {
  const Rational split(static_cast<std::int64_t>(power_of_ten(18)));
  const Rational high = floor(whole / split);
  return Digits{whole_number(high)} * power_of_ten(18) + whole_number(whole - high * split);
}

/// The nearest whole number, ties to even. Requires: value >= 0.
Rational nearest_whole(const Rational& value) {
  const Rational whole = floor(value), rest = value - whole, half(1, 2);
  const bool is_odd = floor(whole / 2) * 2 != whole;
  return rest > half || (rest == half && is_odd) ? whole + 1 : whole;
}

/// The exponent of the first digit of a number. Requires: value > 0.
int first_digit(double value) {
  constexpr int most_exact = 22;  // such powers of ten are doubles
  if (value >= 1 && value < 1e22) {
    const int below = std::ilogb(value) * 1233 >> 12;  // 1233 / 2^12: the logarithm of 2
    return below < most_exact && value >= static_cast<double>(power_of_ten(below + 1)) ? below + 1 : below;
  }
  std::array<char, 16> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 0).ptr;
  int exponent = 0;
  const char* const sign = text.data() + 2;  // after a digit, which may be rounded up, and an e
  (void)std::from_chars(*sign == '+' ? sign + 1 : sign, end, exponent);
  text[0] = '1';
  double power = 0;
  (void)std::from_chars(text.data(), end, power);
  return value < power ? exponent - 1 : exponent;
}

LongDecimal stripped(LongDecimal decimal) {
  if (decimal.digits == 0) return {};
  for (const int step : {16, 8, 4, 2, 1}) {
    const Digits power = power_of_ten(step), factor = Digits{1} << step;
    for (; decimal.digits % factor == 0 && decimal.digits % power == 0; decimal.exponent += step) {
      decimal.digits /= power;
    }
  }
  return decimal;
}

/// value 10^power, and what is left of it, between 0 and 1. Nothing where 128 bits are not enough.
/// Requires: time > 0; the result has at most 31 digits.
struct Scaled {
  Digits whole;
  double rest;
};
std::optional<Scaled> scaled(const Time& time, int power) {
  constexpr int most = 22;  // such powers of ten are doubles
  if (power < 0 || power > most || !(time.hi >= 1e-5 && time.hi < 0x1p53)) return std::nullopt;
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(time.hi, &exponent), 53));
  const int shift = 53 - exponent;  // at most 69
  const Digits product = mantissa * power_of_ten(power);
  const Digits whole = product >> shift;
  const auto part = static_cast<double>(product - (whole << shift));
  const double rest = std::ldexp(part, -shift) + time.lo * static_cast<double>(power_of_ten(power));
  const auto carry = static_cast<std::int64_t>(std::floor(rest));
  return Scaled{whole + static_cast<Digits>(SignedDigits{carry}), rest - static_cast<double>(carry)};
}

Time absolute(const Time& time) { return time.hi < 0 ? -time : time; }

/// A positive number with `decimals` decimals, or with 31 digits if those are fewer. `near`: the double nearest to it.
LongDecimal rounded(const Rational& value, double near, int decimals) {
  const int power = std::min(decimals, digits_of_time - 1 - first_digit(near));
  return {digits_of(nearest_whole(times_ten_to(value, power))), -power};
}

/// The text as a decimal with all its digits up to the 32nd, and whether others follow that are not 0.
struct Scan {
  LongDecimal decimal;
  int size = 0;  ///< of its digits, without zeros at the beginning
  bool inexact = false;
};
std::optional<Scan> scan(std::string_view text) {
  Scan result;
  if (text.starts_with('-') || text.starts_with('+')) {
    result.decimal.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  bool in_fraction = false;
  std::size_t i = 0;
  for (; i < text.size() && (text[i] == '.' || (text[i] >= '0' && text[i] <= '9')); ++i) {
    if (text[i] == '.') {
      if (std::exchange(in_fraction, true)) return std::nullopt;
      continue;
    }
    const bool is_kept = result.size < digits_of_time + 1;
    const auto digit = static_cast<unsigned>(text[i] - '0');
    if (is_kept) result.decimal.digits = result.decimal.digits * 10 + digit;
    if (is_kept && result.decimal.digits != 0) ++result.size;
    if (!is_kept) result.inexact = result.inexact || digit != 0;
    result.decimal.exponent += (is_kept ? 0 : 1) - (in_fraction ? 1 : 0);
  }
  if (i == text.size()) return result;
  if (text[i] != 'e' && text[i] != 'E') return std::nullopt;
  if (i + 1 < text.size() && text[i + 1] == '+') ++i;
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data() + i + 1, text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size() || std::abs(exponent) > 400) return std::nullopt;
  result.decimal.exponent += exponent;
  return result;
}

/// Without a 32nd digit.
LongDecimal rounded(const Scan& scan) {
  LongDecimal decimal = scan.decimal;
  if (scan.size <= digits_of_time) return decimal;
  const auto last = static_cast<int>(decimal.digits % 10);
  decimal.digits /= 10;
  ++decimal.exponent;
  const bool up = last > 5 || (last == 5 && (scan.inexact || decimal.digits % 2 != 0));
  decimal.digits += up ? 1 : 0;
  return decimal;
}

/// The low part of a decimal whose high part is known, by integers of 128 bits. Requires: a positive decimal with
/// -22 <= exponent <= 0, below 2^53 and not below 1e-5.
double low_part(const LongDecimal& decimal, double high) {
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(high, &exponent), 53));
  const int shift = 53 - exponent;
  const Digits power = power_of_ten(-decimal.exponent);
  // The products may lose high bits, which their difference does not have.
  const auto difference = static_cast<SignedDigits>((decimal.digits << shift) - mantissa * power);
  return std::ldexp(static_cast<double>(difference) / static_cast<double>(power), -shift);
}

/// Whether a stripped decimal is the shortest one of its double. Requires: nearest >= 0, finite.
bool is_shortest(const LongDecimal& decimal, double nearest) {
  if (nearest == 0) return false;
  const Decimal found = shortest(nearest);
  const LongDecimal of_double = stripped({found.digits, found.exponent});
  return decimal.digits == of_double.digits && decimal.exponent == of_double.exponent;
}

/// The low part of a decimal that is a double but not its shortest decimal: too small to change the 31st digit.
double low_part_of_exact(double high) { return std::ldexp(high, -107); }

double nearest_to(const Digits& digits, int exponent) {
  if (digits > UINT64_MAX) return nearest_double(LongDecimal{digits, exponent}.value());
  std::array<char, 48> text{};
  char* end = std::to_chars(text.data(), text.data() + text.size(), static_cast<std::uint64_t>(digits)).ptr;
  *end++ = 'e';
  end = std::to_chars(end, text.data() + text.size(), exponent).ptr;
  double value = 0;
  const auto found = std::from_chars(text.data(), end, value);
  return found.ec == std::errc() ? value : nearest_double(LongDecimal{digits, exponent}.value());
}

/// Requires: a stripped decimal; `high` is the double nearest to it without its sign, 0 if that is not known.
Time time_of(const LongDecimal& decimal, double high) {
  const auto with_sign = [&](const Time& time) { return decimal.negative ? -time : time; };
  if (decimal.digits == 0) return {};
  if (high == 0) high = nearest_to(decimal.digits, decimal.exponent);
  if (high < low_parts_from || !std::isfinite(high)) return with_sign(high);
  const bool fits = decimal.exponent <= 0 && decimal.exponent >= -22 && high >= 1e-5 && high < 0x1p53;
  const Rational value = fits ? Rational() : LongDecimal{decimal.digits, decimal.exponent}.value();
  const double low = fits ? low_part(decimal, high) : nearest_double(value - Rational(high));
  const bool is_exact = low == 0 && high != std::trunc(high) && !is_shortest(decimal, high);
  return with_sign({high, is_exact ? low_part_of_exact(high) : low});
}

}  // namespace

int LongDecimal::size() const {
  int count = 0;
  while (count < largest_power_in_128_bits && power_of_ten(count) <= digits) ++count;
  return count;
}

Rational LongDecimal::value() const {
  const Rational size = times_ten_to(rational_of(digits), exponent);
  return negative ? -size : size;
}

LongDecimal decimal_of(const Time& time) {
  if (time.hi == 0) return {};
  const Time size = absolute(time);
  const int power = digits_of_time - 1 - first_digit(size.hi);
  LongDecimal decimal;
  if (const auto fast = scaled(size, power)) {
    decimal = {fast->whole + (fast->rest >= 0.5 ? 1 : 0), -power};
  } else {
    decimal = rounded(Rational(size.hi) + Rational(size.lo), size.hi, power);
  }
  decimal.negative = time.hi < 0;
  return stripped(decimal);
}

std::optional<LongDecimal> exact_decimal_of(const Time& time) {
  if (!(std::abs(time.hi) < 0x1p100)) return std::nullopt;
  if (time.hi == std::trunc(time.hi) && time.lo == std::trunc(time.lo)) {
    const SignedDigits whole = static_cast<SignedDigits>(time.hi) + static_cast<SignedDigits>(time.lo);
    return stripped({static_cast<Digits>(whole < 0 ? -whole : whole), 0, whole < 0});
  }
  if (time.lo != 0) return decimal_of(time);
  const Decimal found = shortest(std::abs(time.hi));
  return stripped({found.digits, found.exponent, time.hi < 0});
}

std::optional<Time> exact_difference(const LongDecimal& a, const LongDecimal& b) {
  constexpr int most = 37;  // digits whose sums and differences 128 bits hold
  const int exponent = std::min(a.exponent, b.exponent);
  const auto has_room = [&](const LongDecimal& decimal) {
    return decimal.size() + decimal.exponent - exponent <= most;
  };
  if (!has_room(a) || !has_room(b)) return std::nullopt;
  const auto with_sign = [&](const LongDecimal& decimal) {
    const auto digits = static_cast<SignedDigits>(decimal.digits * power_of_ten(decimal.exponent - exponent));
    return decimal.negative ? -digits : digits;
  };
  const SignedDigits difference = with_sign(a) - with_sign(b);
  const LongDecimal decimal =
      stripped({static_cast<Digits>(difference < 0 ? -difference : difference), exponent, difference < 0});
  if (decimal.size() > digits_of_time) return std::nullopt;
  const double nearest = nearest_to(decimal.digits, decimal.exponent);
  if (nearest < 0x1p53 && is_shortest(decimal, nearest)) return Time(decimal.negative ? -nearest : nearest);
  return time_of(decimal, nearest);
}

LongDecimal rounded(const LongDecimal& decimal, int decimals) {
  const int dropped = -decimal.exponent - decimals;
  if (dropped <= 0) return decimal;
  const Digits unit = dropped <= largest_power_in_128_bits ? power_of_ten(dropped) : 0;
  LongDecimal result{unit == 0 ? 0 : decimal.digits / unit, -decimals, decimal.negative};
  const Digits rest = unit == 0 ? 0 : decimal.digits % unit * 2;
  if (rest > unit || (rest == unit && result.digits % 2 != 0)) ++result.digits;
  return result.digits == 0 ? result : stripped(result);
}

Time time_of(const LongDecimal& decimal) { return time_of(stripped(decimal), 0); }

std::optional<Time> parse_long_time(std::string_view text, double nearest) {
  constexpr int always_double = 15;
  const auto found = scan(text);
  if (!found || found->size <= always_double) return std::nullopt;
  const LongDecimal decimal = stripped(rounded(*found));
  const int size = decimal.size();
  if (size <= always_double) return std::nullopt;
  constexpr int most_of_double = 17;
  const double high = std::abs(nearest);
  if (size <= most_of_double && (high >= 0x1p53 || is_shortest(decimal, high))) return Time(nearest);
  const bool is_rounded = found->size > digits_of_time;
  return time_of(decimal, is_rounded ? 0 : high);
}

bool has_many_digits(const Time& time) {
  constexpr int most = 17;
  if (time.lo == 0 || as_double(time) == time) return false;
  const Time size = absolute(time);
  if (const auto fast = scaled(size, most - 1 - first_digit(size.hi))) {
    constexpr double part_of_31_digits = 4e-15;
    return fast->rest > part_of_31_digits && fast->rest < 1 - part_of_31_digits;
  }
  return decimal_of(time).size() > most;
}

Time with_all_digits(const Time& time) {
  if (time.lo != 0 || std::abs(time.hi) >= 0x1p53 || time.hi == std::trunc(time.hi)) return time;
  const Decimal found = shortest(std::abs(time.hi));
  return time_of(stripped({found.digits, found.exponent, time.hi < 0}), std::abs(time.hi));
}

Rational exact_number(const Time& time, bool decimal) {
  return decimal || is_long_decimal(time) ? exact_time(time) : Rational(Rational(time.hi) + Rational(time.lo));
}

int decimals_of(const Time& time) { return is_long_decimal(time) ? std::max(-decimal_of(time).exponent, 0) : 0; }

Time nearest_time(const Rational& value, int decimals) {
  if (decimals == only_doubles) return nearest_double(value);
  if (decimals == 0 || value == 0) return nearest_time(value);
  const Rational size = abs(value);
  const double near = nearest_double(size);
  if (near < low_parts_from || !std::isfinite(near)) return nearest_time(value);
  const int power = digits_of_time - 1 - first_digit(near);
  const Rational whole = times_ten_to(size, power);
  if (denominator(whole) != 1) return rounded_to(value, decimals);
  return time_of(stripped({digits_of(whole), -power, value < 0}), near);
}

Time rounded_to(const Rational& value, int decimals) {
  if (decimals == 0 || value == 0) return nearest_time(value);
  const Rational size = abs(value);
  const double near = nearest_double(size);
  if (near < low_parts_from || !std::isfinite(near)) return nearest_time(value);
  LongDecimal decimal = rounded(size, near, decimals);
  decimal.negative = value < 0;
  return time_of(decimal);
}

}  // namespace tcb
