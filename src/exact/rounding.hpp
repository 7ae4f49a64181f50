// Exact scalars and rounding: rationals, balls around them, and what is printed of their values.
#pragma once

#include <optional>
#include <string>

#include "exact/ball.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "numbers/rational.hpp"
#include "sample/table.hpp"

namespace tcb {

/// An exact number at a scalar: itself, or a ball around it. Throws: Undecided for one beyond the range of the balls.
template <class S>
S scalar_of(const Rational& value);
template <>
inline Rational scalar_of<Rational>(const Rational& value) {
  return value;
}
template <>
Ball scalar_of<Ball>(const Rational& value);
template <>
RealBall scalar_of<RealBall>(const Rational& value);

/// An exact number to be printed.
struct Value {
  Rational number;
  bool root = false;   ///< `number` is the square of the value, with the sign of the value
  bool empty = false;  ///< it is not defined
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

  /// A number within `radius` of `middle`: nothing if they do not determine the rounding.
  std::optional<Printed> within(const Rational& middle, const Rational& radius) const;

  /// As within(), for the last precision: a number that it does not distinguish from 0 is 0, and one that it does not
  /// distinguish from a short one is that. Throws: Undecided where the radius is too large for that.
  Printed at_last(const Rational& middle, const Rational& radius) const;

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

/// The number with the least denominator in [low, high]. Requires: 0 < low <= high.
Rational simplest_between(const Rational& low, const Rational& high);

}  // namespace tcb
