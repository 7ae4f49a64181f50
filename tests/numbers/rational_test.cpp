// Exact rationals: what is accepted, and rounding once against the C++ library's own.
#include "numbers/rational.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <random>
#include <string>

#include "numbers/large_rational.hpp"

namespace tcb {
namespace {

TEST(Rational, reads_decimals_and_ratios_exactly) {
  EXPECT_EQ(parse_rational("0.1"), Rational(1, 10));
  EXPECT_EQ(parse_rational("-12.50"), Rational(-25, 2));
  EXPECT_EQ(parse_rational("1e-3"), Rational(1, 1000));
  EXPECT_EQ(parse_rational("+2.5E+2"), Rational(250));
  EXPECT_EQ(parse_rational(".5"), Rational(1, 2));
  EXPECT_EQ(parse_rational("007"), Rational(7));
  EXPECT_EQ(parse_rational("1001/30000"), Rational(1001, 30000));
  EXPECT_EQ(parse_rational("1/0.5"), Rational(2));
}

TEST(Rational, refuses_everything_else) {
  for (const char* text :
       {"",    "-",    ".",   "1.", "x",  "1x",    "1/0",           "1/",     "/2", "1e", "1e+-2", "nan",
        "inf", "0x10", "1,5", " 1", "1 ", "1/2/3", "1e99999999999", "1e20000"}) {
    const bool trailing_point = std::string_view(text) == "1.";
    EXPECT_EQ(parse_rational(text).has_value(), trailing_point) << text;
  }
}

TEST(Rational, some_are_beyond_doubles) {
  EXPECT_TRUE(within_doubles(*parse_rational("-1.7976931348623157e308")));
  EXPECT_TRUE(within_doubles(*parse_rational("1e400/1e300")));
  EXPECT_TRUE(within_doubles(*parse_rational("1e-400")));
  EXPECT_FALSE(within_doubles(*parse_rational("1.8e308")));
  EXPECT_FALSE(within_doubles(*parse_rational("-1e400")));
}

TEST(Rational, nearest_time_is_what_the_library_reads) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 4'000; ++i) {
    const int exponent = static_cast<int>(random() % 640) - 330;
    const std::string text = std::to_string(random() >> (random() % 60)) + "e" + std::to_string(exponent);
    double expected = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
    if (error != std::errc() || std::abs(expected) >= 0x1p53) continue;
    ASSERT_EQ(nearest_time(*parse_rational(text)).hi, expected) << text;
  }
}

TEST(Rational, ties_go_to_the_even_double) {
  const Rational ulp = ratio(1, Integer(1) << 52);
  EXPECT_EQ(nearest_time(1 + ulp / 2).hi, 1.0);
  EXPECT_EQ(nearest_time(1 + ulp * 3 / 2).hi, 1 + 0x1p-51);
  EXPECT_EQ(nearest_time(-(1 + ulp / 2)).hi, -1.0);
  EXPECT_EQ(nearest_time(1 + ulp / 2 + ratio(1, Integer(1) << 400)).hi, 1 + 0x1p-52);
}

TEST(Rational, whole_times_beyond_2_to_53_keep_all_digits) {
  const Time time = nearest_time(rational(Integer("1403715524907143169")));
  EXPECT_EQ(exact_time(time), rational(Integer("1403715524907143169")));
  EXPECT_EQ(exact_time(nearest_time(rational(Integer("9007199254740993")))), rational(Integer("9007199254740993")));
}

TEST(Rational, a_double_is_converted_by_its_shortest_decimal) {
  EXPECT_EQ(exact_time({0.1}), Rational(1, 10));
  EXPECT_EQ(exact_time({1e22}), rational(Integer("10000000000000000000000")));
  EXPECT_EQ(exact_time({-1305031098.6659}), ratio(Integer("-13050310986659"), 10000));
}

TEST(Rational, arithmetic_is_that_of_large_rationals) {
  using Number = Rational::Large::Number;
  std::mt19937_64 random(15);
  const auto draw = [&] {
    const auto whole = [&] {
      const Rational size = random() >> (random() % 64);
      return random() % 8 == 0 ? size * random() : random() % 2 == 0 ? size : -size;
    };
    const Rational below = whole();
    return below == 0 ? whole() : Rational(whole(), below);
  };
  for (int i = 0; i < 10'000; ++i) {
    const Rational a = draw(), b = i % 7 == 0 ? a : draw();
    const Number x = a.large().number, y = b.large().number;
    ASSERT_EQ((a + b).large().number, x + y);
    ASSERT_EQ((a - b).large().number, x - y);
    ASSERT_EQ((a * b).large().number, x * y);
    ASSERT_TRUE(b == 0 || (a / b).large().number == x / y);
    ASSERT_EQ(a == b, x == y);
    ASSERT_EQ(a < b, x < y);
    ASSERT_EQ(a > b, x > y);
    ASSERT_EQ((a + b == a), y == 0);
    ASSERT_EQ(abs(a).large().number, abs(x));
    const Rational whole = floor(a);
    ASSERT_TRUE(denominator(whole) == 1 && whole <= a && a < whole + 1);
  }
}

TEST(Rational, integers_of_all_sizes_are_taken_exactly) {
  for (const std::int64_t value : {INT64_MIN, INT64_MIN + 1, std::int64_t{-1}, std::int64_t{0}, INT64_MAX}) {
    EXPECT_EQ(whole_text(value), std::to_string(value));
    EXPECT_EQ(whole_text(-Rational(value)), value == 0 ? "0" : Integer(-Integer(value)).str());
  }
  EXPECT_EQ(whole_text(UINT64_MAX), std::to_string(UINT64_MAX));
  EXPECT_EQ(whole_number(UINT64_MAX), UINT64_MAX);
  EXPECT_EQ(Rational(0x1p-3), Rational(1, 8));
  EXPECT_EQ(Rational(-0x1p70), -rational(Integer(1) << 70));
  EXPECT_EQ(Rational(0x1p70) / Rational(0x1p69), 2);
}

}  // namespace
}  // namespace tcb
