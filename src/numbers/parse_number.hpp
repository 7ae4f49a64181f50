// Reading numbers: decimal and hexadecimal, whole times, missing cells, and the decimal comma.
//
// Decimals are read by fast_float, hexadecimal numbers by std::from_chars; neither depends on a locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "numbers/rational.hpp"

namespace tcb {

/// The double nearest to a decimal number, which must be the whole text: digits with an optional sign, point and
/// exponent; or a hexadecimal number as printf's %a writes it. Nothing for any other text, nor for a number too large
/// for a double.
std::optional<double> parse_number(std::string_view text);

/// A number, and the decimal or ratio as which it is written, which is exact.
struct WrittenNumber {
  double value = 0;
  std::string decimal = "0";
};

inline Rational exact_number(const WrittenNumber& number) {
  return parse_rational(number.decimal).value_or(Rational(number.value));
}

/// A time: as parse_number, but a decimal of 16 digits or more keeps 31 of them, and a whole number below 2^63 all.
std::optional<Time> parse_time(std::string_view text);

/// A whole number as a time, exactly.
Time whole_time(std::int64_t value);

/// The cell is a missing number: empty, NA, nan or null, in upper or lower case.
bool is_missing(std::string_view cell);

/// The text belongs in a column of numbers: a number, a missing one, or an infinity (which is refused
/// later, as a number, rather than taken for a name here).
bool looks_numeric(std::string_view text);

/// The characters in numbers besides digits, signs and exponents.
struct NumberMarks {
  char decimal = '.';
  char thousands = 0;  ///< between groups of three digits; ' ' is any space, and 0 is none

  friend bool operator==(const NumberMarks&, const NumberMarks&) = default;
};

/// Parses numbers and times with other marks.
class Decimals {
 public:
  explicit Decimals(const NumberMarks& marks) : marks_(marks) {}

  std::optional<double> number(std::string_view text) { return parse_number(with_point(text)); }
  std::optional<Time> time(std::string_view text) { return parse_time(with_point(text)); }
  std::string text(std::string_view text) { return std::string(with_point(text)); }
  bool looks_numeric(std::string_view text) { return tcb::looks_numeric(with_point(text)); }

 private:
  std::string_view with_point(std::string_view text) { return marks_ == NumberMarks() ? text : changed(text); }

  /// The text with a point as its decimal mark, and without marks between thousands. Other marks are exchanged or stay,
  /// which makes it no number.
  std::string_view changed(std::string_view text);

  NumberMarks marks_;
  std::string changed_;
};

}  // namespace tcb
