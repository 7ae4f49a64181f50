// Invalid numbers: the error of each kind of cell that is not a number.
#include "read/csv/invalid_number.hpp"

#include <gmock/gmock.h>
namespace tcb {
namespace {

TEST(InvalidNumber, has_the_error_with_its_remedy) {
  const auto expect = [](std::string_view cell, char decimal, const std::string& words) {
    EXPECT_THAT(why_not_number("x", cell, {decimal}).message(), testing::HasSubstr(words)) << cell;
  };
  expect("0,5", '.', "give --decimal , if this is a decimal comma");
  expect("0,500", '.', "give --decimal , if this is a decimal comma");
  expect("1,234", '.', "give --thousands , if the comma divides thousands, or --decimal , if");
  expect("1234,567.8", '.', "correct the cell");
  expect("1.5", ',', "or remove --decimal");
  expect("1,5e999", ',', "is not a finite double");
  expect("1 2", '.', "expected one number in each cell");
  expect("-1,234,567.8", '.', "or give --thousands ,");
  expect("1.234,5", '.', "or give --decimal , --thousands .");
  expect("1.234,5", ',', "or give --thousands .");
  expect("1 234", '.', "or give --thousands space");
  expect("1'234,5", '.', "or give --decimal , --thousands apostrophe");
  expect("0x1F", '.', "correct the cell");
}

}  // namespace
}  // namespace tcb
