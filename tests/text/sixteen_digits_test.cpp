// Sixteen digits at once: the same as digit by digit, in words and in vectors.
#include "text/sixteen_digits.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace tcb {
namespace {

template <class Sixteen>
class SixteenDigitsOf : public testing::Test {};

using Kinds = testing::Types<SixteenDigitsInWords, SixteenDigits>;
TYPED_TEST_SUITE(SixteenDigitsOf, Kinds);

template <class Sixteen>
void check(std::uint64_t n) {
  std::string expected = std::to_string(n);
  expected.insert(0, 16 - expected.size(), '0');
  const Sixteen digits(n);
  std::string text(17, '#');
  digits.write(text.data());
  ASSERT_EQ(text, expected + '#');
  const auto last = expected.find_last_not_of('0');
  ASSERT_EQ(digits.count(false), last == std::string::npos ? 1 : static_cast<int>(last) + 1) << n;
  ASSERT_EQ(digits.count(true), 17) << n;
}

TYPED_TEST(SixteenDigitsOf, numbers_small_and_large_are_their_text) {
  std::uint64_t power = 1;
  for (int i = 0; i <= 16; ++i, power *= 10) {
    for (std::uint64_t digit = 1; digit < 10 && i < 16; ++digit) check<TypeParam>(digit * power);
    check<TypeParam>(power - 1);
  }
  std::mt19937_64 random(1);
  for (int i = 0; i < 300'000; ++i) check<TypeParam>(random() % 10'000'000'000'000'000);
}

TYPED_TEST(SixteenDigitsOf, each_four_are_their_text) {
  for (std::uint64_t n = 0; n < 10'000; ++n) {
    check<TypeParam>(n + 10'000 * (9999 - n) + 100'000'000 * n + 1'000'000'000'000 * (9999 - n));
  }
}

}  // namespace
}  // namespace tcb
