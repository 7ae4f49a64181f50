// Fuzzer of numbers: texts are read like the C library reads them; doubles are written like the standard library writes
// them, and read back.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

#include "invariant.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"

namespace tcb::fuzz {
namespace {

bool same(std::optional<double> a, std::optional<double> b) {
  return a.has_value() == b.has_value() && (!a || std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b));
}

std::size_t digits_at(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of("0123456789", at), text.size()) - at;
}

/// Digits with an optional sign, point and exponent.
bool is_decimal(std::string_view text) {
  const auto skip = [&](std::size_t at, std::string_view any) {
    return at + (at < text.size() && any.find(text[at]) != std::string_view::npos ? 1 : 0);
  };
  std::size_t at = skip(0, "+-");
  std::size_t digits = digits_at(text, at);
  at += digits;
  if (const std::size_t point = skip(at, "."); point != at) {
    digits += digits_at(text, point);
    at = point + digits_at(text, point);
  }
  if (digits == 0 || at == text.size()) return digits > 0;
  const std::size_t power = skip(at, "eE");
  const std::size_t first = skip(power, "+-");
  return power != at && first < text.size() && first + digits_at(text, first) == text.size();
}

/// A text in the form of printf's %a; beyond the range of doubles it may be refused.
bool is_hexadecimal(const std::string& text) {
  const std::size_t digits = text.find_first_not_of("+-") + 2, power = text.find('p');
  const std::string_view all(text);
  if (digits > 3 || power == std::string::npos || power < digits || all.substr(digits - 2, 2) != "0x") return false;
  const std::string_view mantissa = all.substr(digits, power - digits);
  const std::size_t exponent = all.find_first_not_of("+-", power + 1);
  return std::ranges::count(mantissa, '.') <= 1 &&
         mantissa.find_first_not_of(".0123456789abcdefABCDEF") == std::string_view::npos &&
         mantissa.find_first_not_of('.') != std::string_view::npos && exponent != std::string_view::npos &&
         exponent <= power + 2 && exponent + digits_at(text, exponent) == text.size();
}

std::optional<double> expected_number(const std::string& text) {
  const bool is_number = is_decimal(text) || (is_hexadecimal(text) && parse_number(text));
  const double value = is_number ? std::strtod(text.c_str(), nullptr) : std::nan("");
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> expected_whole(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// A time is its decimal of up to 31 digits; a double alone where that is its shortest decimal, or where no digits
/// beyond a double's are kept: up to 17 of them from 2^53 on, and in the smallest doubles.
void read_decimal_time(const std::string& text, double nearest, const Time& time) {
  const std::size_t mantissa = std::min(text.find_first_of("eEpP"), text.size());
  const auto digits = std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(mantissa),
                                    [](char c) { return c >= '0' && c <= '9'; });
  if (!is_decimal(text) || digits <= 15 || std::abs(nearest) < 1e-270 || std::abs(nearest) >= 0x1p53) {
    const bool may_be_long = digits > 17 && std::abs(nearest) >= 0x1p53;
    return require(may_be_long || (time.hi == nearest && time.lo == 0), "a time is not its number", text);
  }
  const auto exact = parse_rational(text);
  if (digits > 31 || !exact) return;  // rounded, which the tests of decimals compare
  require(time.hi == nearest, "the high part of a time is not its number", text);
  require(exact_time(time) == *exact, "a time is not its decimal", text);
  std::string shortest;
  append_number(shortest, nearest);
  const bool is_shortest = *parse_rational(shortest) == *exact;
  require(is_shortest == (time.lo == 0), "a low part beside a shortest decimal, or none beside another", text);
}

void read(const std::string& text) {
  const std::optional<double> wanted = expected_number(text);
  require(same(parse_number(text), wanted), "read otherwise than by strtod", text);
  require(!wanted || looks_numeric(text), "a number that does not look like one", text);

  std::string with_comma = text;
  for (char& c : with_comma) c = c == ',' ? '.' : c == '.' ? ',' : c;
  require(same(Decimals({','}).number(with_comma), wanted), "a decimal comma changes the number", text);

  const std::optional<Time> time = parse_time(text);
  require(time.has_value() == wanted.has_value(), "a time, but no number", text);
  if (!wanted) return;
  const auto whole = is_decimal(text) && text.find('.') == std::string::npos ? expected_whole(text) : std::nullopt;
  if (!whole) return read_decimal_time(text, *wanted, *time);
  require(static_cast<__int128>(time->hi) + static_cast<__int128>(time->lo) == *whole, "digits lost", text);
  require_same(time_text(*time), std::to_string(*whole), "a time is written otherwise");
}

std::string by_to_chars(double value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

template <class... Arguments>
std::string by_printf(const char* form, Arguments... arguments) {
  std::string text(1024, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), form, arguments...)));
  return text;
}

std::string written(double value, const Notation& notation) {
  std::string text(longest_number_in(notation) + spare_room, '\0');
  text.resize(static_cast<std::size_t>(write_number(value, notation, text.data()) - text.data()));
  return text;
}

void write(double value, int places) {
  std::string shortest;
  append_number(shortest, value);
  require_same(shortest, by_to_chars(value), "the shortest text");
  require(same(parse_number(shortest), value), "not read back", shortest);
  using Kind = Notation::Kind;
  require_same(written(value, {Kind::fixed, places}), by_printf("%.*f", places, value),
               fmt::format("{} decimals", places));
  require_same(written(value, {Kind::digits, places}), by_printf("%.*g", places, value),
               fmt::format("{} digits", places));

  // A time has one text, which is the text of its number unless it is a whole number.
  const std::string time = time_text(Time(value));
  const bool whole = std::trunc(value) == value && std::abs(value) < 0x1p63;
  require_same(time, whole ? std::to_string(static_cast<std::int64_t>(value)) : shortest, "a time");
}

}  // namespace
}  // namespace tcb::fuzz

/// The first bytes also give a double and a number of decimals.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tcb::fuzz::read({reinterpret_cast<const char*>(data), size});
  double value = 0;
  if (size <= sizeof value) return 0;
  std::memcpy(&value, data, sizeof value);
  const int places = data[sizeof value] % 64 < 48 ? data[sizeof value] % 20 : data[sizeof value];
  if (std::isfinite(value)) tcb::fuzz::write(value, places);
  return 0;
}
