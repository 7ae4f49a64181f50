// Text to number and back, without loss and without locale.
#include "text/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

#include "text/decimal.hpp"
#include "text/digits.hpp"
#include "text/print_number.hpp"

namespace tcb {
namespace {

constexpr double two_to_63 = 9223372036854775808.0;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

bool equals_ignoring_case(std::string_view text, std::string_view lower_case) {
  return std::ranges::equal(text, lower_case, {}, lower);
}

/// The text without a leading "+", which std::from_chars does not know.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

template <class Number>
std::optional<Number> parse_all(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A decimal number out of the range of doubles is too small for it, not too large.
bool is_tiny(std::string_view text) {
  const std::size_t mark = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, mark);
  const std::size_t first = digits.find_first_of("123456789");
  const std::size_t point = std::min(digits.find('.'), digits.size());
  int exponent = 0;
  if (mark != std::string_view::npos) {
    const std::string_view power = without_plus(text.substr(mark + 1));
    if (std::from_chars(power.data(), power.data() + power.size(), exponent).ec != std::errc()) return power[0] == '-';
  }
  return exponent + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) < 0;
}

/// Takes the character c where it is the next one.
bool skip(const char*& at, const char* end, char c) {
  if (at == end || *at != c) return false;
  ++at;
  return true;
}

/// Takes the rest of the text if it is fewer than eight digits. Requires: there are eight bytes before the end.
inline bool take_last_digits(const char*& at, const char* end, std::uint64_t& number) {
  const auto count = static_cast<int>(end - at);
  if (count >= 8) return false;
  const std::uint64_t ours = ~std::uint64_t{0} << 8 * (7 - count) << 8;
  const std::uint64_t values = (load<std::uint64_t>(end - 8) ^ eight_zeros) & ours;
  if (!are_digits(values)) return false;
  number = number * whole_power_of_ten(count) + number_of(values);
  at = end;
  return true;
}

/// Takes digits, appends them to the number and answers how many they are.
inline int take_digits(const char*& at, const char* end, std::uint64_t& number, bool is_last = false) {
  const char* const first = at;
  for (; end - at >= 8; at += 8) {
    const std::uint64_t values = load<std::uint64_t>(at) ^ eight_zeros;
    if (!are_digits(values)) break;
    number = number * 100'000'000 + number_of(values);
  }
  if (is_last && take_last_digits(at, end, number)) return static_cast<int>(at - first);
  for (; at != end; ++at) {
    const auto digit = static_cast<unsigned char>(*at - '0');
    if (digit > 9) break;
    number = number * 10 + digit;
  }
  return static_cast<int>(at - first);
}

bool take_exponent(const char*& at, const char* end, int& exponent) {
  if (!skip(at, end, 'e') && !skip(at, end, 'E')) return false;
  const bool negative = skip(at, end, '-');
  if (!negative) skip(at, end, '+');
  std::uint64_t size = 0;
  const int count = take_digits(at, end, size);
  if (count == 0 || count > 4) return false;
  exponent += negative ? -static_cast<int>(size) : static_cast<int>(size);
  return true;
}

/// The zeros before the first other digit of a number.
int zeros_before(std::string_view digits) {
  const std::string_view front = digits.substr(0, digits.find_first_not_of("0."));
  return static_cast<int>(std::ranges::count(front, '0'));
}

/// As parse_number, for texts of at most 19 digits with an exponent of at most four that are neither too large nor so
/// small that they have fewer digits than other doubles; not a number for all others.
inline double parse_common(std::string_view text) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t longest = 1000;  // so that an int counts the digits
  if (text.size() > longest) return unknown;
  const char* at = text.data();
  const char* const end = at + text.size();
  const bool negative = skip(at, end, '-');
  if (!negative) skip(at, end, '+');

  Decimal decimal{0, 0};
  const char* const first = at;
  int count = take_digits(at, end, decimal.digits);
  if (skip(at, end, '.')) {
    decimal.exponent = -take_digits(at, end, decimal.digits, text.size() >= 8);
    count -= decimal.exponent;
  }
  constexpr int most_digits = 19;  // that 64 bits hold
  if (count == 0 || (count > most_digits && count - zeros_before({first, at}) > most_digits)) return unknown;
  if (at != end && !(take_exponent(at, end, decimal.exponent) && at == end)) return unknown;
  const double size = decimal.digits == 0 ? 0 : nearest(decimal);
  return negative ? -size : size;
}

template <class Value>
void append(std::string& out, char* (*write)(Value, char*), const std::type_identity_t<Value>& value) {
  std::array<char, number_room> text;
  out.append(text.data(), write(value, text.data()));
}

/// A number as printf's %a writes it, with its exponent.
std::optional<double> parse_hex(std::string_view text) {
  const bool negative = text.starts_with('-');
  std::string_view digits = negative ? text.substr(1) : without_plus(text);
  if (!digits.starts_with("0x") || digits.find('p') == std::string_view::npos) return std::nullopt;
  digits.remove_prefix(2);
  double value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::hex);
  const bool two_signs = digits.starts_with('-') || digits.find("+-") != std::string_view::npos;  // which it lets pass
  if (error != std::errc() || end != digits.data() + digits.size() || two_signs) return std::nullopt;
  return negative ? -value : value;
}

/// As parse_number, for any text.
std::optional<double> parse_any(std::string_view text) {
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || digits.empty()) return parse_hex(text);
  if (error == std::errc::result_out_of_range && is_tiny(digits)) return digits[0] == '-' ? -0.0 : 0.0;
  return error == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const double value = parse_common(text);
  if (std::isnan(value)) return parse_any(text);
  return value;
}

std::optional<Time> parse_time(std::string_view text) {
  constexpr std::size_t always_exact = 15;  // digits
  if (text.size() > always_exact) {
    if (const auto whole = parse_all<std::int64_t>(without_plus(text))) return whole_time(*whole);
  }
  const auto value = parse_number(text);
  return value ? std::optional(Time(*value)) : std::nullopt;
}

Time whole_time(std::int64_t value) {
  const auto high = static_cast<double>(value);
  const auto rest = high < two_to_63 ? value - static_cast<std::int64_t>(high) : value - INT64_MAX - 1;
  return {high, static_cast<double>(rest)};
}

Time whole_time(std::uint64_t value) {
  if (value <= INT64_MAX) return whole_time(static_cast<std::int64_t>(value));
  const Time above = whole_time(static_cast<std::int64_t>(value - INT64_MAX - 1));
  return Time(two_to_63) + above;
}

bool is_missing(std::string_view cell) {
  return cell.empty() || equals_ignoring_case(cell, "na") || equals_ignoring_case(cell, "nan") ||
         equals_ignoring_case(cell, "null");
}

bool looks_numeric(std::string_view text) {
  if (is_missing(text) || parse_all<double>(without_plus(text)) || parse_hex(text)) return true;
  double value = 0;
  const std::string_view digits = without_plus(text);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc::result_out_of_range && end == digits.data() + digits.size();
}

void append_number(std::string& out, double value) { append(out, write_shortest, value); }

void append_time(std::string& out, const Time& time) { append(out, write_time, time); }

std::string time_text(const Time& time) {
  std::string out;
  append_time(out, time);
  return out;
}

void append_whole(std::string& out, std::uint64_t value) { append(out, write_whole, value); }

}  // namespace tcb
