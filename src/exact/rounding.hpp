// Rounding once: from an exact number, or from two between which it lies, to what is printed.
#pragma once

#include <optional>
#include <string>

#include "curve/fields.hpp"
#include "text/print_number.hpp"
#include "text/rational.hpp"

namespace tcb {

/// A number to be printed: exact, or one of a float that is to be held against one of more digits.
struct Value {
  Rational number;
  bool root = false;      ///< it is the root of that, with its sign
  bool empty = false;     ///< it is not defined
  bool doubtful = false;  ///< it is taken for zero, or for not defined, because it is too small for the float
};

/// A number as it is printed: the nearest double, or beyond 2^53 whole number of a time; and a text where that has
/// digits of its own.
struct Printed {
  Cell cell;
  std::string text = {};
};

class Rounding {
 public:
  Rounding(const Notation& notation, CellKind kind) : notation_(notation), kind_(kind) {}

  /// An exact value, or the root of one.
  Printed exactly(const Value& value) const;

  /// A number given by two values of it, the second with more digits: nothing where they leave a choice.
  /// Requires: the first one's error is at least as large as their distance.
  std::optional<Printed> between(const Value& rough, const Value& fine) const;

  /// The same where no more digits are to be had. What so many digits do not tell from a number with few is that
  /// number. Throws: std::range_error where they are not enough for the text.
  Printed at_last(const Value& rough, const Value& fine) const;

 private:
  bool has_text() const;
  Printed rounded(const Rational& value) const;
  std::optional<Printed> enclosed(const Rational& low, const Rational& high) const;
  std::string text(const Rational& value) const;

  Notation notation_;
  CellKind kind_;
};

/// As printf("%.*g", count, value) and printf("%.*f", decimals, value) write a double, for any exact number.
std::string digits_text(const Rational& value, int count);
std::string fixed_text(const Rational& value, int decimals);

/// The number with the least denominator in [low, high]. Requires: 0 < low <= high.
Rational simplest_between(const Rational& low, const Rational& high);

}  // namespace tcb
