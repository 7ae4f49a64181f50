// Reading numbers: the syntax, and what the libraries that convert them do not accept or refuse.
#include "numbers/parse_number.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "numbers/decimal_time.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// The text without a leading "+", which neither library accepts.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

/// A number as printf's %a writes it, with its exponent. Not inlined: it is rare.
[[gnu::noinline]] std::optional<double> parse_hex(std::string_view text) {
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

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::string_view digits = without_plus(text);
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto result = fast_float::from_chars(digits.data(), end, value);
  if (result.ptr != end || digits.empty()) return parse_hex(text);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;  // too large, or an infinity, or "nan"
}

std::optional<Time> parse_time(std::string_view text) {
  constexpr std::size_t always_exact = 15;  // digits
  if (text.size() > always_exact) {
    const std::string_view digits = without_plus(text);
    const char* const end = digits.data() + digits.size();
    std::int64_t whole = 0;
    const auto result = std::from_chars(digits.data(), end, whole);
    if (result.ec == std::errc() && result.ptr == end) return whole_time(whole);
  }
  const auto value = parse_number(text);
  if (!value) return std::nullopt;
  if (text.size() <= always_exact) return Time(*value);
  const auto decimal = parse_long_time(text, *value);
  return decimal ? *decimal : Time(*value);
}

Time whole_time(std::int64_t value) {
  const auto high = static_cast<double>(value);
  const auto rest = high < 0x1p63 ? value - static_cast<std::int64_t>(high) : value - INT64_MAX - 1;
  return {high, static_cast<double>(rest)};
}

Time whole_time(std::uint64_t value) {
  if (value <= INT64_MAX) return whole_time(static_cast<std::int64_t>(value));
  const Time above = whole_time(static_cast<std::int64_t>(value - INT64_MAX - 1));
  return Time(0x1p63) + above;
}

bool is_missing(std::string_view cell) {
  return cell.empty() || same_in_any_case(cell, "na") || same_in_any_case(cell, "nan") ||
         same_in_any_case(cell, "null");
}

bool looks_numeric(std::string_view text) {
  if (is_missing(text) || parse_hex(text)) return true;
  const std::string_view digits = without_plus(text);
  double any = 0;
  return std::from_chars(digits.data(), digits.data() + digits.size(), any).ptr == digits.data() + digits.size();
}

}  // namespace tcb
