// Exact rationals: arithmetic, parsing, and rounding once.
//
// Source: D. E. Knuth, TAOCP vol. 2, 4.5.1, for terms that stay small: factors are taken out before multiplying.
#include "numbers/rational.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>

#include "numbers/decimal_time.hpp"
#include "numbers/large_rational.hpp"
#include "numbers/shortest_decimal.hpp"

namespace tcb {
namespace {

__extension__ using Int128 = __int128;
using Large = Rational::Large;

constexpr int largest_exponent = 10'000;
constexpr double whole_from = 9007199254740992.0;  // 2^53: every double from here on is whole

Integer integer_of(Int128 value) {
  return (Integer(static_cast<std::int64_t>(value >> 64)) << 64) + Integer(static_cast<std::uint64_t>(value));
}

bool are_small(const Rational& a, const Rational& b) { return a.is_small() && b.is_small(); }

bool take_digits(std::string_view& text, std::string& digits) {
  std::size_t count = 0;
  while (count < text.size() && text[count] >= '0' && text[count] <= '9') ++count;
  digits += text.substr(0, count);
  text.remove_prefix(count);
  return count > 0;
}

/// The exponent after the digits, 0 if there is none; nothing if it is malformed or too large.
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

Rational scaled_by_ten(const std::string& digits, int exponent) {
  constexpr int longest = 18;  // digits that 63 bits hold
  if (digits.size() <= longest && std::abs(exponent) <= longest) {
    std::int64_t whole = 0;
    (void)std::from_chars(digits.data(), digits.data() + digits.size(), whole);
    const Rational power = whole_power_of_ten(std::abs(exponent));
    return exponent < 0 ? whole / power : whole * power;
  }
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  const Integer whole = digits.empty() ? Integer(0) : Integer(digits);
  return exponent < 0 ? ratio(whole, power) : rational(whole * power);
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
  const Rational value = scaled_by_ten(digits, *exponent - scale);
  return negative ? -value : value;
}

/// How many bits a positive integer has.
int bit_width(const Integer& value) { return static_cast<int>(msb(value)) + 1; }

/// A whole number of at most 106 bits as a time, exactly. Requires: n >= 0.
spline::Time<double> whole_time(const Integer& n) {
  const auto high = static_cast<double>(n);
  return spline::DoubleDouble::normalized(high, static_cast<double>(n - Integer(high)));
}

/// n * 2^shift, for a shift to either side. Requires: nothing is lost to the right.
Integer shifted(const Integer& n, int shift) { return shift > 0 ? Integer(n << shift) : n; }

/// n / d as the nearest double, ties to even. Requires: n > 0, d > 0.
double nearest_positive(const Integer& n, const Integer& d) {
  // Scale n/d by a power of two so that its whole part has the 53 bits of a double (fewer where the
  // double is subnormal), then round to a whole number.
  constexpr int bits = 53;
  constexpr int last_bit = 1074;  // the smallest double is 2^-1074
  int shift = bits - (bit_width(n) - bit_width(d));
  if (shifted(n, shift) >> bits >= shifted(d, -shift)) --shift;
  if (shift > last_bit) shift = last_bit;
  const Integer whole = rounded_quotient(shifted(n, shift), shifted(d, -shift));
  return std::ldexp(static_cast<double>(whole), -shift);
}

}  // namespace

Rational::Rational(const Rational&) = default;
Rational::Rational(Rational&&) noexcept = default;
Rational& Rational::operator=(const Rational&) = default;
Rational& Rational::operator=(Rational&&) noexcept = default;
Rational::~Rational() = default;

Rational::Rational(double value) {
  if (std::abs(value) < 0x1p63 && std::trunc(value) == value) {
    numerator_ = static_cast<std::int64_t>(value);
    return;
  }
  int exponent = 0;
  auto bits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(bits));
  exponent += zeros - 53;
  if (-62 <= exponent && exponent < 0) {
    numerator_ = bits / (std::int64_t{1} << zeros);
    denominator_ = std::int64_t{1} << -exponent;
  } else {
    *this = Rational(Large{Large::Number(value)});
  }
}

Rational::Rational(const Large& value) {
  const Integer above = numerator(value.number);
  const Integer below = denominator(value.number);
  if (above >= -largest && above <= largest && below <= largest) {
    numerator_ = static_cast<std::int64_t>(above);
    denominator_ = static_cast<std::int64_t>(below);
  } else {
    large_ = std::make_shared<const Large>(value);
  }
}

Rational::Rational(const Rational& dividend, const Rational& divisor) : Rational(dividend / divisor) {}

Rational Rational::reduced(Int128 numerator, Int128 denominator) {
  if (numerator < -largest || numerator > largest || denominator > largest) {
    return ratio(integer_of(numerator), integer_of(denominator));
  }
  Rational value(static_cast<std::int64_t>(numerator), InPlace());
  value.denominator_ = static_cast<std::int64_t>(denominator);
  return value;
}

Rational::Large Rational::large() const { return large_ ? *large_ : Large{Large::Number(numerator_) / denominator_}; }

Rational Rational::operator-() const {
  if (large_) return Rational(Large{-large_->number});
  return reduced(-Int128{numerator_}, denominator_);
}

Rational operator+(const Rational& a, const Rational& b) {
  if (!are_small(a, b)) return Rational(Large{a.large().number + b.large().number});
  const std::int64_t common = std::gcd(a.denominator_, b.denominator_);
  const std::int64_t rest = a.denominator_ / common;
  const Int128 sum = Int128{a.numerator_} * (b.denominator_ / common) + Int128{b.numerator_} * rest;
  const std::int64_t factor = common == 1 ? 1 : std::gcd(static_cast<std::int64_t>(sum % common), common);
  return Rational::reduced(sum / factor, Int128{rest} * (b.denominator_ / factor));
}

Rational operator-(const Rational& a, const Rational& b) { return a + -b; }

Rational operator*(const Rational& a, const Rational& b) {
  if (!are_small(a, b)) return Rational(Large{a.large().number * b.large().number});
  const std::int64_t first = std::gcd(a.numerator_, b.denominator_);
  const std::int64_t second = std::gcd(b.numerator_, a.denominator_);
  return Rational::reduced(Int128{a.numerator_ / first} * (b.numerator_ / second),
                           Int128{a.denominator_ / second} * (b.denominator_ / first));
}

Rational operator/(const Rational& a, const Rational& b) {
  if (!are_small(a, b)) return Rational(Large{a.large().number / b.large().number});
  Rational inverse;
  inverse.numerator_ = b.numerator_ < 0 ? -b.denominator_ : b.denominator_;
  inverse.denominator_ = b.numerator_ < 0 ? -b.numerator_ : b.numerator_;
  return a * inverse;
}

bool operator==(const Rational& a, const Rational& b) {
  if (are_small(a, b)) return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  return a.is_small() == b.is_small() && numerator(a.large_->number) == numerator(b.large_->number) &&
         denominator(a.large_->number) == denominator(b.large_->number);
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (!are_small(a, b)) {
    const auto above = [](const Rational& x) { return integer(numerator(x)); };
    const auto below = [](const Rational& x) { return integer(denominator(x)); };
    return Integer(above(a) * below(b)).compare(above(b) * below(a)) <=> 0;
  }
  return Int128{a.numerator_} * b.denominator_ <=> Int128{b.numerator_} * a.denominator_;
}

Rational abs(const Rational& value) { return value < 0 ? -value : value; }

Rational numerator(const Rational& value) {
  return value.is_small() ? Rational(value.small_numerator()) : rational(Integer(numerator(value.large().number)));
}

Rational denominator(const Rational& value) {
  return value.is_small() ? Rational(value.small_denominator()) : rational(Integer(denominator(value.large().number)));
}

Rational floor(const Rational& value) {
  const Rational whole = value.is_small()
                             ? Rational(value.small_numerator() / value.small_denominator())
                             : rational(integer(numerator(value)) / integer(denominator(value)));  // towards zero
  return whole > value ? whole - 1 : whole;
}

std::string whole_text(const Rational& whole) { return integer(whole).str(); }

std::string ratio_text(const Rational& number) {
  return whole_text(numerator(number)) + "/" + whole_text(denominator(number));
}

std::uint64_t whole_number(const Rational& whole) { return static_cast<std::uint64_t>(integer(whole)); }

std::optional<Rational> parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text);
  const auto above = parse_decimal(text.substr(0, slash));
  const auto below = parse_decimal(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

Rational exact_time(const Time& time) {
  const bool is_whole = time.lo == std::trunc(time.lo) && std::abs(time.hi) >= whole_from;
  if (time.lo != 0 && !is_whole) return decimal_of(time).value();
  if (std::abs(time.hi) >= whole_from) return Rational(time.hi) + Rational(time.lo);
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), time.hi).ptr;
  return *parse_decimal({text.data(), end});
}

double nearest_double(const Rational& value) {
  if (value == 0) return 0;
  constexpr std::int64_t exact = std::int64_t{1} << 53;  // up to here doubles are exact, and a division rounds once
  if (value.is_small() && std::abs(value.small_numerator()) < exact && value.small_denominator() < exact) {
    return static_cast<double>(value.small_numerator()) / static_cast<double>(value.small_denominator());
  }
  const double size = nearest_positive(integer(abs(numerator(value))), integer(denominator(value)));
  return value < 0 ? -size : size;
}

bool within_doubles(const Rational& value) { return std::isfinite(nearest_double(value)); }

Time nearest_time(const Rational& value) {
  constexpr double digits_end = 1e31;  // from here on a whole number has more digits than a time
  const double nearest = nearest_double(value);
  if (std::abs(nearest) >= digits_end || abs(value) < std::int64_t{1} << 53) return {nearest};
  const Time time = whole_time(rounded_quotient(integer(abs(numerator(value))), integer(denominator(value))));
  return value < 0 ? -time : time;
}

}  // namespace tcb
