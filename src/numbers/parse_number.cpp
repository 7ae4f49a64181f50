// Reading numbers: the syntax, and what the libraries that convert them do not accept or refuse.
#include "numbers/parse_number.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

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

namespace {

/// The spaces and the apostrophe of typography that stand for plain ones.
constexpr std::array<std::pair<std::string_view, char>, 4> typographic_marks{{
    {"\xC2\xA0", ' '},       // U+00A0, no-break space
    {"\xE2\x80\xAF", ' '},   // U+202F, narrow no-break space
    {"\xE2\x80\x89", ' '},   // U+2009, thin space
    {"\xE2\x80\x99", '\''},  // U+2019, right single quotation mark
}};

/// Removes marks that divide the digits before the decimal mark into groups of three; other texts stay.
void remove_thousands(std::string& text, const NumberMarks& marks) {
  for (const auto& [characters, mark] : typographic_marks) {
    if (mark != marks.thousands) continue;
    for (std::size_t at = text.find(characters); at != std::string::npos; at = text.find(characters)) {
      text.replace(at, characters.size(), 1, mark);
    }
  }
  const std::size_t begin = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
  const std::size_t end =
      std::min(text.find_first_not_of(std::string("0123456789") + marks.thousands, begin), text.size());
  const auto groups = split(std::string_view(text).substr(begin, end - begin), marks.thousands);
  const auto is_group = [](std::string_view group) { return group.size() == 3; };
  if (groups.size() == 1 || groups[0].empty() || groups[0].size() > 3 || groups[0].starts_with('0')) return;
  if (!std::all_of(groups.begin() + 1, groups.end(), is_group)) return;
  const auto digits = text.begin() + static_cast<std::ptrdiff_t>(begin);
  text.erase(std::remove(digits, text.begin() + static_cast<std::ptrdiff_t>(end), marks.thousands),
             text.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace

std::string_view Decimals::changed(std::string_view text) {
  changed_ = text;
  if (marks_.thousands != 0) remove_thousands(changed_, marks_);
  const char decimal = marks_.decimal;
  for (char& c : changed_) c = c == decimal ? '.' : c == '.' ? decimal : c;
  return changed_;
}

}  // namespace tcb
