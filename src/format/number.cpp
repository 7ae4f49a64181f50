// Text to number and back, without loss and without locale.
#include "format/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tcb::format {
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
  long long exponent = 0;
  if (mark != std::string_view::npos) {
    const std::string_view power = without_plus(text.substr(mark + 1));
    if (std::from_chars(power.data(), power.data() + power.size(), exponent).ec != std::errc()) return power[0] == '-';
  }
  return exponent + static_cast<long long>(point) - static_cast<long long>(first) < 0;
}

template <class Number>
void append_shortest(std::string& out, Number value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.append(text.data(), end);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || digits.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range && is_tiny(digits)) return digits[0] == '-' ? -0.0 : 0.0;
  return error == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
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
  if (is_missing(text) || parse_all<double>(without_plus(text))) return true;
  double value = 0;
  const std::string_view digits = without_plus(text);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc::result_out_of_range && end == digits.data() + digits.size();
}

void append_number(std::string& out, double value) { append_shortest(out, value); }

void append_time(std::string& out, const Time& time) {
  if (std::abs(time.hi) > two_to_63 || time.hi != std::trunc(time.hi)) {
    append_shortest(out, time.hi);
  } else if (time.hi == two_to_63) {
    append_whole(out, (std::uint64_t{1} << 63) + static_cast<std::uint64_t>(static_cast<std::int64_t>(time.lo)));
  } else {
    append_shortest(out, static_cast<std::int64_t>(time.hi) + static_cast<std::int64_t>(time.lo));
  }
}

std::string time_text(const Time& time) {
  std::string out;
  append_time(out, time);
  return out;
}

void append_whole(std::string& out, std::uint64_t value) { append_shortest(out, value); }

}  // namespace tcb::format
