// Printing decimals of more digits than doubles have: in full, or rounded.
#include "numbers/print_decimal.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tcb {
namespace {

/// The digits of a decimal as a text.
std::string text_of(LongDecimal::Digits digits) {
  std::string text;
  for (; digits != 0; digits /= 10) text.insert(text.begin(), static_cast<char>('0' + static_cast<int>(digits % 10)));
  return text;
}

/// Digits with the point after the first `before` of them, or zeros before them.
char* write_plain(std::string digits, int before, char* out) {
  if (before <= 0) digits.insert(0, static_cast<std::size_t>(1 - before), '0');
  const auto whole = static_cast<std::size_t>(std::max(before, 1));
  if (digits.size() < whole) digits.append(whole - digits.size(), '0');
  if (digits.size() > whole) digits.insert(whole, 1, '.');
  return std::copy(digits.begin(), digits.end(), out);
}

/// The exponent has its sign and two digits at least.
char* write_scientific(std::string digits, int exponent, char* out) {
  if (digits.size() > 1) digits.insert(1, 1, '.');
  digits += exponent < 0 ? "e-" : "e+";
  const std::string size = std::to_string(std::abs(exponent));
  digits += size.size() < 2 ? "0" + size : size;
  return std::copy(digits.begin(), digits.end(), out);
}

/// A long decimal in the shorter one of the two notations.
char* write_shorter(const LongDecimal& decimal, char* out) {
  if (decimal.negative) *out++ = '-';
  std::string digits = text_of(decimal.digits);
  const int count = static_cast<int>(digits.size()), before = count + decimal.exponent;
  const int plain = before <= 0 ? count + 2 - before : before < count ? count + 1 : before;
  const int scientific = count + (count > 1 ? 1 : 0) + (before > 100 || before < -98 ? 5 : 4);
  return plain <= scientific ? write_plain(std::move(digits), before, out)
                             : write_scientific(std::move(digits), before - 1, out);
}

}  // namespace

char* write_decimal(LongDecimal decimal, const Notation& notation, char* out) {
  if (notation.kind == Notation::Kind::shortest) return write_shorter(decimal, out);
  const bool fixed = notation.kind == Notation::Kind::fixed;
  if (decimal.negative) *out++ = '-';
  const int count = std::max(notation.count, 1);
  decimal = rounded(decimal, fixed ? notation.count : count - decimal.size() - decimal.exponent);
  std::string digits = text_of(decimal.digits);
  const int before = static_cast<int>(digits.size()) + decimal.exponent;
  if (!fixed && (before < -3 || before > count)) return write_scientific(std::move(digits), before - 1, out);
  const int zeros = fixed ? notation.count + decimal.exponent : 0;
  digits.append(static_cast<std::size_t>(zeros), '0');
  return write_plain(std::move(digits), before, out);
}

}  // namespace tcb
