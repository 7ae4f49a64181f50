// The precision of someone's numbers: how far each may be from the exact one by rounding and printing alone.
#include "compare/precision.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "text/number.hpp"

namespace tcb {
namespace {

/// The shortest decimal of a number: how many digits it has, and the powers of ten of the first and the last.
struct Decimal {
  int digits = 0, first = 0, last = 0;
};

Decimal decimal_of(double value) {
  std::array<char, 32> text{};
  const char* const end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(value), std::chars_format::scientific).ptr;
  const char* const exponent = std::find<const char*>(text.data(), end, 'e');
  Decimal decimal;
  decimal.digits = static_cast<int>(std::count_if<const char*>(text.data(), exponent, [](char c) { return c != '.'; }));
  const char* const digits = exponent + 1 + (exponent[1] == '+' ? 1 : 0);
  (void)std::from_chars(digits, end, decimal.first);
  decimal.last = decimal.first - decimal.digits + 1;
  return decimal;
}

double power_of_ten(int exponent) { return parse_number("1e" + std::to_string(exponent)).value_or(0); }

bool is_number(double value) { return std::isfinite(value); }

}  // namespace

std::vector<Allowance> allowances(std::span<const double> column, double size) {
  constexpr int most_printed = 15, most_single = 9;
  int digits = 0, last = std::numeric_limits<int>::max();
  bool single = true;
  for (const double value : column) {
    if (!is_number(value)) continue;
    size = std::max(size, std::abs(value));
    single = single && static_cast<double>(static_cast<float>(value)) == value;
    if (value == 0) continue;
    const Decimal decimal = decimal_of(value);
    digits = std::max(digits, decimal.digits);
    last = std::min(last, decimal.last);
  }
  const double rounding = std::ldexp(size, -40);
  const double coarse = single || digits <= most_single ? std::ldexp(size, -20) : 0;
  std::vector<Allowance> result;
  for (const double value : column) {
    const bool printed = digits > 0 && digits <= most_printed && is_number(value);
    const int unit = value == 0 ? last : std::max(last, decimal_of(value).first - digits + 1);
    const double step = printed ? power_of_ten(unit) : 0;
    result.push_back({rounding, printed ? step + rounding : 0, coarse == 0 ? 0 : std::max(coarse, step + rounding)});
  }
  return result;
}

}  // namespace tcb
