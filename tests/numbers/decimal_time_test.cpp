// Times of up to 31 digits: each decimal is one time, comes back from it, and is in its order.
#include "numbers/decimal_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

Time time_in(const std::string& text) { return parse_time(text).value(); }

/// A decimal with so many digits, the point after `before` of them.
std::string random_decimal(std::mt19937_64& random, int digits, int before) {
  std::string text;
  for (int i = 0; i < digits; ++i) text += static_cast<char>('0' + random() % 10);
  text.front() = static_cast<char>('1' + random() % 9);
  text.back() = static_cast<char>('1' + random() % 9);
  if (before <= 0) return "0." + std::string(static_cast<std::size_t>(-before), '0') + text;
  return text.insert(static_cast<std::size_t>(before), ".");
}

TEST(DecimalTimes, come_back_as_they_were_written) {
  std::mt19937_64 random(19);
  for (int i = 0; i < 30'000; ++i) {
    const int digits = 18 + static_cast<int>(random() % 14);
    const int before = static_cast<int>(random() % 20) - 2;
    if (before >= digits) continue;
    const std::string text = random_decimal(random, digits, before);
    const Time time = time_in(text);
    ASSERT_EQ(time.hi, parse_number(text)) << text;
    ASSERT_EQ(time_text(time), text);
    ASSERT_EQ(time_text(-time), "-" + text);
    ASSERT_EQ(exact_time(time), parse_rational(text)) << text;
    ASSERT_EQ(nearest_time(*parse_rational(text), 1), time) << text;
    ASSERT_TRUE(has_many_digits(time)) << text;
    const std::size_t point = text.find('.');
    if (before > 0) {
      ASSERT_EQ(decimals_of(time), static_cast<int>(text.size() - point - 1)) << text;
    }
  }
}

TEST(DecimalTimes, low_part_is_the_difference_from_the_double_rounded_once) {
  std::mt19937_64 random(20);
  for (int i = 0; i < 5'000; ++i) {
    const int before = 1 + static_cast<int>(random() % 15), digits = 18 + static_cast<int>(random() % 14);
    const std::string text = random_decimal(random, digits, before);
    const Time time = time_in(text);
    const Rational rest = *parse_rational(text) - Rational(time.hi);
    const double exact = nearest_double(rest);
    if (exact == 0) continue;  // the low part then only tells that the text has many digits
    ASSERT_LE(std::abs(time.lo - exact), std::abs(exact) * 0x1p-52) << text;
  }
}

TEST(DecimalTimes, one_value_has_one_time) {
  const Time time = time_in("1403637576.252524268");
  EXPECT_EQ(time_in("1403637576.252524268000"), time);
  EXPECT_EQ(time_in("+01403637576.252524268"), time);
  EXPECT_EQ(time_in("1.403637576252524268e9"), time);
  EXPECT_EQ(time_in("1403637576252524268E-9"), time);
  EXPECT_NE(time_in("1403637576.252524269"), time);
  EXPECT_EQ(time_in("1403637576.2525242680000000000000000000000000001"), time);
}

TEST(DecimalTimes, have_31_digits_at_most) {
  EXPECT_EQ(time_text(time_in("1.0000000000000000000000000000015")), "1.000000000000000000000000000002");
  EXPECT_EQ(time_text(time_in("1.0000000000000000000000000000025")), "1.000000000000000000000000000002");
  EXPECT_EQ(time_text(time_in("1.00000000000000000000000000000250001")), "1.000000000000000000000000000003");
  EXPECT_EQ(time_text(time_in("12345678901234567890123")), "12345678901234567890123");
  EXPECT_EQ(time_text(time_in("9007199254740993.25")), "9007199254740993.25");
  EXPECT_EQ(time_text(time_in("1.2345678901234567890e-7")), "1.234567890123456789e-07");
  EXPECT_EQ(time_text(time_in("1.2345678901234567891e300")), "1.2345678901234567891e+300");
  EXPECT_EQ(time_in("1.2345678901234567891e-330"), Time(0.0));
  EXPECT_FALSE(parse_time("1.2345678901234567891e309"));
  EXPECT_FALSE(parse_time("1.23456789012345678.9"));
  EXPECT_FALSE(parse_time("1.234567890123456789e"));
}

TEST(DecimalTimes, of_17_digits_at_most_are_doubles_until_more_are_needed) {
  const Time time = time_in("1403637576.2525243");
  EXPECT_FALSE(has_many_digits(time));
  EXPECT_EQ(as_double(time), Time(1403637576.2525243));
  EXPECT_EQ(time_text(with_all_digits(time)), "1403637576.2525243");
  EXPECT_EQ(with_all_digits(Time(0.1)), nearest_time(Rational(1, 10), 1));
  EXPECT_NE(with_all_digits(Time(0.1)), Time(0.1));
  EXPECT_EQ(with_all_digits(Time(0.5)), Time(0.5));
  EXPECT_EQ(as_double(time_in("1700000000000000001")), time_in("1700000000000000001"));
}

TEST(DecimalTimes, that_are_shortest_decimals_of_doubles_are_these_doubles) {
  EXPECT_EQ(time_in("2.000800825531961"), Time(2.000800825531961));
  EXPECT_EQ(time_in("-0.30000000000000004"), Time(-0.30000000000000004));
  EXPECT_NE(time_in("0.30000000000000003"), Time(0.30000000000000003)) << "the shortest decimal ends in 4";
  std::mt19937_64 random(21);
  for (int i = 0; i < 30'000; ++i) {
    const double value = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 200) - 150);
    const std::string text = time_text(Time(value));
    ASSERT_EQ(time_in(text), Time(value)) << text;
  }
}

TEST(DecimalTimes, that_are_doubles_with_more_than_17_digits_keep_them) {
  for (const std::string text : {"1.00000095367431640625", "9.31322574615478515625e-10", "-4.00000095367431640625"}) {
    const Time time = time_in(text);
    EXPECT_EQ(time_text(time), text);
    EXPECT_EQ(exact_time(time), parse_rational(text)) << text;
    EXPECT_TRUE(has_many_digits(time)) << text;
    EXPECT_TRUE(is_earlier(time, Time(time.hi)) || is_earlier(Time(time.hi), time)) << text;
  }
  EXPECT_EQ(time_text(nearest_time(Rational(1) + Rational(1, 1 << 20), 3)), "1.00000095367431640625");
}

TEST(DecimalTimes, are_ordered_as_decimals_whether_short_or_long) {
  const Time before = time_in("1403637576.199999999"), middle(1403637576.2), after = time_in("1403637576.200000001");
  EXPECT_TRUE(is_earlier(before, middle));
  EXPECT_TRUE(is_earlier(middle, after));
  EXPECT_FALSE(is_earlier(after, middle));
  EXPECT_FALSE(is_earlier(middle, middle));
  EXPECT_FALSE(is_earlier(middle, with_all_digits(middle)));
}

TEST(DecimalTimes, that_do_not_end_have_the_decimals_that_are_asked_for) {
  EXPECT_EQ(time_text(nearest_time(Rational(4'000'000'001, 3), 9)), "1333333333.666666667");
  EXPECT_EQ(time_text(nearest_time(Rational(-4'000'000'001, 3), 9)), "-1333333333.666666667");
  EXPECT_EQ(time_text(nearest_time(Rational(1, 1024), 3)), "0.0009765625");
  EXPECT_EQ(time_text(rounded_to(Rational(1, 1024), 3)), "0.001");
  EXPECT_EQ(nearest_time(Rational(1, 3), 0), Time(1.0 / 3));
}

TEST(DecimalTimes, have_exact_differences) {
  std::mt19937_64 random(20261127);
  int found = 0;
  const auto random_time = [&] {
    const int digits = 1 + static_cast<int>(random() % 22), before = static_cast<int>(random() % 24) - 4;
    if (random() % 4 == 0)
      return Time(std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 90) - 80));
    return time_in((random() % 4 == 0 ? "-" : "") + random_decimal(random, digits, std::min(before, digits)));
  };
  for (int i = 0; i < 20'000; ++i) {
    const Time time = random_time(), zero = random() % 16 == 0 ? time : random_time();
    const auto a = exact_decimal_of(time), b = exact_decimal_of(zero);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->value(), exact_time(time)) << time_text(time);
    const auto difference = exact_difference(*a, *b);
    if (!difference) continue;
    ++found;
    const Rational wanted = exact_time(time) - exact_time(zero);
    EXPECT_EQ(exact_time(*difference), wanted) << time_text(time) << " - " << time_text(zero);
  }
  EXPECT_GT(found, 10'000);
  EXPECT_FALSE(exact_difference({1, 20}, {1, -20}));
  EXPECT_FALSE(exact_decimal_of(Time(0x1p100)));
}

TEST(DecimalTimes, are_rounded_half_to_even_as_decimals) {
  const auto text = [](const std::string& time, Notation::Kind kind, int count) {
    std::string out(400, '\0');
    const Notation notation{kind, count};
    return std::string(out.data(), write_time(time_in(time), notation, out.data()));
  };
  using enum Notation::Kind;
  EXPECT_EQ(text("1403637576.25252426850", fixed, 9), "1403637576.252524268");
  EXPECT_EQ(text("1403637576.25252426950", fixed, 9), "1403637576.252524270");
  EXPECT_EQ(text("1403637576.252524268", fixed, 12), "1403637576.252524268000");
  EXPECT_EQ(text("0.00049999999999999999999", fixed, 3), "0.000");
  EXPECT_EQ(text("999999999.9999999999", fixed, 3), "1000000000.000");
  EXPECT_EQ(text("1403637576.252524268", digits, 17), "1403637576.2525243");
  EXPECT_EQ(text("1403637576.252524268", digits, 4), "1.404e+09");
  EXPECT_EQ(text("0.00001234567890123456789", digits, 3), "1.23e-05");
  EXPECT_EQ(text("1403637576.252524268", hex, 0), "1403637576.252524268");
}

}  // namespace
}  // namespace tcb
