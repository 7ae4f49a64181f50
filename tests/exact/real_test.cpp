// Real: results are within a unit of their last digit, exact where they can be, and balls around them hold theirs;
// against rationals.
#include "exact/real.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "exact/ball.hpp"
#include "exact/float_scalar.hpp"

namespace tcb {
namespace {

/// Numbers of any size and number of bits.
class Numbers {
 public:
  Real next() {
    Real value(std::ldexp(static_cast<double>(random_() >> 11) - 0x1p52, static_cast<int>(random_() % 80) - 40));
    if (random_() % 2 == 0) value = value + ldexp(Real(1.0), value.exponent() - static_cast<int>(random_() % 300));
    if (random_() % 3 == 0) value = ldexp(value, static_cast<int>(random_() % 4000) - 2000);
    return value;
  }
  unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }

 private:
  std::mt19937_64 random_{1};
};

Rational power_of_two(int exponent) {
  return exponent < 0 ? ratio(1, Integer(1) << -exponent) : rational(Integer(1) << exponent);
}

void expect_rounded(const Real::Result& result, const Rational& exact) {
  const Rational error = abs(result.value.rational() - exact);
  EXPECT_LE(error, abs(result.value.rational()) * power_of_two(1 - Real::bits()));
  EXPECT_EQ(result.is_exact, error == 0);
}

TEST(Real, operations_are_rounded_once) {
  Numbers numbers;
  for (const int bits : {60, 192, 700}) {
    const RealPrecision precision(bits);
    for (int i = 0; i < 300; ++i) {
      const Real a = numbers.next(), b = i % 5 == 0 ? -a + ldexp(a, -50) : numbers.next();
      const Rational x = a.rational(), y = b.rational();
      expect_rounded(Real::sum(a, b), x + y);
      expect_rounded(Real::product(a, b), x * y);
      if (!b.is_zero()) expect_rounded(Real::quotient(a, b), x / y);
      expect_rounded(Real::nearest(x / 3), x / 3);
      EXPECT_EQ(a <=> b, x <=> y);
      EXPECT_EQ(a.floor().rational(), floor(x));
      EXPECT_LE(abs(x), Middle<Real>::number(a.most()).rational());
      EXPECT_GE(abs(x), Middle<Real>::number(a.least()).rational());
      const Real size = a.is_negative() ? -a : a;
      const auto root = Real::root(size);
      const Rational low = root.value.rational(), high = low + low * power_of_two(1 - bits);
      EXPECT_LE(low * low, abs(x));
      EXPECT_GE(high * high, abs(x));
      EXPECT_EQ(root.is_exact, low * low == abs(x));
    }
  }
  EXPECT_TRUE(Real::root(Real(2.25)).is_exact);
}

TEST(Real, bounds_bound) {
  std::mt19937_64 random(2);
  const auto next = [&] {
    return ldexp(ErrorBound(static_cast<double>(random() >> 11)), static_cast<int>(random() % 300));
  };
  const auto exact = [](const ErrorBound& bound) { return Middle<Real>::number(bound).rational(); };
  for (int i = 0; i < 500; ++i) {
    const ErrorBound a = next(), b = next();
    EXPECT_GE(exact(a + b), exact(a) + exact(b));
    EXPECT_GE(exact(a * b), exact(a) * exact(b));
    EXPECT_GE(exact(a / b), exact(a) / exact(b));
    EXPECT_GE(exact(sqrt(a)) * exact(sqrt(a)), exact(a));
    EXPECT_EQ(a < b, exact(a) < exact(b));
    EXPECT_TRUE(!(b < a) || exact(at_least(a, b)) <= exact(a) - exact(b));
  }
}

TEST(RealBall, a_ball_holds_the_results_for_its_numbers) {
  Numbers numbers;
  const RealPrecision precision(150);
  const auto holds = [](const RealBall& ball, const Rational& number) {
    return abs(number - ball.middle().rational()) <= Middle<Real>::number(ball.radius()).rational();
  };
  for (int i = 0; i < 1000; ++i) {
    const auto any = [&] {
      const Real middle = numbers.next();
      const ErrorBound radius =
          numbers.below(3) == 0 ? ErrorBound() : ldexp(middle.most(), -static_cast<int>(numbers.below(150)));
      return RealBall(middle, radius);
    };
    const RealBall a = any(), b = any();
    const Rational x = a.middle().rational() + Middle<Real>::number(a.radius()).rational();
    const Rational y = b.middle().rational() - Middle<Real>::number(b.radius()).rational();
    EXPECT_TRUE(holds(a + b, x + y));
    EXPECT_TRUE(holds(a - b, x - y));
    EXPECT_TRUE(holds(a * b, x * y));
    try {
      EXPECT_TRUE(holds(a / b, x / y));
      EXPECT_EQ(a < b, x < y);
    } catch (const Undecided&) {
      EXPECT_TRUE(b.may_be_zero() || (a - b).may_be_zero());
    }
    const RealBall square = a * a;
    EXPECT_TRUE(holds(sqrt(square), abs(x)));
  }
}

TEST(RealBall, angles_are_held) {
  std::mt19937_64 random(3);
  for (const int bits : {120, 192, 500}) {
    const RealPrecision precision(bits);
    for (int i = 0; i < 40; ++i) {
      const double angle = (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * (i % 4 == 0 ? 1e-30 : 600);
      const auto [sine, cosine] = sine_cosine(RealBall(angle));
      const RealBall back = angle_of(abs(sine), cosine);
      const auto expect_held = [&](const Float<664>& number, const RealBall& ball) {
        const Rational error = abs(rational_of(number) - ball.middle().rational());
        EXPECT_LE(error, Middle<Real>::number(ball.radius()).rational()) << angle;
        EXPECT_LT(ball.radius(), ErrorBound::power_of_two(20 - bits)) << angle;
      };
      expect_held(sin(Float<664>(angle)), sine);
      expect_held(cos(Float<664>(angle)), cosine);
      expect_held(atan2(Float<664>(abs(sin(Float<664>(angle)))), cos(Float<664>(angle))), back);
    }
  }
}

TEST(RealBall, at_the_last_precision_what_is_not_told_apart_is_equal) {
  const RealBall third = RealBall(1.0) / RealBall(3.0), rest = third * RealBall(3.0) - RealBall(1.0);
  EXPECT_THROW((void)(rest == RealBall()), Undecided);
  const RealPrecision last(192, true);
  EXPECT_EQ(rest, RealBall());
  EXPECT_EQ(floor(rest + RealBall(2.0)), RealBall(2.0));
}

}  // namespace
}  // namespace tcb
