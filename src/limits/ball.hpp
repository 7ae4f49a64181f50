// Ball: a number with a bound on its error, so that arithmetic on balls proves its own accuracy.
//
// Every operation returns a ball that holds the results for all numbers in its operands. Middles are double-doubles, or
// floats of many bits. The errors of the operations on double-doubles themselves are bounded by constants that are at
// least twice those of the analysis in
//   M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
//   arithmetic", ACM Trans. Math. Softw. 44 (2017), doi:10.1145/3121432,
// and leave room for the operations of tcb/spline/scalar.hpp, which differ from theirs. Double-doubles whose products
// could overflow are refused, as are comparisons that a ball does not decide: then more digits are needed. At the last
// precision (is_last) numbers that a small ball does not tell apart are equal.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "exact/float_scalar.hpp"
#include "exact/rounding.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

using WideFloat = Float<400>;
/// More digits are not used: what they do not tell from zero is zero.
using LastFloat = Float<2000>;

/// Operations on the middles of balls: each adds to `error` a bound on its own.
template <class M>
struct Middle;

template <>
struct Middle<spline::DoubleDouble> {
  using M = spline::DoubleDouble;
  using Bound = double;

  static int bits() { return 100; }
  static bool is_last() { return false; }
  static bool is_zero(const M& a) { return a.hi == 0; }
  static bool is_negative(const M& a) { return a.hi < 0; }
  static double most(const M& a) { return (1 + 0x1p-50) * std::abs(a.hi); }
  static double least(const M& a) { return (1 - 0x1p-50) * std::abs(a.hi); }
  /// More than a sum of positive numbers that was rounded a few times.
  static double up(double sum) { return sum * (1 + 0x1p-48); }
  static double power_of_two(int exponent) { return std::ldexp(1.0, exponent); }
  static double difference(double a, double b) { return a - b; }

  [[gnu::flatten]] static M sum(const M& a, const M& b, double& error) {
    const bool is_exact = a.lo == 0 && b.lo == 0;  // by Knuth's sum
    if (!is_exact) error += 0x1p-101 * (std::abs(a.hi) + std::abs(b.hi)) + underflow;
    return a + b;
  }
  [[gnu::flatten]] static M product(const M& a, const M& b, double& error) {
    const M product = a * b;
    error += 0x1p-100 * std::abs(product.hi) + underflow;
    return product;
  }
  [[gnu::flatten]] static M quotient(const M& a, const M& b, double& error) {
    const M quotient = a / b;
    error += 0x1p-99 * std::abs(quotient.hi) + underflow;
    return quotient;
  }
  static M scaled(const M& a, int exponent) { return {std::ldexp(a.hi, exponent), std::ldexp(a.lo, exponent)}; }
  static double scaled(double bound, int exponent) { return std::ldexp(bound, exponent) + (bound > 0 ? underflow : 0); }
  static double rough(const M& a) { return a.hi; }
  static M number(double bound) { return bound; }
  /// Whether products and squares of such numbers do not overflow.
  static bool is_in_range(const M& middle, double radius) { return std::abs(middle.hi) < largest && radius < largest; }
  /// Whether squares of such a number might underflow.
  static bool is_tiny(const M& middle) { return std::abs(middle.hi) <= smallest && middle.hi != 0; }

 private:
  static constexpr double underflow = 0x1p-1000;  ///< below all errors of numbers that are in range
  static constexpr double smallest = 0x1p-400, largest = 0x1p400;
};

template <unsigned width>
struct Middle<Float<width>> {
  using M = Float<width>;
  using Bound = Float<64>;

  static constexpr int bits() { return width; }
  static constexpr bool is_last() { return std::is_same_v<M, LastFloat>; }
  static bool is_zero(const M& a) { return a == 0; }
  static bool is_negative(const M& a) { return a < 0; }
  static Bound most(const M& a) { return Bound(abs(a)) * (1 + 0x1p-50); }
  static Bound least(const M& a) { return Bound(abs(a)) * (1 - 0x1p-50); }
  static Bound up(const Bound& sum) { return sum * (1 + 0x1p-48); }
  static Bound power_of_two(int exponent) { return ldexp(Bound(1), exponent); }
  static Bound difference(const Bound& a, const Bound& b) { return a - b; }

  static M sum(const M& a, const M& b, Bound& error) {
    const bool is_exact = a == 0 || b == 0 || std::max(top(a), top(b)) - std::min(last(a), last(b)) < bits() - 2;
    return with_error(a + b, is_exact, error);
  }
  static M product(const M& a, const M& b, Bound& error) {
    return with_error(a * b, a == 0 || b == 0 || size(a) + size(b) <= bits(), error);
  }
  static M quotient(const M& a, const M& b, Bound& error) {
    const M result = a / b;
    return with_error(result, a == 0 || (size(result) + size(b) <= bits() && result * b == a), error);
  }
  static M scaled(const M& a, int exponent) { return ldexp(a, exponent); }
  static Bound scaled(const Bound& bound, int exponent) { return ldexp(bound, exponent); }
  static double rough(const M& a) { return static_cast<double>(a); }
  static M number(const Bound& bound) { return M(bound); }
  static bool is_in_range(const M&, const Bound&) { return true; }
  static bool is_tiny(const M&) { return false; }

 private:
  static M with_error(const M& result, bool is_exact, Bound& error) {
    if (!is_exact) error += most(result) * power_of_two(1 - bits());
    return result;
  }
  /// The exponents of the first and of the last bit of a number that is not 0, and how many there are.
  static int top(const M& a) { return a.backend().exponent(); }
  static int last(const M& a) { return top(a) - bits() + 1 + static_cast<int>(eval_lsb(a.backend().bits())); }
  static int size(const M& a) { return top(a) - last(a) + 1; }
};

/// All numbers within `radius` of the middle.
template <class M>
class BallOf {
 public:
  using Ops = Middle<M>;
  using Bound = typename Ops::Bound;

  BallOf() = default;
  BallOf(double value) : middle_(value) {}  // NOLINT(google-explicit-constructor): a double converts
  /// Requires: |value| < 2^53.
  template <std::integral Integer>
  explicit BallOf(Integer value) : middle_(static_cast<double>(value)) {}
  explicit BallOf(const M& middle, const Bound& radius = 0.0) : middle_(middle), radius_(radius) {}

  const M& middle() const { return middle_; }
  const Bound& radius() const { return radius_; }
  bool is_zero() const { return Ops::is_zero(middle_) && radius_ == 0.0; }
  /// A double near the middle. That of a number beyond the range of doubles is infinite, or 0.
  double rough() const { return Ops::rough(middle_); }

  friend BallOf operator-(const BallOf& a) { return BallOf(-a.middle_, a.radius_); }
  friend BallOf operator+(const BallOf& a, const BallOf& b) {
    if (b.is_zero()) return a;
    if (a.is_zero()) return b;
    Bound radius = a.radius_ + b.radius_;
    const M sum = Ops::sum(a.middle_, b.middle_, radius);
    return checked(sum, Ops::up(radius));
  }
  friend BallOf operator-(const BallOf& a, const BallOf& b) { return a + -b; }
  friend BallOf operator*(const BallOf& a, const BallOf& b) {
    if (a.is_zero() || b.is_zero()) return {};
    Bound radius = 0.0;
    if (a.radius_ != 0.0 || b.radius_ != 0.0) {
      radius = Ops::most(a.middle_) * b.radius_ + Ops::most(b.middle_) * a.radius_ + a.radius_ * b.radius_;
    }
    const M product = Ops::product(a.middle_, b.middle_, radius);
    return checked(product, Ops::up(radius));
  }
  friend BallOf operator/(const BallOf& a, const BallOf& b) {
    const Bound least_divisor = Ops::difference(Ops::least(b.middle_), b.radius_);
    if (!(least_divisor > 0.0)) throw Undecided();
    if (a.is_zero()) return {};
    Bound radius = 0.0;
    const M quotient = Ops::quotient(a.middle_, b.middle_, radius);
    if (a.radius_ != 0.0 || b.radius_ != 0.0) {
      radius = radius + (a.radius_ + Ops::most(quotient) * b.radius_ + radius * b.radius_) / least_divisor;
    }
    return checked(quotient, Ops::up(radius));
  }
  BallOf& operator+=(const BallOf& other) { return *this = *this + other; }
  BallOf& operator-=(const BallOf& other) { return *this = *this - other; }
  BallOf& operator*=(const BallOf& other) { return *this = *this * other; }
  BallOf& operator/=(const BallOf& other) { return *this = *this / other; }

  friend BallOf ldexp(const BallOf& a, int exponent) {
    return checked(Ops::scaled(a.middle_, exponent), Ops::scaled(a.radius_, exponent));
  }
  /// Either will do where they may be equal.
  friend BallOf rough_max(const BallOf& a, const BallOf& b) { return a.middle_ < b.middle_ ? b : a; }

  /// The same ball with a larger radius.
  BallOf widened(const Bound& error) const { return checked(middle_, Ops::up(radius_ + error)); }

  friend bool is_exactly_zero(const BallOf& a) { return a.is_zero(); }
  bool may_be_zero() const { return Ops::least(middle_) <= radius_; }

  /// Whether it holds 0, and no precision distinguishes it from 0. Next to a cusp a place has half the digits: a number
  /// that is not known to a third of them is not 0.
  bool is_zero_at_last() const {
    return may_be_zero() && (is_zero() || (Ops::is_last() && radius_ < Ops::power_of_two(-Ops::bits() / 3)));
  }

  /// No number in the ball is larger in size.
  Bound most() const { return Ops::up(Ops::most(middle_) + radius_); }

  friend BallOf without_radius(const BallOf& a) { return BallOf(a.middle_); }
  friend BallOf abs(const BallOf& a) { return Ops::is_negative(a.middle_) ? -a : a; }

  /// Each throws Undecided unless all numbers in the balls compare alike.
  friend bool operator<(const BallOf& a, const BallOf& b) { return sign_of(a, b) < 0; }
  friend bool operator>(const BallOf& a, const BallOf& b) { return sign_of(a, b) > 0; }
  friend bool operator<=(const BallOf& a, const BallOf& b) { return sign_of(a, b) <= 0; }
  friend bool operator>=(const BallOf& a, const BallOf& b) { return sign_of(a, b) >= 0; }
  friend bool operator==(const BallOf& a, const BallOf& b) { return sign_of(a, b) == 0; }

 private:
  /// A tiny middle is moved to 0. Throws: Undecided for numbers that are beyond the range of the arithmetic.
  static BallOf checked(const M& middle, const Bound& radius) {
    if (!Ops::is_in_range(middle, radius)) throw Undecided();
    if (Ops::is_tiny(middle)) return BallOf(M(), Ops::up(radius + Ops::most(middle)));
    return BallOf(middle, radius);
  }

  static int sign_of(const BallOf& a, const BallOf& b) {
    if (a.radius_ == 0.0 && b.radius_ == 0.0) return a.middle_ < b.middle_ ? -1 : a.middle_ == b.middle_ ? 0 : 1;
    const BallOf difference = a - b;
    if (!difference.may_be_zero()) return Ops::is_negative(difference.middle_) ? -1 : 1;
    return difference.is_zero_at_last() ? 0 : throw Undecided();
  }

  M middle_{};
  Bound radius_ = 0.0;
};

using Ball = BallOf<spline::DoubleDouble>;

template <class S>
inline constexpr bool is_ball = false;
template <class M>
inline constexpr bool is_ball<BallOf<M>> = true;

template <>
inline Ball scalar_of<Ball>(const Rational& value) {
  const Bounded number = scalar_of<Bounded>(value);
  if (!std::isfinite(number.error)) throw Undecided();
  return Ball(number.value).widened(number.error);
}
template <unsigned bits>
BallOf<Float<bits>> ball_of(const Rational& value) {
  const Float<bits> middle = float_of<bits>(value);
  const bool is_exact = rational_of<bits>(middle) == value;
  using Ops = Middle<Float<bits>>;
  return BallOf<Float<bits>>(
      middle, is_exact ? typename Ops::Bound(0)
                       : typename Ops::Bound(Ops::most(middle) * Ops::power_of_two(2 - static_cast<int>(bits))));
}
template <>
inline BallOf<WideFloat> scalar_of<BallOf<WideFloat>>(const Rational& value) {
  return ball_of<400>(value);
}
template <>
inline BallOf<LastFloat> scalar_of<BallOf<LastFloat>>(const Rational& value) {
  return ball_of<2000>(value);
}

}  // namespace tcb
