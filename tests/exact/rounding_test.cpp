// Rounding once: texts of exact numbers, roots, and what a radius leaves open.
#include "exact/rounding.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <random>

#include "numbers/large_rational.hpp"
#include "sample/fields.hpp"

namespace tcb {
namespace {

using Kind = Notation::Kind;

std::string printed(const char* format, int count, double value) {
  std::array<char, 700> text{};
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, count, value))};
}

TEST(Rounding, texts_are_those_of_printf) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const double any = std::bit_cast<double>(random());
    const double near = static_cast<double>(static_cast<std::int64_t>(random() % 2000000) - 1000000) / 1024;
    for (const double value : {any, near, 0.0, 9.5, 0.00095, 99999.5, -0.5}) {
      if (!std::isfinite(value)) continue;
      const int count = 1 + i % 30;
      if (value != 0) {
        EXPECT_EQ(digits_text(Rational(value), count), printed("%.*g", count, value));
      }
      EXPECT_EQ(fixed_text(Rational(value), count), printed("%.*f", count, value));
      EXPECT_EQ(fixed_text(Rational(value), 0), value < 0 || !std::signbit(value) ? printed("%.*f", 0, value) : "0");
    }
  }
}

TEST(Rounding, a_root_is_rounded_once) {
  const Rounding nearest({}, CellKind::real);
  EXPECT_EQ(nearest.exactly({2, true}).cell.hi, std::sqrt(2.0));
  EXPECT_EQ(nearest.exactly({-2, true}).cell.hi, -std::sqrt(2.0));
  EXPECT_EQ(nearest.exactly({Rational(9, 4), true}).cell.hi, 1.5);
  EXPECT_EQ(nearest.exactly({0, true}).cell.hi, 0);
  // The root of (1 + 2^-53)^2 is a tie, which goes to the even one of its neighbours; a little more goes up.
  const Rational tie = 1 + ratio(1, Integer(1) << 53);
  EXPECT_EQ(nearest.exactly({tie * tie, true}).cell.hi, 1);
  EXPECT_EQ(nearest.exactly({tie * tie + ratio(1, Integer(1) << 900), true}).cell.hi, 1 + 0x1p-52);
  const Rounding digits({Kind::digits, 50}, CellKind::real);
  EXPECT_EQ(digits.exactly({2, true}).text, "1.4142135623730950488016887242096980785696718753769");
}

TEST(Rounding, a_radius_leaves_a_choice_or_none) {
  const Rounding nearest({}, CellKind::real);
  const Rational third(1, 3), tiny = ratio(1, Integer(1) << 300), tie = 1 + ratio(1, Integer(1) << 53);
  EXPECT_EQ(nearest.within(Known{third, tiny})->cell.hi, 1.0 / 3);
  EXPECT_FALSE(nearest.within(Known{tie, tiny}).has_value());
  EXPECT_FALSE(nearest.within(Known{0, ratio(1, Integer(1) << 1500)}).has_value()) << "nor its sign";
}

TEST(Rounding, a_number_that_is_not_told_from_a_simple_one_is_that) {
  const Rounding nearest({}, CellKind::real);
  const Rational tiny = ratio(1, Integer(1) << 300), tie = 1 + ratio(1, Integer(1) << 53);
  EXPECT_EQ(nearest.snapped({tie + tiny / 2, tiny})->cell.hi, 1);
  EXPECT_EQ(nearest.snapped({-3 * tie + tiny / 2, tiny})->cell.hi, -3 - 0x1p-51);
  EXPECT_EQ(nearest.snapped({-tiny, tiny})->cell.hi, 0);
  EXPECT_FALSE(nearest.snapped({Rational(1, 3) + tiny, Rational(0x1p-40)}).has_value()) << "one in so many is as near";
  EXPECT_EQ(simple_fraction({Rational(1, 10) * power_of_two(-900), power_of_two(-1100)}),
            Rational(1, 10) * power_of_two(-900));
}

TEST(Rounding, a_bound_decides_where_all_numbers_within_it_are_printed_alike) {
  const Rounding nearest({}, CellKind::real), digits({Kind::digits, 3}, CellKind::real);
  const double half = 0x1p-53;  // of the distance from 1 to the next double
  EXPECT_EQ(nearest.within(Bounded({1, 0.9 * half}, 0.05 * half))->cell.hi, 1);
  EXPECT_FALSE(nearest.within(Bounded({1, 0.9 * half}, 0.2 * half)).has_value());
  EXPECT_FALSE(nearest.within(Bounded({1, half}, 1e-30)).has_value());
  EXPECT_FALSE(nearest.within(Bounded({1, -half / 2}, 1e-30)).has_value()) << "the doubles below 1 are nearer";
  EXPECT_FALSE(nearest.within(Bounded({0, 0}, 1e-30)).has_value());
  EXPECT_EQ(nearest.within(Bounded(0.0))->cell.hi, 0);
  EXPECT_EQ(digits.within(Bounded({1234.5, 0}, 0.1))->text, "1.23e+03");
  EXPECT_FALSE(digits.within(Bounded({1235, 0}, 0.1)).has_value());
}

TEST(Rounding, the_simplest_number_between_has_the_least_denominator) {
  EXPECT_EQ(simplest_between(Rational(3141, 1000), Rational(3143, 1000)), Rational(22, 7));
  EXPECT_EQ(simplest_between(Rational(1, 3), Rational(1, 3)), Rational(1, 3));
  EXPECT_EQ(simplest_between(Rational(2, 5), Rational(7, 2)), 1);
}

TEST(Rounding, a_time_beyond_2_to_53_is_the_nearest_whole_number) {
  const Rational time = Rational(1403715524907143169) + Rational(1, 3);
  EXPECT_EQ(Cell(Rounding({}, CellKind::time).exactly({time}).cell).lo, 1);
  EXPECT_EQ(Rounding({Kind::digits, 5}, CellKind::time).exactly({time}).text, "1403715524907143169");
}

TEST(FieldTable, every_field_but_the_bound_on_an_error_has_an_exact_value) {
  for (const Field& field : fields()) EXPECT_EQ(field.is_exact, field.name != "arc_error") << field.name;
}

}  // namespace
}  // namespace tcb
