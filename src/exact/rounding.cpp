// Rounding once: from an exact number, or from two between which it lies, to what is printed.
#include "exact/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numbers/large_rational.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

using Kind = Notation::Kind;

Integer power_of_ten(int exponent) {
  return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::max(exponent, 0)));
}

/// value 10^exponent.
Rational times_ten_to(const Rational& value, int exponent) {
  return exponent < 0 ? Rational(value / rational(power_of_ten(-exponent)))
                      : Rational(value * rational(power_of_ten(exponent)));
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

std::optional<Printed> Rounding::within(const Rational& middle, const Rational& radius) const {
  const Rational low = middle - radius, high = middle + radius;
  const bool has_sign = low == high || low > 0 || high < 0;
  return has_sign ? enclosed(low, high) : std::nullopt;
}

Printed Rounding::at_last(const Rational& middle, const Rational& radius) const {
  if (auto printed = within(middle, radius)) return *std::move(printed);
  const Rational size = abs(middle);
  if (size <= radius) return rounded(0);
  const bool fixed = has_text() && notation_.kind == Notation::Kind::fixed;
  const int digits = has_text() ? notation_.count : digits_of_double;
  const Rational unit = times_ten_to(fixed ? Rational(1) : size, -digits);
  if (radius * 1'000'000 > unit) throw Undecided();
  const Rational simple = simplest_between(size - radius, size + radius);
  return rounded(middle < 0 ? Rational(-simple) : simple);
}

template <>
Ball scalar_of<Ball>(const Rational& value) {
  const double high = nearest_double(value);
  if (high == 0) return value == 0 ? Ball() : throw Undecided();
  if (!std::isfinite(high)) throw Undecided();
  const Rational rest = value - Rational(high);
  if (rest == 0) return Ball(high).widened(0.0);  // which refuses what is out of range
  const double low = nearest_double(rest);
  const spline::DoubleDouble middle = spline::DoubleDouble::normalized(high, low);
  return Ball(middle).widened(Rational(low) == rest ? 0 : 0x1p-104 * std::abs(high));
}

template <>
RealBall scalar_of<RealBall>(const Rational& value) {
  ErrorBound radius;
  const Real middle = Middle<Real>::nearest(value, radius);
  return RealBall(middle, radius);
}

}  // namespace tcb
