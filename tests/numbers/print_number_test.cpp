// Numbers as text: the same characters as std::to_chars writes, in less time.
#include "numbers/print_number.hpp"

#include <gtest/gtest.h>

#include <array>

#include "numbers/doubles.hpp"

namespace tcb {
namespace {

constexpr char untouched = '#';

using Text = std::array<char, 512>;

/// What a function wrote, after a check that it kept to its room.
template <class Write>
std::string_view written(Text& text, const Write& write) {
  std::fill(text.begin() + number_room, text.begin() + number_room + 8, untouched);
  const char* end = write(text.data());
  for (std::size_t i = number_room; i < number_room + 8; ++i) EXPECT_EQ(text[i], untouched);
  return {text.data(), end};
}

void check_shortest(double value) {
  Text ours, theirs;
  const auto text = written(ours, [&](char* out) { return write_shortest(value, out); });
  const char* end = std::to_chars(theirs.data(), theirs.data() + theirs.size(), value).ptr;
  ASSERT_EQ(text, std::string_view(theirs.data(), end));
}

template <class Write>
void check_rounded(double value, int precision, std::chars_format notation, const Write& write) {
  Text ours, theirs;
  const char* end = std::to_chars(theirs.data(), theirs.data() + theirs.size(), value, notation, precision).ptr;
  if (write(value, precision, ours.data()) == nullptr) return;
  const auto text = written(ours, [&](char* out) { return write(value, precision, out); });
  ASSERT_EQ(text, std::string_view(theirs.data(), end)) << precision;
}

void check_fixed(double value, int decimals) { check_rounded(value, decimals, std::chars_format::fixed, write_fixed); }

void check_digits(double value, int count) { check_rounded(value, count, std::chars_format::general, write_digits); }

TEST(NumberText, is_what_to_chars_writes_at_the_edges_of_all_exponents) { for_all_edges(check_shortest); }

TEST(NumberText, is_what_to_chars_writes_of_hard_ones) {
  for_hard_ones(check_shortest);
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {0.0, -0.0, infinity, -infinity, nan, -nan}) check_shortest(value);
}

TEST(NumberText, is_what_to_chars_writes_of_short_decimals) {
  for (int i = -200'000; i <= 200'000; ++i) {
    check_shortest(i);
    check_shortest(i / 1000.0);
    check_shortest(i / 24.0);
  }
}

TEST(NumberText, is_what_to_chars_writes_of_random_doubles) {
  RandomDoubles random(1);
  for (int i = 0; i < 600'000; ++i) {
    check_shortest(random.any());
    check_shortest(random.unit());
    check_shortest(random.short_decimal());
    check_shortest(random.near());
  }
}

TEST(NumberText, notation_is_the_shorter_one) {
  const std::pair<double, const char*> texts[] = {
      {0.0001, "1e-04"},     {0.00012, "0.00012"}, {0.001, "0.001"},
      {10000, "10000"},      {100000, "1e+05"},    {1200000, "1200000"},
      {12000000, "1.2e+07"}, {1e22, "1e+22"},      {1.2345678901234567e20, "123456789012345667584"},
      {-0.0, "-0"},          {5e-324, "5e-324"}};
  for (const auto& example : texts) {
    Text ours;
    EXPECT_EQ(written(ours, [&](char* out) { return write_shortest(example.first, out); }), example.second);
  }
}

TEST(NumberText, whole_numbers_of_any_size) {
  Text ours;
  const auto check = [&](std::uint64_t n) {
    ASSERT_EQ(written(ours, [&](char* out) { return write_whole(n, out); }), std::to_string(n));
  };
  for (std::uint64_t power = 1; power < UINT64_MAX / 10; power *= 10) {
    for (std::uint64_t i = 0; i < 3; ++i) {
      check(power - i);
      check(power + i);
    }
  }
  check(UINT64_MAX);
  std::mt19937_64 random(3);
  for (int i = 0; i < 100'000; ++i) check(random() >> (random() % 64));
}

TEST(NumberText, rounded_as_to_chars_rounds) {
  RandomDoubles random(4);
  const auto check = [](double value) {
    for (int n = 0; n <= 17; ++n) {
      check_fixed(value, n);
      check_digits(value, n);
    }
  };
  for (int i = 0; i < 8'000; ++i) {
    check(random.any());
    check(random.unit());
    check(random.short_decimal());
    check(random.near());
    check(i / 8.0);  // halves
    check((2 * i + 1) * 0x1p-12);
  }
}

TEST(NumberText, rounded_at_the_edges_of_all_exponents) {
  int n = 0;
  const auto check = [&](double value) {
    check_digits(value, n);
    check_fixed(value, n);
    n = (n + 5) % 18;
  };
  for_all_edges(check);
  for_hard_ones(check);
}

TEST(NumberText, what_needs_more_than_17_digits_is_not_written) {
  Text text;
  EXPECT_EQ(write_fixed(1e17, 0, text.data()), nullptr);
  EXPECT_EQ(write_fixed(1, 18, text.data()), nullptr);
  EXPECT_EQ(write_fixed(1, -1, text.data()), nullptr);
  EXPECT_EQ(write_fixed(std::numeric_limits<double>::quiet_NaN(), 1, text.data()), nullptr);
  EXPECT_EQ(write_digits(1, 18, text.data()), nullptr);
  EXPECT_EQ(write_digits(5e-324, 3, text.data()), nullptr);
  EXPECT_EQ(write_digits(std::numeric_limits<double>::infinity(), 3, text.data()), nullptr);
}

/// As it is written in a notation.
std::string in_notation(double value, const Notation& notation) {
  std::string text(longest_number_in(notation) + spare_room, '\0');
  text.resize(static_cast<std::size_t>(write_number(value, notation, text.data()) - text.data()));
  return text;
}

std::string printed(const char* format, int count, double value) {
  std::array<char, 600> text{};
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, count, value))};
}

const std::vector<double> any_doubles{0,
                                      -0.0,
                                      0.1,
                                      -0.5,
                                      2.5,
                                      1e22,
                                      123456789.125,
                                      9007199254740993.0,
                                      5e-324,
                                      1e-310,
                                      1e300,
                                      -1e-300,
                                      0.125,
                                      0.375,
                                      1e16,
                                      -2.5e-5,
                                      1.0 / 3,
                                      1e15,
                                      0.99999,
                                      -0.001,
                                      1e-5,
                                      8.5,
                                      9.5,
                                      2.2250738585072014e-308,
                                      std::numeric_limits<double>::max()};

TEST(NumberText, notations_are_those_of_printf) {
  for (const double value : any_doubles) {
    for (const int count : {0, 1, 2, 5, 9, 16, 17, 18, 30, 100}) {
      EXPECT_EQ(in_notation(value, {Notation::Kind::fixed, count}), printed("%.*f", count, value)) << value;
      if (count == 0) continue;
      EXPECT_EQ(in_notation(value, {Notation::Kind::digits, count}), printed("%.*g", count, value)) << value;
    }
  }
}

TEST(NumberText, hexadecimal_reads_back_bit_for_bit) {
  RandomDoubles random(7);
  const auto check = [](double value) {
    const std::string text = in_notation(value, {Notation::Kind::hex});
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)), std::bit_cast<std::uint64_t>(value));
    // A negative precision is none. Below the normal doubles C libraries differ.
    if (value == 0 || std::isnormal(value)) {
      EXPECT_EQ(text, printed("%.*a", -1, value));
    }
  };
  EXPECT_EQ(in_notation(0x1p-1074, {Notation::Kind::hex}), "0x0.0000000000001p-1022");
  EXPECT_EQ(in_notation(-0x3.8p-1030, {Notation::Kind::hex}), "-0x0.038p-1022");
  EXPECT_EQ(in_notation(0x1p-1022, {Notation::Kind::hex}), "0x1p-1022");
  for (const double value : any_doubles) check(value);
  for (int i = 0; i < 10'000; ++i) check(random.any());
}

TEST(NumberText, whole_times_beyond_2_to_53_stay_whole) {
  const spline::Time<double> time{1403715524907143168.0, -1};
  const auto text = [&](const spline::Time<double>& t, const Notation& notation) {
    std::string out(longest_number_in(notation) + spare_room, '\0');
    out.resize(static_cast<std::size_t>(write_time(t, notation, out.data()) - out.data()));
    return out;
  };
  for (const auto kind : {Notation::Kind::digits, Notation::Kind::fixed, Notation::Kind::hex}) {
    EXPECT_EQ(text(time, {kind, 3}), "1403715524907143167");
  }
  EXPECT_EQ(text(4, {Notation::Kind::fixed, 3}), "4.000");
  EXPECT_EQ(text(4, {Notation::Kind::hex}), "0x1p+2");
}

// Some minutes: --gtest_also_run_disabled_tests --gtest_filter='NumberText.DISABLED*'
template <class Next>
void print_a_hundred_million(const Next& next) {
  RandomDoubles random(5);
  Text ours, theirs;
  for (int i = 0; i < 100'000'000; ++i) {
    const double value = next(random);
    const std::string_view text(ours.data(), write_shortest(value, ours.data()));
    const char* end = std::to_chars(theirs.data(), theirs.data() + theirs.size(), value).ptr;
    if (text != std::string_view(theirs.data(), end)) FAIL() << text;
  }
}

TEST(NumberText, DISABLED_a_hundred_million_of_any_bits) {
  print_a_hundred_million([](RandomDoubles& random) { return random.any(); });
}

TEST(NumberText, DISABLED_a_hundred_million_between_0_and_1) {
  print_a_hundred_million([](RandomDoubles& random) { return random.unit(); });
}

TEST(NumberText, DISABLED_a_hundred_million_short_decimals) {
  print_a_hundred_million([](RandomDoubles& random) { return random.short_decimal(); });
}

TEST(NumberText, DISABLED_a_hundred_million_of_near_exponents) {
  print_a_hundred_million([](RandomDoubles& random) { return random.near(); });
}

TEST(NumberText, DISABLED_ten_million_rounded) {
  RandomDoubles random(6);
  for (int i = 0; i < 10'000'000; ++i) {
    const int n = i % 18;
    check_digits(random.any(), n);
    check_digits(random.near(), n);
    check_fixed(random.near(), n);
    check_fixed(random.short_decimal(), n);
  }
}

}  // namespace
}  // namespace tcb
