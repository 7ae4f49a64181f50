// Floats of many bits: roots, against exact numbers.
#include "exact/float_scalar.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tcb {
namespace {

template <class F>
class FloatRoots : public testing::Test {};
using Floats = testing::Types<ShortFloat, LongFloat>;
TYPED_TEST_SUITE(FloatRoots, Floats);

template <unsigned bits>
Rational exactly(const Float<bits>& number) {
  return rational_of<bits>(number);
}

TYPED_TEST(FloatRoots, are_within_two_units_of_the_last_place) {
  constexpr int digits = std::numeric_limits<TypeParam>::digits;
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    TypeParam number(0);
    for (int word = 0; word <= digits / 64; ++word) number = ldexp(number, 64) + TypeParam(random());
    if (i % 2 == 0) number = TypeParam(1) + ldexp(TypeParam(i), 5 - digits);  // whose digits are next to those of 1
    number = ldexp(number, static_cast<int>(random() % 8000) - 4000);
    const Rational root = exactly(TypeParam(spline::square_root(number))), unit = root * power_of_two(1 - digits);
    const Rational low = root - 2 * unit, high = root + 2 * unit;
    EXPECT_LE(low * low, exactly(number));
    EXPECT_GE(high * high, exactly(number));
  }
}

TYPED_TEST(FloatRoots, of_short_squares_are_exact) {
  std::mt19937_64 random(2);
  for (unsigned i = 0; i < 5000; ++i) {
    TypeParam root(i % 2 == 0 ? i : random());
    if (i % 4 == 1) root = ldexp(root, 32) + TypeParam(random() >> 32U);  // 96 bits
    root = ldexp(root, static_cast<int>(random() % 2000) - 1000);
    EXPECT_EQ(spline::square_root(TypeParam(root * root)), root);
  }
}

TYPED_TEST(FloatRoots, of_what_has_none) {
  const TypeParam infinity = std::numeric_limits<TypeParam>::infinity();
  EXPECT_EQ(spline::square_root(TypeParam(0)), 0);
  EXPECT_EQ(spline::square_root(infinity), infinity);
  EXPECT_TRUE(isnan(spline::square_root(TypeParam(-1))));
  EXPECT_TRUE(isnan(spline::square_root(std::numeric_limits<TypeParam>::quiet_NaN())));
}

}  // namespace
}  // namespace tcb
