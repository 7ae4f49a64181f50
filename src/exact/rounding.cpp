// Rounding once: from an exact number, or from two between which it lies, to what is printed.
#include "exact/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "numbers/large_rational.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

using Kind = Notation::Kind;

Integer power_of_ten(int exponent) {
  return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::max(exponent, 0)));
}

/// A number >= 0 as a fraction of whole numbers, which need no common factors taken out to be rounded.
struct Fraction {
  explicit Fraction(const Rational& value) : above(integer(numerator(value))), below(integer(denominator(value))) {}

  /// The whole number nearest to it times 10^exponent, half to even.
  Integer nearest_whole_times_ten_to(int exponent) const {
    return rounded_quotient(above * power_of_ten(exponent), below * power_of_ten(-exponent));
  }
  /// The greatest e with 10^e <= it. Requires: > 0.
  int floor_log10() const {
    const auto bits = static_cast<double>(msb(above)) - static_cast<double>(msb(below)) + 1;  // or one less
    int exponent = static_cast<int>(std::ceil(bits * 0.30103));
    while (above * power_of_ten(-exponent) < below * power_of_ten(exponent)) --exponent;
    return exponent;
  }

  Integer above, below;
};

std::string without_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// The root of a positive number lies in [floor, floor + 1] / scale, or is floor / scale.
struct Root {
  Integer floor, scale;
  bool exact;
};

Root root_of(const Rational& square, unsigned bits) {
  const Integer product = integer(numerator(square) * denominator(square));  // n/d = n d / d^2
  const auto width = static_cast<unsigned>(msb(product)) + 1;
  const unsigned shift = width < 2 * bits ? bits - width / 2 : 0;
  const Integer shifted = product << 2 * shift;
  Integer rest;
  Integer floor = boost::multiprecision::sqrt(shifted, rest);
  return {std::move(floor), Integer(integer(denominator(square)) << shift), rest == 0};
}

/// Whether one double is nearest to all numbers within a bound.
bool rounds_to_one_double(const Bounded& number) {
  const auto& [high, low] = number.value;
  if (number.error == 0 && low == 0) return true;
  constexpr double slack = 0x1p-50;  // for the rounding of the sums of `low`
  const double error = number.error + slack * (std::abs(low) + number.error);
  return std::abs(high) > 0x1p-900 && high + (low + error) == high && high + (low - error) == high;
}

/// 10^exponent. Requires: at most 10^80, so that products stay within the range of doubles.
Bounded bounded_power_of_ten(int exponent) {
  constexpr double largest_exact = 1e22;
  Bounded power(1.0);
  for (; exponent >= 22; exponent -= 22) power = power * Bounded(largest_exact);
  double rest = 1;
  for (; exponent > 0; --exponent) rest *= 10;
  return power * Bounded(rest);
}

Bounded scaled_by_ten_to(const Bounded& value, int exponent) {
  return exponent < 0 ? value / bounded_power_of_ten(-exponent) : value * bounded_power_of_ten(exponent);
}

/// The nearest whole number to those within a bound, if it is the same one. Requires: 0 <= value < 2^62.
std::optional<std::int64_t> whole_nearest_to(const Bounded& value) {
  const auto whole = static_cast<std::int64_t>(value.value.hi);
  const double rest = (value.value.hi - static_cast<double>(whole)) + value.value.lo, nearest = std::nearbyint(rest);
  constexpr double slack = 0x1p-40;  // for the rounding of `rest`
  if (std::abs(rest - nearest) + value.error > 0.5 - slack) return std::nullopt;
  return whole + static_cast<std::int64_t>(nearest);
}

/// The text of a number in a notation of digits or decimals, if it is the same for all numbers within its bound, and if
/// it has at most 17 digits.
std::optional<std::string> decimal_text(const Bounded& number, const Notation& notation) {
  const double size = std::abs(number.value.hi);
  const bool is_clear = size > 1e-70 && size < 1e70 && size > 2 * number.error;
  if (!is_clear || notation.count > digits_of_double) return std::nullopt;
  const bool negative = number.value.hi < 0;
  if (notation.kind == Notation::Kind::fixed) {
    const Bounded units = scaled_by_ten_to(abs(number), notation.count);
    if (units.value.hi > 1e17) return std::nullopt;
    const auto whole = whole_nearest_to(units);
    return whole ? std::optional(fixed_text(std::to_string(*whole), notation.count, negative)) : std::nullopt;
  }
  int binary = 0;
  (void)std::frexp(size * (1 - 0x1p-50), &binary);                      // the number may be less than its high part
  int exponent = static_cast<int>(std::floor((binary - 1) * 0.30103));  // of ten: that of the number, or one less
  Bounded digits = scaled_by_ten_to(abs(number), notation.count - 1 - exponent);
  std::int64_t end = 1;
  for (int i = 0; i < notation.count; ++i) end *= 10;
  const Bounded excess = digits - Bounded(static_cast<double>(end));
  if (excess.may_be_zero() && !excess.is_zero()) return std::nullopt;  // the exponent is not decided
  if (excess.value.hi >= 0) digits = scaled_by_ten_to(abs(number), notation.count - 1 - ++exponent);
  auto whole = whole_nearest_to(digits);
  if (!whole || *whole < end / 10) return std::nullopt;
  if (*whole == end) {
    *whole /= 10;
    ++exponent;
  }
  return digits_text(std::to_string(*whole), exponent, notation.count, negative);
}

}  // namespace

std::string fixed_text(const Rational& value, int decimals) {
  return fixed_text(Fraction(abs(value)).nearest_whole_times_ten_to(decimals).str(), decimals, value < 0);
}

std::string fixed_text(std::string digits, int decimals, bool negative) {
  const auto decimal_digits = static_cast<std::size_t>(decimals);
  if (digits.size() <= decimal_digits) digits.insert(0, decimal_digits + 1 - digits.size(), '0');
  if (decimal_digits > 0) digits.insert(digits.size() - decimal_digits, ".");
  return (negative ? "-" : "") + digits;
}

std::string digits_text(const Rational& value, int count) {
  if (value == 0) return "0";
  const Fraction size(abs(value));
  int exponent = size.floor_log10();
  Integer digits = size.nearest_whole_times_ten_to(count - 1 - exponent);
  if (digits == power_of_ten(count)) {
    digits /= 10;
    ++exponent;
  }
  return digits_text(digits.str(), exponent, count, value < 0);
}

std::string digits_text(std::string text, int exponent, int count, bool negative) {
  const std::string sign = negative ? "-" : "";
  if (exponent < -4 || exponent >= count) {
    if (count > 1) text.insert(1, ".");
    return fmt::format("{}{}e{}{:02}", sign, without_zeros(text), exponent < 0 ? '-' : '+', std::abs(exponent));
  }
  if (exponent < 0)
    return sign + without_zeros("0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + text);
  if (exponent + 1 < count) text.insert(static_cast<std::size_t>(exponent) + 1, ".");
  return sign + without_zeros(text);
}

/// By continued fractions.
Rational simplest_between(const Rational& low, const Rational& high) {
  const Rational whole = floor(low);
  if (whole == low) return low;
  if (whole + 1 <= high) return whole + 1;
  return whole + 1 / simplest_between(1 / (high - whole), 1 / (low - whole));
}

bool Rounding::has_text() const { return kind_ != CellKind::whole && notation_.is_rounded(); }

std::string Rounding::text(const Rational& value) const {
  constexpr std::uint64_t whole_from = std::uint64_t{1} << 53;
  if (kind_ == CellKind::time && abs(value) >= whole_from) return time_text(nearest_time(value));
  return notation_.kind == Kind::digits ? digits_text(value, notation_.count) : fixed_text(value, notation_.count);
}

Printed Rounding::rounded(const Rational& value) const {
  Printed printed{kind_ == CellKind::time ? nearest_time(value, decimals_) : Cell(nearest_double(value))};
  if (has_text()) printed.text = text(value);
  printed.is_zero = value == 0;
  return printed;
}

std::optional<Printed> Rounding::enclosed(const Rational& low, const Rational& high) const {
  Printed first = rounded(low);
  if (low == high) return first;
  const Printed last = rounded(high);
  const bool same = has_text() ? first.text == last.text : first.cell == last.cell;
  return same ? std::optional(std::move(first)) : std::nullopt;
}

Printed Rounding::exactly(const Value& value) const {
  if (value.empty) return {empty_cell};
  if (!value.root || value.number == 0) return rounded(value.number);
  const bool negative = value.number < 0;
  for (unsigned bits = 128;; bits *= 2) {  // no root that is irrational lies where rounding changes
    const Root root = root_of(abs(value.number), bits);
    const Rational low = ratio(root.floor, root.scale);
    const Rational high = root.exact ? low : ratio(root.floor + 1, root.scale);
    if (auto printed = negative ? enclosed(-high, -low) : enclosed(low, high)) return *printed;
  }
}

std::optional<Printed> Rounding::within(const Known& known) const {
  const Rational low = known.value - known.error, high = known.value + known.error;
  const bool has_sign = low == high || low > 0 || high < 0;
  return has_sign ? enclosed(low, high) : std::nullopt;
}

std::optional<Printed> Rounding::within(const Bounded& number) const {
  if (!std::isfinite(number.value.hi) || !std::isfinite(number.error)) return std::nullopt;
  const bool is_plain = kind_ != CellKind::time || (decimals_ == 0 && std::abs(number.value.hi) < 0x1p53);
  if (is_plain && !has_text()) {
    if (!rounds_to_one_double(number)) return std::nullopt;
    return Printed{.cell = Cell(number.value.hi), .is_zero = number.is_zero()};
  }
  if (is_plain && rounds_to_one_double(number)) {
    if (auto text = decimal_text(number, notation_)) return Printed{Cell(number.value.hi), *std::move(text)};
  }
  return within(Known{Rational(number.value.hi) + Rational(number.value.lo), Rational(number.error)});
}

std::optional<Printed> Rounding::snapped(const Known& known) const {
  const auto simple = simple_fraction(known);
  return simple ? std::optional(rounded(*simple)) : std::nullopt;
}

std::optional<Rational> simple_fraction(const Known& known) {
  static const Rational chance = Rational(0x1p-40);
  const Rational size = abs(known.value);
  if (size <= known.error) return 0;
  const Rational unit = power_of_two(binary_exponent(size));
  Rational value = size / unit, error = known.error / unit;
  if (error != 0) {  // bits below it have no effect, and take time
    const Rational last = power_of_two(binary_exponent(error) - 16);
    value = floor(value / last) * last;
    error = floor(error / last + 2) * last;
  }
  const Rational simple = simplest_between(value - error, value + error), divisor = denominator(simple);
  if (2 * error * divisor * divisor > chance) return std::nullopt;
  return known.value < 0 ? Rational(-simple * unit) : Rational(simple * unit);
}

Rational power_of_two(int exponent) {
  const Rational power = rational(Integer(1) << std::abs(exponent));
  return exponent < 0 ? 1 / power : power;
}

int binary_exponent(const Rational& value) {
  const Fraction size(abs(value));
  const int exponent = static_cast<int>(msb(size.above)) - static_cast<int>(msb(size.below));
  const Integer above = size.above << std::max(-exponent, 0), below = size.below << std::max(exponent, 0);
  return above < below ? exponent : exponent + 1;
}

unsigned bits_of(const Rational& value) {
  const Fraction size(abs(value));
  return static_cast<unsigned>((size.above == 0 ? 0 : msb(size.above)) + msb(size.below) + 1);
}

template <>
Bounded scalar_of<Bounded>(const Rational& value) {
  const double high = nearest_double(value);
  const bool is_in_range = std::abs(high) > 0x1p-900 && std::isfinite(high);
  if (value == 0) return {};
  if (!is_in_range) return {high, std::numeric_limits<double>::infinity()};
  const Rational rest = value - Rational(high);
  if (rest == 0) return {high, 0};
  const double low = nearest_double(rest);
  return {spline::DoubleDouble::normalized(high, low), Rational(low) == rest ? 0 : 0x1p-104 * std::abs(high)};
}

}  // namespace tcb
