// Invalid numbers: the error of each kind of cell that is not a number.
#include "read/csv/invalid_number.hpp"

#include <gtest/gtest.h>

#include "read/csv/errors.hpp"

namespace tcb {
namespace {

TEST(InvalidNumber, has_the_error_with_its_remedy) {
  const auto why = [](std::string_view cell, char decimal) { return why_not_number("x", cell, {decimal}).message(); };
  const auto expect = [&](std::string_view cell, char decimal, Error (*fault)(std::string_view, std::string_view)) {
    EXPECT_EQ(why(cell, decimal), fault("x", cell).message());
  };
  expect("0,5", '.', number_with_decimal_comma);
  expect("0,500", '.', number_with_decimal_comma);
  expect("1,234", '.', number_with_thousands);
  expect("1234,567.8", '.', cell_is_not_a_number);
  expect("1.5", ',', number_with_decimal_point);
  expect("1,5e999", ',', number_beyond_doubles);
  expect("1 2", '.', several_numbers_in_cell);
  const auto expect_marks = [&](std::string_view cell, char of_input, char decimal, char thousands) {
    EXPECT_EQ(why(cell, of_input), number_with_marks("x", cell, decimal, thousands).message());
  };
  expect_marks("-1,234,567.8", '.', 0, ',');
  expect_marks("1.234,5", '.', ',', '.');
  expect_marks("1.234,5", ',', 0, '.');
  expect_marks("1 234", '.', 0, ' ');
  expect_marks("1'234,5", '.', ',', '\'');
  expect("0x1F", '.', cell_is_not_a_number);
}

}  // namespace
}  // namespace tcb
