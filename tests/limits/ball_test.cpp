// Ball: every result is held by its ball, against 200 digits, also for operands that cancel, and comparisons that a
// ball does not decide are refused.
#include "limits/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "exact/float_scalar.hpp"

namespace tcb {
namespace {

using Exact = Float<664>;

Exact middle_of(const Ball& ball) { return Exact(ball.middle().hi) + Exact(ball.middle().lo); }

/// A number and a ball that holds it, whose radius is 0 where the number is a double-double.
struct Operand {
  Exact number;
  Ball ball;
};

class Operands {
 public:
  explicit Operands(unsigned seed) : random_(seed) {}

  /// Doubles and double-doubles of any size, with and without a radius, whose low part may be at its limit.
  Operand next() {
    const double high = scaled(sign() * (1 + unit()), static_cast<int>(random_() % 200) - 100);
    const double largest_low = std::abs(high) * 0x1p-54;
    const int kind = static_cast<int>(random_() % 4);
    const double low = kind == 0 ? 0 : kind == 1 ? sign() * largest_low : sign() * unit() * largest_low;
    const double radius = random_() % 3 == 0 ? 0 : scaled(std::abs(high), -static_cast<int>(random_() % 120));
    const double at = random_() % 2 == 0 ? sign() : 2 * unit() - 1;  // the edge of the ball, or inside
    const auto middle = spline::DoubleDouble::normalized(high, low);
    return {Exact(middle.hi) + Exact(middle.lo) + Exact(at) * Exact(radius), Ball(middle, radius)};
  }

  /// Nearly the negative of a number.
  Operand near(const Operand& other) {
    const double high = -std::nextafter(other.ball.middle().hi, sign() * std::numeric_limits<double>::infinity());
    const double low = random_() % 2 == 0 ? -other.ball.middle().lo : 0;
    const auto middle = spline::DoubleDouble::normalized(high, low);
    return {Exact(middle.hi) + Exact(middle.lo), Ball(middle)};
  }

 private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double sign() { return random_() % 2 == 0 ? 1 : -1; }
  static double scaled(double value, int exponent) { return std::ldexp(value, exponent); }

  std::mt19937_64 random_;
};

/// The distance of a number from the middle of a ball, in radii.
void expect_held(const Exact& number, const Ball& ball, const char* operation) {
  const Exact distance = abs(number - middle_of(ball));
  EXPECT_LE(distance, Exact(ball.radius()))
      << operation << " " << ball.middle().hi << " by " << static_cast<double>(distance) << " of " << ball.radius();
}

TEST(Ball, holds_the_results_of_hostile_operands) {
  Operands operands(1);
  for (int i = 0; i < 40'000; ++i) {
    const Operand a = operands.next(), b = i % 2 == 0 ? operands.next() : operands.near(a);
    expect_held(a.number + b.number, a.ball + b.ball, "+");
    expect_held(a.number - b.number, a.ball - b.ball, "-");
    expect_held(a.number * b.number, a.ball * b.ball, "*");
    expect_held(-a.number, -a.ball, "-");
    expect_held(a.number / 2, halved(a.ball), "halved");
    expect_held(ldexp(a.number, 7), ldexp(a.ball, 7), "ldexp");
    try {
      expect_held(a.number / b.number, a.ball / b.ball, "/");
    } catch (const Undecided&) {
      EXPECT_GE(b.ball.radius(), 0.9 * std::abs(b.ball.middle().hi));  // it may hold 0
    }
    if (HasFailure()) return;
  }
}

TEST(Ball, holds_the_results_of_many_operations) {
  Operands operands(2);
  for (int i = 0; i < 2000; ++i) {
    Operand sum = operands.next();
    for (int j = 0; j < 20; ++j) {
      const Operand other = operands.next(), factor = operands.next();
      try {
        sum = {sum.number * factor.number + other.number, sum.ball * factor.ball + other.ball};
      } catch (const Undecided&) {  // beyond the range
        sum = operands.next();
      }
      expect_held(sum.number, sum.ball, "* and +");
    }
    if (HasFailure()) return;
  }
}

TEST(Ball, sums_of_doubles_and_products_with_zero_are_exact) {
  EXPECT_EQ((Ball(1.0) + Ball(0x1p-60)).radius(), 0);
  EXPECT_EQ((Ball(1.0) + Ball(-1.0)).middle().hi, 0);
  EXPECT_TRUE((Ball(1.0) - Ball(1.0)).is_zero());
  EXPECT_TRUE((Ball({3, 0}, 1e-20) * Ball()).is_zero());
  EXPECT_TRUE((Ball() / Ball({3, 0}, 1e-20)).is_zero());
}

TEST(Ball, compares_what_it_decides) {
  const Ball about_one({1, 0}, 1e-20);
  EXPECT_LT(Ball(0.5), about_one);
  EXPECT_GT(about_one, Ball(1 - 1e-15));
  EXPECT_FALSE(about_one == Ball(2.0));
  EXPECT_TRUE(Ball(1.0) == Ball(1.0));
  EXPECT_THROW((void)(about_one < Ball(1.0)), Undecided);
  EXPECT_THROW((void)(about_one == about_one), Undecided);
  EXPECT_THROW((void)(Ball(1.0) / Ball({1e-30, 0}, 1e-20)), Undecided);
}

TEST(Ball, refuses_what_may_overflow_and_holds_what_may_underflow) {
  const Ball tiny = Ball(0x1p-300) * Ball(0x1p-300);
  EXPECT_TRUE(tiny.may_be_zero());
  EXPECT_FALSE(tiny.is_zero());
  EXPECT_GE(tiny.radius(), 0x1p-600);
  EXPECT_THROW((void)(Ball(0x1p300) * Ball(0x1p300)), Undecided);
  EXPECT_THROW((void)(Ball(1e308) + Ball(1e308)), Undecided);
}

}  // namespace
}  // namespace tcb
