// Numbers: every double and every whole time comes back from its text, and other text is refused.
#include "numbers/parse_number.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <random>

#include "numbers/doubles.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

__extension__ using Int128 = __int128;

constexpr auto largest_whole = std::numeric_limits<std::int64_t>::max();
constexpr auto smallest_whole = std::numeric_limits<std::int64_t>::min();

std::string printed(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string printed_time(const Time& time) {
  std::string text;
  append_time(text, time);
  return text;
}

Int128 exact(const Time& time) { return static_cast<Int128>(time.hi) + static_cast<Int128>(time.lo); }

std::string digits_17(double value) {
  std::array<char, 64> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 16).ptr};
}

TEST(Numbers, every_double_reads_back_from_its_text_bit_for_bit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    std::array<char, 32> text{};
    const std::string shortest(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
    ASSERT_EQ(printed(value), shortest);
    for (const std::string& form : {shortest, digits_17(value)}) {
      const auto back = parse_number(form);
      ASSERT_TRUE(back) << form;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << form;
    }
  }
}

TEST(Numbers, whole_times_keep_all_their_digits) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100'000; ++i) {
    const auto value = static_cast<std::int64_t>(random()) >> (random() % 64);
    const auto time = parse_time(std::to_string(value));
    ASSERT_TRUE(time);
    ASSERT_EQ(exact(*time), value);
    ASSERT_EQ(time->hi, static_cast<double>(value)) << "the first part is the nearest double";
    ASSERT_EQ(exact(whole_time(value)), value);
    ASSERT_EQ(printed_time(*time), std::to_string(value));
  }
}

TEST(Numbers, whole_times_at_the_limits_of_64_bits_are_read_exactly) {
  for (const std::int64_t value : {largest_whole, largest_whole - 1, smallest_whole, smallest_whole + 1}) {
    EXPECT_EQ(exact(*parse_time(std::to_string(value))), value);
    EXPECT_EQ(exact(whole_time(value)), value);
  }
}

TEST(Numbers, whole_times_just_below_2_to_63_are_printed_with_all_their_digits) {
  for (const std::int64_t below : {0, 1, 255, 511, 512, 513, 1023, 1024}) {
    const std::int64_t value = largest_whole - below;
    EXPECT_EQ(printed_time(whole_time(value)), std::to_string(value));
    EXPECT_EQ(printed_time(whole_time(-value)), std::to_string(-value));
  }
}

TEST(Numbers, a_time_beyond_2_to_53_is_exact_where_a_number_is_rounded_to_even) {
  EXPECT_EQ(*parse_number("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(*parse_number("9007199254740993.0000000001"), 9007199254740994.0);
  EXPECT_EQ(printed_time(*parse_time("9007199254740993")), "9007199254740993");
  EXPECT_EQ(printed_time(*parse_time("+1403636579763555584")), "1403636579763555584");
  EXPECT_EQ(printed_time(*parse_time("0009007199254740993")), "9007199254740993");
}

TEST(Numbers, a_time_that_is_not_whole_is_the_nearest_double) {
  EXPECT_EQ(*parse_time("0.1"), Time(0.1));
  EXPECT_EQ(parse_time("-1234567890.12345678")->hi, -1234567890.12345678);
  EXPECT_EQ(parse_time("-1234567890.12345")->lo, 0);
  EXPECT_EQ(printed_time(Time(0.1)), "0.1");
  EXPECT_EQ(printed_time(Time(-2.5)), "-2.5");
  EXPECT_EQ(printed_time(Time(1e300)), "1e+300");
  EXPECT_EQ(printed_time(Time(1e6)), "1000000") << "a whole time has all its digits, where a number is 1e+06";
  EXPECT_EQ(printed(1e6), "1e+06");
}

TEST(Numbers, sign_point_and_exponent_are_optional) {
  const std::pair<const char*, double> spellings[] = {
      {"+1", 1},     {".5", 0.5},   {"5.", 5},  {"-.25", -0.25}, {"1E3", 1000},
      {"2e-1", 0.2}, {"+.5e+1", 5}, {"007", 7}, {"00.10", 0.1},  {"1e0000000001", 10}};
  for (const auto& [text, value] : spellings) {
    EXPECT_EQ(parse_number(text), value) << text;
    EXPECT_EQ(parse_time(text), Time(value)) << text;
  }
  EXPECT_TRUE(std::signbit(*parse_number("-0")));
}

TEST(Numbers, hexadecimal_as_printf_writes_it) {
  RandomDoubles random(11);
  std::array<char, 64> text;
  for (int i = 0; i < 20'000; ++i) {
    for (const double value : {random.any(), random.near(), -random.short_decimal(), 0.0, -0.0}) {
      std::snprintf(text.data(), text.size(), "%a", value);
      const auto read = parse_number(text.data());
      ASSERT_TRUE(read) << text.data();
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(value)) << text.data();
    }
  }
  EXPECT_EQ(parse_number("+0x1.8p1"), 3);
}

TEST(Numbers, other_text_is_refused) {
  for (const char* text : {"",
                           " ",
                           "+",
                           "-",
                           ".",
                           "+-1",
                           "++1",
                           "-+1",
                           "--1",
                           "0x10",
                           "0x1",
                           "0x",
                           "0xp3",
                           "0x1p",
                           "0x-1p3",
                           "0x1p+-3",
                           "0x0p+-3",
                           "0x1p3 ",
                           "0x1p9999",
                           "0X10",
                           "inf",
                           "+inf",
                           "-inf",
                           "Infinity",
                           "nan",
                           "NaN",
                           "-nan",
                           "nan(1)",
                           "1e999",
                           "-1e999",
                           "1e9223372036854775807",
                           "4e09223372036854775807",
                           "1,5",
                           " 1",
                           "1 ",
                           "1e",
                           "1e+",
                           "e5",
                           "1_0",
                           "1'000",
                           "1f",
                           "1.2.3",
                           "1/2",
                           "o.5",
                           "١",
                           "12345678901234567x",
                           "123456789012345678 "}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
    EXPECT_EQ(parse_time(text), std::nullopt) << text;
  }
  EXPECT_EQ(parse_number(std::string_view("1\0", 2)), std::nullopt);
}

TEST(Numbers, the_largest_double_is_read_and_the_next_decimal_is_not) {
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("1.7976931348623159e308"), std::nullopt);
}

TEST(Numbers, the_double_nearest_to_a_tiny_number_is_zero) {
  EXPECT_EQ(parse_number("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_number("2e-324"), 0.0);
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  EXPECT_EQ(parse_time("-1e-400"), Time(-0.0));
}

TEST(Numbers, missing_is_empty_na_nan_or_null_in_any_case) {
  for (const char* text : {"", "NA", "na", "nan", "NaN", "null", "NULL"}) {
    EXPECT_TRUE(is_missing(text)) << text;
    EXPECT_TRUE(looks_numeric(text)) << text;
  }
  for (const char* text : {"0", "n/a", "none", "nanx", "-", " "}) EXPECT_FALSE(is_missing(text)) << text;
}

TEST(Numbers, infinities_and_numbers_too_large_belong_in_a_column_of_numbers) {
  for (const char* text : {"1", "+1", "-.5e3", "inf", "-Infinity", "+inf", "1e999", "-1e999"}) {
    EXPECT_TRUE(looks_numeric(text)) << text;
  }
  for (const char* text : {"x", "1x", "0x10", "1e999x", "infinite", "+", "+-1", "1 2"}) {
    EXPECT_FALSE(looks_numeric(text)) << text;
  }
}

/// The text is read as std::from_chars reads it.
void check_reading(std::string_view text) {
  double expected = 0;
  const auto error = std::from_chars(text.data(), text.data() + text.size(), expected).ec;
  const auto value = parse_number(text);
  if (error == std::errc()) {
    ASSERT_TRUE(value) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(expected)) << text;
  } else {
    ASSERT_TRUE(!value || *value == 0) << text;
  }
}

/// The value with `digits` digits in scientific notation, or as many decimals in fixed notation.
std::string_view with_digits(std::array<char, 1200>& text, double value, std::chars_format notation, int digits) {
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, notation, digits).ptr};
}

/// What lies half between a double and the next one, cut to as many digits (where long double has the bits for it).
std::string_view halfway(std::array<char, 1200>& text, double value, int digits) {
  const long double next = std::nextafter(value, 0);
  const long double middle = (static_cast<long double>(value) + next) / 2;
  const int length = std::snprintf(text.data(), text.size(), "%.*Le", digits - 1, middle);
  return {text.data(), static_cast<std::size_t>(length)};
}

void check_readings(double value) {
  std::array<char, 1200> text;
  for (const int digits : {1, 7, 15, 16, 17, 18, 19, 20, 25, 40}) {
    check_reading(with_digits(text, value, std::chars_format::scientific, digits - 1));
  }
  if (std::abs(value) < 1e30) {
    for (const int digits : {0, 1, 3, 6, 8, 9, 15, 16, 17, 20, 30}) {
      check_reading(with_digits(text, value, std::chars_format::fixed, digits));
    }
  }
  for (const int digits : {17, 18, 19, 20, 21, 60, 800}) check_reading(halfway(text, value, digits));
}

TEST(Numbers, are_read_as_from_chars_reads_them) {
  int i = 0;
  for_all_edges([&](double value) {
    if (++i % 8 == 0) check_readings(value);
  });
  for_hard_ones(check_readings);
  RandomDoubles random(7);
  for (int n = 0; n < 5'000; ++n) {
    check_readings(random.any());
    check_readings(random.near());
    check_readings(random.unit());
    check_readings(random.short_decimal());
  }
}

TEST(Numbers, a_million_of_17_digits_are_read_as_from_chars_reads_them) {
  RandomDoubles random(8);
  std::array<char, 1200> text;
  for (int n = 0; n < 250'000; ++n) {
    check_reading(with_digits(text, random.any(), std::chars_format::scientific, 16));
    check_reading(with_digits(text, random.near(), std::chars_format::scientific, 18));
    check_reading(with_digits(text, random.unit(), std::chars_format::fixed, 17));
    check_reading(fmt::format("{}e{}", random.bits(), static_cast<int>(random.bits() % 700) - 350));
  }
}

TEST(Numbers, zeros_in_front_and_at_the_end_do_not_count) {
  for (const std::size_t count : {1U, 7U, 30U, 400U, 2000U}) {
    const std::string zeros(count, '0');
    for (const char* form : {"{0}", "-{0}", "{0}.{0}", "0.{0}123456789012345678", "{0}1234567890123456789", "1{0}",
                             "{0}12345678901234567890", "0.{0}{0}1e60", "1{0}e-30", "0.{0}7e2001", "{0}e9999"}) {
      check_reading(fmt::format(fmt::runtime(form), zeros));
    }
  }
}

TEST(Numbers, no_character_beyond_the_text_is_read) {
  for (const char* number : {"1", "0.5", "12345678", "1.2345678", "0.1234567890123456789", "1e5", "12.5e-10"}) {
    const std::string_view text(number);
    for (std::size_t size = 1; size <= text.size(); ++size) {
      const std::vector<char> alone(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_EQ(parse_number({alone.data(), size}), parse_number(std::string(text.substr(0, size)))) << number << size;
    }
  }
}

// Some minutes: --gtest_also_run_disabled_tests --gtest_filter='Numbers.DISABLED*'
template <class Next>
void check_a_hundred_million(const Next& next) {
  RandomDoubles random(10);
  std::array<char, 1200> text;
  for (int i = 0; i < 100'000'000; ++i) {
    const std::string_view number = next(text, random);
    double expected = 0;
    const auto error = std::from_chars(number.data(), number.data() + number.size(), expected).ec;
    const auto value = parse_number(number);
    const bool same = error == std::errc() ? value == expected : !value || *value == 0;
    if (!same) FAIL() << number;
  }
}

TEST(Numbers, DISABLED_a_hundred_million_of_17_digits) {
  check_a_hundred_million([](auto& text, RandomDoubles& random) {
    return with_digits(text, random.any(), std::chars_format::scientific, 16);
  });
}

TEST(Numbers, DISABLED_a_hundred_million_of_19_digits_at_near_exponents) {
  check_a_hundred_million([](auto& text, RandomDoubles& random) {
    return with_digits(text, random.near(), std::chars_format::scientific, 18);
  });
}

TEST(Numbers, DISABLED_a_hundred_million_of_21_digits) {
  check_a_hundred_million([](auto& text, RandomDoubles& random) {
    return with_digits(text, random.any(), std::chars_format::scientific, 20);
  });
}

TEST(Numbers, DISABLED_a_hundred_million_random_digits) {
  check_a_hundred_million([](auto& text, RandomDoubles& random) {
    const auto digits = static_cast<unsigned long long>(random.bits() >> (random.bits() % 40));
    const int exponent = static_cast<int>(random.bits() % 660) - 340;
    const int length = std::snprintf(text.data(), text.size(), "%llue%d", digits, exponent);
    return std::string_view(text.data(), static_cast<std::size_t>(length));
  });
}

TEST(Numbers, DISABLED_a_hundred_million_halfway) {
  check_a_hundred_million([](auto& text, RandomDoubles& random) {
    return halfway(text, random.any(), static_cast<int>(17 + random.bits() % 5));
  });
}

TEST(Numbers, no_locale_changes_the_point) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  EXPECT_EQ(printed(1234.5), "1234.5");
  EXPECT_EQ(parse_number("1234.5"), 1234.5);
  std::locale::global(before);
}

TEST(Decimals, marks_divide_groups_of_three_digits) {
  const auto number = [](std::string_view text, char decimal, char thousands) {
    return Decimals({decimal, thousands}).number(text);
  };
  EXPECT_EQ(number("1.234,5", ',', '.'), 1234.5);
  EXPECT_EQ(number("-1.000.000", ',', '.'), -1e6);
  EXPECT_EQ(number("+12,345.5e2", '.', ','), 1234550);
  EXPECT_EQ(number("1'234", '.', '\''), 1234);
  EXPECT_EQ(number("1\u2019234", '.', '\''), 1234);
  EXPECT_EQ(number("1 234,5", ',', ' '), 1234.5);
  EXPECT_EQ(number("1\u00A0234\u202F567\u2009890", '.', ' '), 1234567890);
  EXPECT_EQ(number("1234,5", ',', '.'), 1234.5);
  for (const char* text : {"1.23", "12.34,5", "1234.567", "0.125", "1.234.", ".123", "1..234", "1,234.5", "-.123"}) {
    EXPECT_FALSE(number(text, ',', '.')) << text;
  }
}

}  // namespace
}  // namespace tcb
