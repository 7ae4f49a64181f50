// Bounded: every result is within its bound, against 664 bits, also for operands that cancel.
#include "exact/bounded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "exact/hostile_operands.hpp"

namespace tcb {
namespace {

/// The number is within the bound.
void expect_held(const Exact& number, const Bounded& bounded, const char* operation) {
  const Exact distance = abs(number - exactly(bounded.value));
  EXPECT_LE(distance, Exact(bounded.error))
      << operation << " " << bounded.value.hi << " by " << static_cast<double>(distance) << " of " << bounded.error;
}

TEST(Bounded, holds_the_results_of_hostile_operands) {
  HostileOperands<Bounded> operands(1);
  for (int i = 0; i < 40'000; ++i) {
    const auto a = operands.next(), b = i % 2 == 0 ? operands.next() : operands.negative(a.held.value);
    expect_held(a.number + b.number, a.held + b.held, "+");
    expect_held(a.number - b.number, a.held - b.held, "-");
    expect_held(a.number * b.number, a.held * b.held, "*");
    expect_held(-a.number, -a.held, "-");
    if (std::isfinite((a.held / b.held).error)) {
      expect_held(a.number / b.number, a.held / b.held, "/");
    } else {
      EXPECT_GE(b.held.error, 0.9 * std::abs(b.held.value.hi));  // it may be 0
    }
    if (HasFailure()) return;
  }
}

TEST(Bounded, holds_the_results_of_many_operations) {
  HostileOperands<Bounded> operands(2);
  for (int i = 0; i < 2000; ++i) {
    auto sum = operands.next();
    for (int j = 0; j < 20; ++j) {
      const auto other = operands.next(), factor = operands.next();
      sum = {sum.number * factor.number + other.number, sum.held * factor.held + other.held};
      if (!std::isfinite(sum.held.error)) sum = operands.next();
      expect_held(sum.number, sum.held, "* and +");
    }
    if (HasFailure()) return;
  }
}

TEST(Bounded, sums_of_doubles_and_products_with_zero_are_exact) {
  EXPECT_EQ((Bounded(1.0) + Bounded(0x1p-60)).error, 0);
  EXPECT_EQ((Bounded(1.0) + Bounded(-1.0)).value.hi, 0);
  EXPECT_TRUE((Bounded(1.0) - Bounded(1.0)).is_zero());
  EXPECT_TRUE((Bounded({3.0, 0}, 1e-20) * Bounded()).is_zero());
  EXPECT_TRUE((Bounded() / Bounded({3.0, 0}, 1e-20)).is_zero());
}

TEST(Bounded, numbers_beyond_the_range_have_no_finite_error) {
  const Bounded huge(0x1p600), tiny(0x1p-600);
  EXPECT_FALSE(std::isfinite((huge * huge).error));
  EXPECT_FALSE(std::isfinite((huge / tiny).error));
  EXPECT_GE((tiny * tiny).error, 0x1p-1000);
  EXPECT_FALSE(std::isfinite(scalar_of<Bounded>(Rational(0x1p-1000)).error));
}

TEST(Bounded, only_numbers_without_errors_are_known_to_be_equal) {
  EXPECT_TRUE(Bounded(1.0) == Bounded(1.0));
  EXPECT_FALSE(Bounded({1.0, 0}, 1e-30) == Bounded(1.0));
  EXPECT_FALSE(Bounded({0.0, 0}, 1e-30) == Bounded());
}

TEST(Bounded, whole_turns_are_known_or_have_no_finite_error) {
  EXPECT_EQ(wrapped(Bounded(725.0), true, false).value.hi, 5);
  EXPECT_EQ(wrapped(Bounded(-90.0), true, false).value.hi, 270);
  EXPECT_EQ(wrapped(Bounded(-180.0), true, true).value.hi, -180);
  EXPECT_FALSE(std::isfinite(wrapped(Bounded({360.0, 0}, 1e-20), true, false).error));
  EXPECT_TRUE(std::isfinite(wrapped(Bounded({1.0, 0}, 1e-20), true, false).error));
}

}  // namespace
}  // namespace tcb
