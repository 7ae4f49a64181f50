// Rounding once: exact numbers, and numbers that are known to within an error, at scalars and as they are printed.
#pragma once

#include <exception>
#include <optional>
#include <string>

#include "exact/bounded.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "numbers/rational.hpp"
#include "sample/table.hpp"
#include "tcb/spline/double_double.hpp"

namespace tcb {

/// The digits of a scalar do not decide a comparison.
class Undecided : public std::exception {
 public:
  const char* what() const noexcept override { return "tcb::Undecided"; }
};

/// An exact number at a scalar. One that is beyond the range of double-doubles has no finite error, or is none.
template <class S>
S scalar_of(const Rational& value);
template <>
inline Rational scalar_of<Rational>(const Rational& value) {
  return value;
}
template <>
Bounded scalar_of<Bounded>(const Rational& value);
template <>
inline spline::DoubleDouble scalar_of<spline::DoubleDouble>(const Rational& value) {
  return scalar_of<Bounded>(value).value;
}

/// An exact number to be printed.
struct Value {
  Rational number;
  bool root = false;   ///< `number` is the square of the value, with the sign of the value
  bool empty = false;  ///< it is not defined
};

/// A number that is within `error` of the value.
struct Known {
  Rational value, error;
};

/// A number as it is printed: the nearest double, or beyond 2^53 whole number of a time; and a text where that has
/// digits of its own.
struct Printed {
  Cell cell;
  std::string text = {};
  bool is_zero = false;  ///< the number is 0, and not one that is printed as 0
};

class Rounding {
 public:
  /// `decimals`: of times, as nearest_time() has them.
  Rounding(const Notation& notation, CellKind kind, int decimals = 0)
      : notation_(notation), kind_(kind), decimals_(decimals) {}

  /// An exact value, or the root of one.
  Printed exactly(const Value& value) const;

  /// What is printed of all numbers within the error; nothing where that leaves a choice, also of the sign.
  std::optional<Printed> within(const Known& known) const;
  std::optional<Printed> within(const Bounded& number) const;

  /// A number that is not told from 0, or from a fraction so simple that this is no chance, is that.
  std::optional<Printed> snapped(const Known& known) const;

 private:
  bool has_text() const;
  Printed rounded(const Rational& value) const;
  std::optional<Printed> enclosed(const Rational& low, const Rational& high) const;
  std::string text(const Rational& value) const;

  Notation notation_;
  CellKind kind_;
  int decimals_;
};

/// As printf("%.*g", count, value) and printf("%.*f", decimals, value) write a double, for any exact number.
std::string digits_text(const Rational& value, int count);
std::string fixed_text(const Rational& value, int decimals);

/// The same texts of `count` digits, of which the first one has the value 10^exponent, and of a whole number of units
/// of 10^-decimals.
std::string digits_text(std::string text, int exponent, int count, bool negative);
std::string fixed_text(std::string digits, int decimals, bool negative);

/// The fraction p/q times a power of two from which a number is not told, where q is so small that fewer than one in
/// 2^40 numbers is as near to such a fraction; nothing where there is none.
std::optional<Rational> simple_fraction(const Known& known);

Rational power_of_two(int exponent);

/// The exponent e with 2^(e - 1) <= |value| < 2^e. Requires: value is not 0.
int binary_exponent(const Rational& value);

/// The bits of the numerator and the denominator of a number.
unsigned bits_of(const Rational& value);

/// The number with the least denominator in [low, high]. Requires: 0 < low <= high.
Rational simplest_between(const Rational& low, const Rational& high);

}  // namespace tcb
