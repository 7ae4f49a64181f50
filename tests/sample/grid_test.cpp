// The exact grid: counts and times that floating-point loops get wrong, and its slow paths.
#include "sample/grid.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "numbers/large_rational.hpp"

namespace tcb {
namespace {

/// The double nearest to numerator / denominator, by way of 120 decimal digits.
double quotient(const Rational& value) {
  const Integer scaled = integer(numerator(value)) * pow(Integer(10), 120U) / integer(denominator(value));
  const std::string text = scaled.str() + "e-120";
  double result = 0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

TEST(Grid, counts_k_steps_as_k_plus_one_rows) {
  for (const char* text : {"0.1", "0.01", "0.001", "1/24", "1/30", "1001/30000"}) {
    const Rational step = *parse_rational(text);
    const Grid grid(0, step);
    for (int k = 1; k <= 1000; ++k) {
      const double end = quotient(step * k);
      ASSERT_EQ(grid.rows_through({end}), static_cast<std::uint64_t>(k) + 1) << text << " * " << k;
      ASSERT_EQ(grid.rows_before({end}), static_cast<std::uint64_t>(k));
      ASSERT_EQ(grid.time(static_cast<std::uint64_t>(k)).hi, end);
    }
  }
}

TEST(Grid, rounds_once_on_every_path) {
  std::mt19937_64 random(12);
  const auto draw = [&](int bits) { return Rational(random() >> (64 - bits)) + 1; };
  for (const int bits : {20, 50, 64}) {
    for (int i = 0; i < 2000; ++i) {
      Rational start(draw(bits), draw(bits)), step(draw(bits), draw(bits));
      if (i % 3 == 0) start = -start;
      if (i % 5 == 0) step /= rational(pow(Integer(10), 40U));
      const Grid grid(start, step);
      const std::uint64_t j = random() % 100'000;
      const Rational exact = start + step * j;
      const double expected = quotient(exact);
      if (std::abs(expected) >= 0x1p53) continue;
      ASSERT_EQ(grid.time(j).hi, expected);
    }
  }
}

TEST(Grid, nanoseconds_since_1970_are_exact) {
  const Grid grid(*parse_rational("1403715524907143168"), *parse_rational("5000000"));
  EXPECT_EQ(exact_time(grid.time(1997)), Rational(1403715534892143168));
  EXPECT_EQ(grid.rows_through(grid.time(1997)), 1998U);
  EXPECT_EQ(grid.rows_before(grid.time(1997)), 1997U);
}

TEST(Grid, search_agrees_with_counting_row_by_row) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 200; ++i) {
    const Rational start(static_cast<std::int64_t>(random() % 1000) - 500, 7);
    const Rational step(static_cast<std::int64_t>(random() % 50) + 1, static_cast<std::int64_t>(random() % 90) + 1);
    const Grid grid(start, step);
    for (std::uint64_t j = 0; j < 50; ++j) {
      EXPECT_EQ(grid.rows_before(grid.time(j)), j);
      EXPECT_EQ(grid.rows_through(grid.time(j)), j + 1);
    }
    EXPECT_EQ(grid.rows_through({grid.time(0).hi - 1}), 0U);
  }
}

TEST(Grid, search_agrees_for_times_next_to_rows) {
  std::mt19937_64 random(14);
  const auto power_of_ten = [&](int most) {
    return rational(pow(Integer(10), static_cast<unsigned>(random() % static_cast<unsigned>(most))));
  };
  for (int i = 0; i < 2000; ++i) {
    const auto number = [&] { return Rational(Rational(random()) + 1, Rational(random()) + 1); };
    const Rational start = (i % 2 == 0 ? 1 : -1) * number() * power_of_ten(19);
    const Grid grid(start, number() / power_of_ten(9));
    const std::uint64_t row = random() % 1'000'000;
    if (!grid.resolves(grid.time(row))) continue;
    for (int units = -6; units <= 6; ++units) {
      Time t = grid.time(row);
      if (std::abs(t.hi) >= 0x1p53) {
        t = Time::normalized(t.hi, t.lo + units);
      } else {
        for (int k = 0; k < std::abs(units); ++k) t.hi = std::nextafter(t.hi, units < 0 ? -1e300 : 1e300);
      }
      const std::uint64_t before = grid.rows_before(t), through = grid.rows_through(t);
      ASSERT_TRUE(before == 0 || grid.time(before - 1) < t) << i;
      ASSERT_GE(grid.time(before), t) << i;
      ASSERT_TRUE(through == 0 || grid.time(through - 1) <= t) << i;
      ASSERT_GT(grid.time(through), t) << i;
    }
  }
}

TEST(Grid, steps_with_few_digits_left_are_searched_exactly) {
  for (const char* step : {"1.7e-315", "2.3e-316", "4.9e-314", "3.3e-309"}) {
    const Grid grid(0, *parse_rational(step));
    for (std::uint64_t row = 1; row < 100'000; row = row * 3 + 1) {
      EXPECT_EQ(grid.rows_before(grid.time(row)), row) << step;
      EXPECT_EQ(grid.rows_through(grid.time(row)), row + 1) << step;
    }
  }
}

TEST(Grid, detects_equal_neighbouring_rows) {
  EXPECT_TRUE(Grid(0, Rational(1, 10)).resolves({1e9}));
  EXPECT_FALSE(Grid(0, *parse_rational("1e-300")).resolves({1}));
  EXPECT_FALSE(Grid(*parse_rational("1e15"), *parse_rational("1e-3")).resolves({1e15}));
}

}  // namespace
}  // namespace tcb
