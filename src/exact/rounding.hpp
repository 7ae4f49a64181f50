// Exact scalars and rounding: rationals, floats of more and more digits, and the double nearest to their values.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <limits>
#include <optional>
#include <string>

#include "keys/prepare.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/large_rational.hpp"
#include "numbers/print_number.hpp"
#include "numbers/rational.hpp"
#include "sample/fields.hpp"

namespace tcb {

template <unsigned digits>
using Float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>, boost::multiprecision::et_off>;

/// An exact number at a scalar: rounded, unless that is exact.
template <class S>
S scalar_of(const Rational& value) {
  if constexpr (std::numeric_limits<S>::is_exact) {
    return value;
  } else {
    return S(integer(numerator(value))) / S(integer(denominator(value)));
  }
}

/// The exact value of a scalar.
template <class S>
Rational rational_of(const S& value) {
  if constexpr (std::numeric_limits<S>::is_exact) {
    return value;
  } else {
    constexpr int digits = std::numeric_limits<S>::digits;
    int exponent = 0;
    const S mantissa = frexp(value, &exponent);
    const Integer whole(ldexp(mantissa, digits));
    exponent -= digits;
    return exponent < 0 ? ratio(whole, Integer(1) << -exponent) : rational(whole << exponent);
  }
}

/// The power of a distance between exact positions: the square of the distance is exact.
template <unsigned digits>
struct DistancePower<Float<digits>> {
  explicit DistancePower(const Rational&) {}
  void add_square(const Rational& a, const Rational& b) { sum_ += (b - a) * (b - a); }
  Float<digits> power(double exponent) const {
    return pow(sqrt(scalar_of<Float<digits>>(sum_)), Float<digits>(exponent));
  }

 private:
  Rational sum_ = 0;
};

/// A number to be printed: exact, or of a float that has to be compared with one of more digits.
struct Value {
  Rational number;
  bool root = false;      ///< `number` is the square of the value, with the sign of the value
  bool empty = false;     ///< it is not defined
  bool doubtful = false;  ///< it is taken for zero, or for not defined, because it is too small for the float
};

/// A number as it is printed: the nearest double, or beyond 2^53 whole number of a time; and a text where that has
/// digits of its own.
struct Printed {
  Cell cell;
  std::string text = {};
};

/// The decimal digits of the floats of two levels.
struct LevelDigits {
  int rough, fine;
};

class Rounding {
 public:
  /// `decimals`: of times, as nearest_time() has them.
  Rounding(const Notation& notation, CellKind kind, int decimals = 0)
      : notation_(notation), kind_(kind), decimals_(decimals) {}

  /// An exact value, or the root of one.
  Printed exactly(const Value& value) const;

  /// A number in [low, high]: nothing if they do not determine the rounding.
  std::optional<Printed> within(const Rational& low, const Rational& high) const { return enclosed(low, high); }

  /// A number given by two values, the second computed in the same way with more digits: nothing if they do not
  /// determine the rounding. The first one's error is about their distance, unless it is exact by chance, and the
  /// second one's is smaller by a factor of 10^(more digits), of which 10^20 are not used, for what is not
  /// proportional.
  std::optional<Printed> between(const Value& rough, const Value& fine, const LevelDigits& digits) const;

  /// As between(), for the last level: a value that its digits do not distinguish from a short number is that number.
  /// Throws: std::range_error where they are not enough for the text.
  Printed at_last(const Value& rough, const Value& fine, const LevelDigits& level) const;

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
