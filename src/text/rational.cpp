// Exact rationals: parsing, and rounding once.
#include "text/rational.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace tcb {
namespace {

constexpr int largest_exponent = 10'000;
constexpr double whole_from = 9007199254740992.0;  // 2^53: every double from here on is whole

bool take_digits(std::string_view& text, std::string& digits) {
  std::size_t count = 0;
  while (count < text.size() && text[count] >= '0' && text[count] <= '9') ++count;
  digits += text.substr(0, count);
  text.remove_prefix(count);
  return count > 0;
}

/// The exponent after the digits, 0 where there is none; nothing where it is malformed or too large.
std::optional<int> take_exponent(std::string_view text) {
  if (text.empty()) return 0;
  if (text[0] != 'e' && text[0] != 'E') return std::nullopt;
  text.remove_prefix(1);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (std::abs(exponent) > largest_exponent) return std::nullopt;
  return exponent;
}

Rational scaled_by_ten(const Integer& digits, int exponent) {
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(digits, power) : Rational(digits * power);
}

std::optional<Rational> parse_decimal(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::string digits;
  bool any = take_digits(text, digits);
  int scale = 0;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const std::size_t whole = digits.size();
    any = take_digits(text, digits) || any;
    scale = static_cast<int>(digits.size() - whole);
  }
  const auto exponent = take_exponent(text);
  if (!any || !exponent || digits.size() > largest_exponent) return std::nullopt;
  digits.erase(0, digits.find_first_not_of('0'));  // a leading 0 would mean octal
  const Rational value = scaled_by_ten(digits.empty() ? Integer(0) : Integer(digits), *exponent - scale);
  return negative ? Rational(-value) : value;
}

/// How many bits a positive integer has.
int bit_width(const Integer& value) { return static_cast<int>(msb(value)) + 1; }

/// n / d rounded to the nearest whole number, ties to even. Requires: n >= 0, d > 0.
Integer nearest_whole(const Integer& n, const Integer& d) {
  const Integer quotient = n / d;
  const Integer twice_rest = (n - quotient * d) * 2;
  const bool up = twice_rest > d || (twice_rest == d && (quotient % 2) != 0);
  return up ? Integer(quotient + 1) : quotient;
}

/// A whole number of at most 106 bits as a time, exactly. Requires: n >= 0.
spline::Time<double> whole_time(const Integer& n) {
  const auto high = static_cast<double>(n);
  return spline::DoubleDouble::normalized(high, static_cast<double>(n - Integer(high)));
}

/// n * 2^shift, for a shift to either side. Requires: nothing is lost to the right.
Integer shifted(const Integer& n, int shift) { return shift > 0 ? Integer(n << shift) : n; }

/// n / d as the nearest double, ties to even. Requires: n > 0, d > 0.
double nearest_positive(const Integer& n, const Integer& d) {
  if (n < Integer(whole_from) && d < Integer(whole_from)) return static_cast<double>(n) / static_cast<double>(d);
  // Scale n/d by a power of two so that its whole part has the 53 bits of a double (fewer where the
  // double is subnormal), then round to a whole number.
  constexpr int bits = 53;
  constexpr int last_bit = 1074;  // the smallest double is 2^-1074
  int shift = bits - (bit_width(n) - bit_width(d));
  if (shifted(n, shift) >> bits >= shifted(d, -shift)) --shift;
  if (shift > last_bit) shift = last_bit;
  const Integer whole = nearest_whole(shifted(n, shift), shifted(d, -shift));
  return std::ldexp(static_cast<double>(whole), -shift);
}

}  // namespace

std::optional<Rational> parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text);
  const auto above = parse_decimal(text.substr(0, slash));
  const auto below = parse_decimal(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return Rational(*above / *below);
}

Rational exact_time(const Time& time) {
  if (std::abs(time.hi) >= whole_from) return Rational(Integer(time.hi) + Integer(time.lo));
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), time.hi).ptr;
  return *parse_decimal({text.data(), end});
}

double nearest_double(const Rational& value) {
  if (value == 0) return 0;
  const double size = nearest_positive(abs(numerator(value)), denominator(value));
  return value < 0 ? -size : size;
}

bool within_doubles(const Rational& value) { return std::isfinite(nearest_double(value)); }

Time nearest_time(const Rational& value) {
  const Integer size = abs(numerator(value));
  if (size >> 53 < denominator(value)) return {nearest_double(value)};
  const Time time = whole_time(nearest_whole(size, denominator(value)));
  return value < 0 ? -time : time;
}

}  // namespace tcb
