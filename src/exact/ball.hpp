// Ball: a double-double with a bound on its error, so that arithmetic on balls proves its own accuracy.
//
// Every operation returns a ball that holds the results for all numbers in its operands. The errors of the operations
// on double-doubles themselves are bounded by constants that are at least twice those of the analysis in
//   M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
//   arithmetic", ACM Trans. Math. Softw. 44 (2017), doi:10.1145/3121432,
// and leave room for the operations of tcb/spline/scalar.hpp, which differ from theirs. Numbers whose products could
// underflow are refused, as are comparisons that a ball does not decide: then more digits are needed.
#pragma once

#include <cmath>
#include <concepts>
#include <exception>
#include <limits>

#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "tcb/spline/scalar.hpp"
#include "tcb/spline/segment.hpp"

namespace tcb {

/// A ball does not decide a comparison, or may be beyond the range of its arithmetic.
class Undecided : public std::exception {
 public:
  const char* what() const noexcept override { return "tcb::Undecided"; }
};

/// All numbers within `radius` of middle.hi + middle.lo.
class Ball {
 public:
  Ball() = default;
  Ball(double value) : middle_(value) {}  // NOLINT(google-explicit-constructor): a double converts
  /// Requires: |value| < 2^53.
  template <std::integral Integer>
  explicit Ball(Integer value) : middle_(static_cast<double>(value)) {}
  explicit Ball(const spline::DoubleDouble& middle, double radius = 0) : middle_(middle), radius_(radius) {}

  const spline::DoubleDouble& middle() const { return middle_; }
  double radius() const { return radius_; }
  bool is_zero() const { return middle_.hi == 0 && radius_ == 0; }

  friend Ball operator-(const Ball& a) { return Ball(-a.middle_, a.radius_); }
  friend Ball operator+(const Ball& a, const Ball& b) {
    if (b.is_zero()) return a;
    if (a.is_zero()) return b;
    const bool is_exact = a.middle_.lo == 0 && b.middle_.lo == 0;  // by Knuth's sum
    const double error = is_exact ? 0 : 0x1p-101 * (std::abs(a.middle_.hi) + std::abs(b.middle_.hi)) + least;
    return checked(a.middle_ + b.middle_, up(a.radius_ + b.radius_ + error));
  }
  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
  friend Ball operator*(const Ball& a, const Ball& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const spline::DoubleDouble product = a.middle_ * b.middle_;
    const double error = 0x1p-100 * std::abs(product.hi) + least;
    const double spread = a.radius_ == 0 && b.radius_ == 0
                              ? 0
                              : a.size() * b.radius_ + b.size() * a.radius_ + a.radius_ * b.radius_ + least;
    return checked(product, up(spread + error));
  }
  friend Ball operator/(const Ball& a, const Ball& b) {
    const double least_divisor = (1 - 0x1p-50) * std::abs(b.middle_.hi) - b.radius_;
    if (!(least_divisor > 0)) throw Undecided();
    if (a.is_zero()) return {};
    const spline::DoubleDouble quotient = a.middle_ / b.middle_;
    const double size = std::abs(quotient.hi), error = 0x1p-99 * size + least;
    const double spread =
        a.radius_ == 0 && b.radius_ == 0 ? 0 : (a.radius_ + (1 + 0x1p-50) * size * b.radius_) / least_divisor + least;
    return checked(quotient, up(spread + error));
  }
  Ball& operator+=(const Ball& other) { return *this = *this + other; }
  Ball& operator-=(const Ball& other) { return *this = *this - other; }
  Ball& operator*=(const Ball& other) { return *this = *this * other; }
  Ball& operator/=(const Ball& other) { return *this = *this / other; }

  /// Requires: all numbers in the ball are at least 0. Throws: Undecided if some are not positive, unless all are 0.
  friend Ball sqrt(const Ball& a) {
    if (a.is_zero()) return {};
    const double least_square = (1 - 0x1p-50) * a.middle_.hi - a.radius_;
    if (!(least_square > 0)) throw Undecided();
    const spline::DoubleDouble root = spline::sqrt(a.middle_);
    const double spread =
        a.radius_ == 0 ? 0 : a.radius_ / root.hi + least;  // a - b = (sqrt a + sqrt b)(sqrt a - sqrt b)
    return checked(root, up(spread + 0x1p-98 * root.hi + least));
  }

  /// Throws: Undecided unless it is the same for all numbers in the ball.
  friend Ball floor(const Ball& a) {
    const double whole = std::floor(a.middle_.hi);
    const Ball below = a.middle_.lo < 0 && whole == a.middle_.hi ? whole - 1 : whole;
    if (!(a >= below && a < below + Ball(1.0))) throw Undecided();
    return below;
  }

  friend Ball ldexp(const Ball& a, int exponent) {
    const auto scaled = [&](double number) { return std::ldexp(number, exponent); };
    return checked({scaled(a.middle_.hi), scaled(a.middle_.lo)}, scaled(a.radius_) + (a.radius_ > 0 ? least : 0));
  }
  /// The exponent is that of the middle.
  friend Ball frexp(const Ball& a, int* exponent) {
    (void)std::frexp(a.middle_.hi, exponent);
    return ldexp(a, -*exponent);
  }
  /// Either will do where they may be equal.
  friend Ball rough_max(const Ball& a, const Ball& b) { return a.middle_ < b.middle_ ? b : a; }

  /// The whole number that a ball is.
  explicit operator int() const { return static_cast<int>(middle_.hi); }

  /// The same ball with a larger radius. Requires: error >= 0.
  Ball widened(double error) const { return checked(middle_, up(radius_ + error)); }

  bool may_be_zero() const { return (1 - 0x1p-50) * std::abs(middle_.hi) <= radius_; }

  /// No number in the ball is larger in size.
  double most() const { return up(size() + radius_); }

  friend Ball abs(const Ball& a) { return a.middle_.hi < 0 ? -a : a; }
  friend Ball halved(const Ball& a) { return checked(halved(a.middle_), a.radius_ / 2 + (a.radius_ > 0 ? least : 0)); }

  /// Each throws Undecided unless all numbers in the balls compare alike.
  friend bool operator<(const Ball& a, const Ball& b) { return sign_of(a, b) < 0; }
  friend bool operator>(const Ball& a, const Ball& b) { return sign_of(a, b) > 0; }
  friend bool operator<=(const Ball& a, const Ball& b) { return sign_of(a, b) <= 0; }
  friend bool operator>=(const Ball& a, const Ball& b) { return sign_of(a, b) >= 0; }
  friend bool operator==(const Ball& a, const Ball& b) { return sign_of(a, b) == 0; }

 private:
  /// Below all errors of numbers that are not refused.
  static constexpr double least = 0x1p-1000;
  static constexpr double smallest = 0x1p-400, largest = 0x1p400;

  /// More than a sum of positive numbers that was rounded a few times.
  static double up(double sum) { return sum * (1 + 0x1p-48); }
  double size() const { return (1 + 0x1p-50) * std::abs(middle_.hi); }

  /// Throws: Undecided for numbers whose products or squares may underflow or overflow.
  static Ball checked(const spline::DoubleDouble& middle, double radius) {
    const double size = std::abs(middle.hi);
    const bool is_in_range = size < largest && radius < largest && (size > smallest || size == 0);
    if (!is_in_range) throw Undecided();
    return Ball(middle, radius);
  }

  static int sign_of(const Ball& a, const Ball& b) {
    if (a.radius_ == 0 && b.radius_ == 0) return a.middle_ < b.middle_ ? -1 : a.middle_ == b.middle_ ? 0 : 1;
    const Ball difference = a - b;
    if ((1 - 0x1p-50) * std::abs(difference.middle_.hi) <= difference.radius_) throw Undecided();
    return difference.middle_.hi < 0 ? -1 : 1;
  }

  spline::DoubleDouble middle_;
  double radius_ = 0;
};

/// The double nearest to all numbers in a ball, if that is the same one.
inline bool rounds_to_one_double(const Ball& ball) {
  const auto& [high, low] = ball.middle();
  constexpr double slack = 0x1p-50;  // for the rounding of the sums of `low`
  const double radius = ball.radius() + slack * (std::abs(low) + ball.radius());
  return ball.radius() == 0 && low == 0 ? true
                                        : high != 0 && high + (low + radius) == high && high + (low - radius) == high;
}

}  // namespace tcb

/// The precision of balls whose radius is only that of rounding.
template <>
class std::numeric_limits<tcb::Ball> {
 public:
  static constexpr bool is_specialized = true, is_exact = false, is_integer = false;
  static constexpr int digits = 100, digits10 = 30;
  static tcb::Ball epsilon() { return tcb::Ball(0x1p-99); }
};

namespace tcb::spline {

template <>
inline constexpr bool bounds_errors<Ball> = true;

/// Either end will do where a ball does not tell which is nearer.
template <>
inline bool LocalParameter<Ball>::near_start() const {
  return u.middle().hi <= 0.5;
}

/// The ball carries its rounding errors already.
template <>
inline Ball compensated_cubic<Ball>(const Ball& base, const Ball& a, const Ball& b, const Ball&, const Ball& d,
                                    const Ball& x) {
  return base + x * (a + x * (b + x * d));
}

/// The eigenvector of its method is found by steps without a bound on the error.
template <>
inline Quaternion<Ball> nearest_rotation<Ball>(RotationNumbers<Ball>) {
  throw Undecided();
}

/// Each term is that before times a factor (odd^2 - u^2) square / ((odd + 1) (odd + 2)) < 1/64, so that all that are
/// left out are below 1/63 of the last one.
inline Ball truncated_series(const Ball& sum, const Ball& last_term, const Ball&, const Ball&) {
  return sum.widened(0x1p-5 * last_term.most());
}
/// The derivative of a factor is at most `change`, so that those of the terms that are left out are together at most
/// 1/63 of that of the last one, and 1.1 `change` of the last one.
inline Dual<Ball> truncated_series(const Dual<Ball>& sum, const Dual<Ball>& last_term, const Dual<Ball>& u,
                                   const Dual<Ball>& square) {
  const double change = square.slope.most() + 0x1p-5 * u.value.most() * u.slope.most();
  return {truncated_series(sum.value, last_term.value, u.value, square.value),
          sum.slope.widened(0x1p-5 * last_term.slope.most() + 1.2 * change * last_term.value.most())};
}

}  // namespace tcb::spline
