// Real: floats whose precision is chosen while the program runs, and bounds on their errors.
//
// A number is m 2^e with whole m and e, of any size. A result is truncated to the digits in use, with an error below
// one unit of the last of them. Boost.Multiprecision is behind it, in real.cpp alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <memory>

#include "numbers/rational.hpp"

namespace tcb {

/// A number >= 0 that is no less than what it bounds, also beyond the range of doubles.
class ErrorBound {
 public:
  ErrorBound() = default;
  ErrorBound(double value) {  // NOLINT(google-explicit-constructor): a double converts. Requires: >= 0, finite
    int exponent = 0;
    mantissa_ = std::frexp(value, &exponent);
    exponent_ = exponent;
  }
  static ErrorBound power_of_two(std::int64_t exponent) { return {0.5, exponent + 1}; }

  friend ErrorBound operator+(const ErrorBound& a, const ErrorBound& b) {
    if (a.mantissa_ == 0 || b.mantissa_ == 0) return a.mantissa_ == 0 ? b : a;
    const bool swapped = a.exponent_ < b.exponent_;
    const ErrorBound &large = swapped ? b : a, &small = swapped ? a : b;
    const std::int64_t distance = large.exponent_ - small.exponent_;
    const double rest = distance > 60 ? 0x1p-60 : std::ldexp(small.mantissa_, -static_cast<int>(distance));
    const double sum = up(large.mantissa_ + rest);
    return sum < 1 ? ErrorBound(Normal(), sum, large.exponent_) : ErrorBound(sum, large.exponent_);
  }
  friend ErrorBound operator*(const ErrorBound& a, const ErrorBound& b) {
    const double product = up(a.mantissa_ * b.mantissa_);  // from 1/4 to 1, or 0
    if (product == 0) return {};
    const std::int64_t exponent = a.exponent_ + b.exponent_;
    if (product >= 1) return {product, exponent};
    return product < 0.5 ? ErrorBound(Normal(), 2 * product, exponent - 1) : ErrorBound(Normal(), product, exponent);
  }
  /// Requires: b is no more than what it is a bound of, and > 0.
  friend ErrorBound operator/(const ErrorBound& a, const ErrorBound& b) {
    return {up(a.mantissa_ / b.mantissa_), a.exponent_ - b.exponent_};
  }
  /// a - b for b < a, no more than the difference of numbers that are a and b exactly; else 0.
  friend ErrorBound at_least(const ErrorBound& a, const ErrorBound& b) {
    if (!(b < a)) return {};
    const std::int64_t distance = a.exponent_ - b.exponent_;
    const double rest = distance > 60 ? 0x1p-60 : std::ldexp(b.mantissa_, -static_cast<int>(distance));
    const double difference = (a.mantissa_ - rest) * (1 - 0x1p-50) - 0x1p-54;
    return difference > 0 ? ErrorBound(difference, a.exponent_) : ErrorBound();
  }
  friend bool operator==(const ErrorBound& a, const ErrorBound& b) = default;
  friend std::partial_ordering operator<=>(const ErrorBound& a, const ErrorBound& b) {
    if (a.mantissa_ == 0 || b.mantissa_ == 0 || a.exponent_ == b.exponent_) return a.mantissa_ <=> b.mantissa_;
    return a.exponent_ <=> b.exponent_;
  }
  /// The root, no less than it is.
  friend ErrorBound sqrt(const ErrorBound& a) {
    const bool odd = (a.exponent_ & 1) != 0;
    return {up(std::sqrt(odd ? 2 * a.mantissa_ : a.mantissa_)), (a.exponent_ - (odd ? 1 : 0)) / 2};
  }
  /// Times a power of two, exactly.
  friend ErrorBound ldexp(const ErrorBound& a, std::int64_t exponent) {
    return a.mantissa_ == 0 ? a : ErrorBound(Normal(), a.mantissa_, a.exponent_ + exponent);
  }

  double mantissa() const { return mantissa_; }        ///< from 1/2 to less than 1, or 0
  std::int64_t exponent() const { return exponent_; }  ///< of two

 private:
  ErrorBound(double mantissa, std::int64_t exponent) : ErrorBound(mantissa) {
    exponent_ += mantissa_ == 0 ? 0 : exponent;
  }
  struct Normal {};  ///< the mantissa is from 1/2 to less than 1
  ErrorBound(Normal, double mantissa, std::int64_t exponent) : mantissa_(mantissa), exponent_(exponent) {}
  static double up(double value) { return value * (1 + 0x1p-50); }

  double mantissa_ = 0;
  std::int64_t exponent_ = 0;
};

class Real {
 public:
  struct Number;  ///< a whole number of any size: real.cpp

  Real();
  Real(double value);  // NOLINT(google-explicit-constructor): a double converts. Requires: finite
  // Not inline: copies of numbers are most of what the templates over them compile.
  Real(const Real&);
  Real(Real&&) noexcept;
  Real& operator=(const Real&);
  Real& operator=(Real&&) noexcept;
  ~Real();

  /// A result, and whether no digit of it was cut off.
  struct Result;
  static Result sum(const Real& a, const Real& b);
  static Result product(const Real& a, const Real& b);
  static Result quotient(const Real& a, const Real& b);  ///< Requires: b != 0
  static Result root(const Real& a);                     ///< Requires: a >= 0
  static Result nearest(const Rational& value);

  friend Real operator-(const Real& a);
  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real operator*(const Real& a, const Real& b);
  friend Real operator/(const Real& a, const Real& b);
  friend Real sqrt(const Real& a);
  friend Real ldexp(const Real& a, std::int64_t exponent);
  friend Real halved(const Real& a) { return ldexp(a, -1); }

  friend std::strong_ordering operator<=>(const Real& a, const Real& b);
  friend bool operator==(const Real& a, const Real& b) { return (a <=> b) == 0; }

  /// The largest whole number up to it.
  Real floor() const;
  bool is_zero() const { return number_ == nullptr; }
  bool is_negative() const { return leading_ < 0; }

  /// The exponent e with 2^(e-1) <= |value| < 2^e; 0 for 0.
  std::int64_t exponent() const { return size_; }

  /// The double that is value / 2^exponent, truncated.
  double over_power_of_two(std::int64_t exponent) const {
    constexpr std::int64_t most = 2000;
    return std::ldexp(leading_, static_cast<int>(std::clamp(size_ - exponent, -most, most)));
  }
  double rough() const { return over_power_of_two(0); }

  Rational rational() const;  ///< exactly

  ErrorBound most() const { return is_zero() ? ErrorBound() : ldexp(ErrorBound(std::abs(leading_) + 0x1p-52), size_); }
  ErrorBound least() const { return ldexp(ErrorBound(std::abs(leading_)), size_); }

  /// Pi, to two units of the last digit in use.
  static Real pi();

  static int bits();      ///< of the digits in use, on this thread
  static bool is_last();  ///< more digits are not used: what they do not tell from zero is zero

 private:
  friend class RealPrecision;
  Real(Number number, std::int64_t exponent);
  static Result rounded(Number number, std::int64_t exponent);

  std::shared_ptr<const Number> number_;  ///< m, not 0; null: the value is 0
  std::int64_t exponent_ = 0;             ///< e
  double leading_ = 0;                    ///< value / 2^size, truncated: from 1/2 to less than 1 in size, or 0
  std::int64_t size_ = 0;                 ///< exponent()
};

struct Real::Result {
  Real value;
  bool is_exact;
};

/// The digits in use on this thread, while it exists.
class RealPrecision {
 public:
  explicit RealPrecision(int bits, bool is_last = false);
  ~RealPrecision();
  RealPrecision(const RealPrecision&) = delete;
  RealPrecision& operator=(const RealPrecision&) = delete;

 private:
  int bits_before_;
  bool last_before_;
};

}  // namespace tcb
