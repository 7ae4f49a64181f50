// Printing decimals of more digits than doubles have: the notation is the shorter one, as for doubles.
#include "numbers/print_number.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcb {
namespace {

std::string shortest_text(LongDecimal::Digits digits, int exponent, bool negative = false) {
  std::string out(100, '\0');
  return {out.data(), write_decimal({digits, exponent, negative}, {}, out.data())};
}

TEST(PrintDecimal, plain_or_scientific_whichever_is_shorter) {
  EXPECT_EQ(shortest_text(123, 0), "123");
  EXPECT_EQ(shortest_text(123, -2), "1.23");
  EXPECT_EQ(shortest_text(123, -5, true), "-0.00123");
  EXPECT_EQ(shortest_text(123, -9), "1.23e-07");
  EXPECT_EQ(shortest_text(123, 4), "1230000");
  EXPECT_EQ(shortest_text(123, 30), "1.23e+32");
  EXPECT_EQ(shortest_text(1, 5), "1e+05");
  EXPECT_EQ(shortest_text(1, 200), "1e+200");
  EXPECT_EQ(shortest_text(12, -201, true), "-1.2e-200");
}

}  // namespace
}  // namespace tcb
