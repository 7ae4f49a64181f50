// Ball: every result is held by its ball, against 200 digits, also for operands that cancel, and comparisons that a
// ball does not decide are refused.
#include "limits/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "exact/hostile_operands.hpp"

namespace tcb {
namespace {

/// The distance of a number from the middle of a ball, in radii.
void expect_held(const Exact& number, const Ball& ball, const char* operation) {
  const Exact distance = abs(number - exactly(ball.middle()));
  EXPECT_LE(distance, Exact(ball.radius()))
      << operation << " " << ball.middle().hi << " by " << static_cast<double>(distance) << " of " << ball.radius();
}

TEST(Ball, holds_the_results_of_hostile_operands) {
  HostileOperands<Ball> operands(1);
  for (int i = 0; i < 40'000; ++i) {
    const auto a = operands.next(), b = i % 2 == 0 ? operands.next() : operands.negative(a.held.middle());
    expect_held(a.number + b.number, a.held + b.held, "+");
    expect_held(a.number - b.number, a.held - b.held, "-");
    expect_held(a.number * b.number, a.held * b.held, "*");
    expect_held(-a.number, -a.held, "-");
    expect_held(a.number / 2, halved(a.held), "halved");
    expect_held(ldexp(a.number, 7), ldexp(a.held, 7), "ldexp");
    try {
      expect_held(a.number / b.number, a.held / b.held, "/");
    } catch (const Undecided&) {
      EXPECT_GE(b.held.radius(), 0.9 * std::abs(b.held.middle().hi));  // it may hold 0
    }
    if (HasFailure()) return;
  }
}

TEST(Ball, holds_the_results_of_many_operations) {
  HostileOperands<Ball> operands(2);
  for (int i = 0; i < 2000; ++i) {
    auto sum = operands.next();
    for (int j = 0; j < 20; ++j) {
      const auto other = operands.next(), factor = operands.next();
      try {
        sum = {sum.number * factor.number + other.number, sum.held * factor.held + other.held};
      } catch (const Undecided&) {  // beyond the range
        sum = operands.next();
      }
      expect_held(sum.number, sum.held, "* and +");
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
