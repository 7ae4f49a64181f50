// Bounded: every result is within its bound, against 664 bits, also for operands that cancel.
#include "exact/bounded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "exact/float_scalar.hpp"

namespace tcb {
namespace {

using Exact = Float<664>;

Exact value_of(const Bounded& bounded) { return Exact(bounded.value.hi) + Exact(bounded.value.lo); }

/// A number and one that is within a bound of it, which is 0 where the number is a double-double.
struct Operand {
  Exact number;
  Bounded bounded;
};

class Operands {
 public:
  explicit Operands(unsigned seed) : random_(seed) {}

  /// Doubles and double-doubles of any size, with and without a bound, whose low part may be at its limit.
  Operand next() {
    const double high = scaled(sign() * (1 + unit()), static_cast<int>(random_() % 200) - 100);
    const double largest_low = std::abs(high) * 0x1p-54;
    const int kind = static_cast<int>(random_() % 4);
    const double low = kind == 0 ? 0 : kind == 1 ? sign() * largest_low : sign() * unit() * largest_low;
    const double radius = random_() % 3 == 0 ? 0 : scaled(std::abs(high), -static_cast<int>(random_() % 120));
    const double at = random_() % 2 == 0 ? sign() : 2 * unit() - 1;  // the edge of the bound, or inside
    const auto middle = spline::DoubleDouble::normalized(high, low);
    return {Exact(middle.hi) + Exact(middle.lo) + Exact(at) * Exact(radius), Bounded(middle, radius)};
  }

  /// Nearly the negative of a number.
  Operand near(const Operand& other) {
    const double high = -std::nextafter(other.bounded.value.hi, sign() * std::numeric_limits<double>::infinity());
    const double low = random_() % 2 == 0 ? -other.bounded.value.lo : 0;
    const auto middle = spline::DoubleDouble::normalized(high, low);
    return {Exact(middle.hi) + Exact(middle.lo), Bounded(middle, 0)};
  }

 private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double sign() { return random_() % 2 == 0 ? 1 : -1; }
  static double scaled(double value, int exponent) { return std::ldexp(value, exponent); }

  std::mt19937_64 random_;
};

/// The number is within the bound.
void expect_held(const Exact& number, const Bounded& bounded, const char* operation) {
  const Exact distance = abs(number - value_of(bounded));
  EXPECT_LE(distance, Exact(bounded.error))
      << operation << " " << bounded.value.hi << " by " << static_cast<double>(distance) << " of " << bounded.error;
}

TEST(Bounded, holds_the_results_of_hostile_operands) {
  Operands operands(1);
  for (int i = 0; i < 40'000; ++i) {
    const Operand a = operands.next(), b = i % 2 == 0 ? operands.next() : operands.near(a);
    expect_held(a.number + b.number, a.bounded + b.bounded, "+");
    expect_held(a.number - b.number, a.bounded - b.bounded, "-");
    expect_held(a.number * b.number, a.bounded * b.bounded, "*");
    expect_held(-a.number, -a.bounded, "-");
    if (std::isfinite((a.bounded / b.bounded).error)) {
      expect_held(a.number / b.number, a.bounded / b.bounded, "/");
    } else {
      EXPECT_GE(b.bounded.error, 0.9 * std::abs(b.bounded.value.hi));  // it may be 0
    }
    if (HasFailure()) return;
  }
}

TEST(Bounded, holds_the_results_of_many_operations) {
  Operands operands(2);
  for (int i = 0; i < 2000; ++i) {
    Operand sum = operands.next();
    for (int j = 0; j < 20; ++j) {
      const Operand other = operands.next(), factor = operands.next();
      sum = {sum.number * factor.number + other.number, sum.bounded * factor.bounded + other.bounded};
      if (!std::isfinite(sum.bounded.error)) sum = operands.next();
      expect_held(sum.number, sum.bounded, "* and +");
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
