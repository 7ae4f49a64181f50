// Refusals: texts shown so that they can be read, and the remedy that fits.
#include "text/refusal.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

using testing::EndsWith;

TEST(NoNumber, names_the_remedy_that_fits) {
  EXPECT_THAT(no_number("", '.'), EndsWith("give --missing skip-row, skip-cell or break"));
  EXPECT_THAT(no_number("0,5", '.'), EndsWith("give --decimal , if this is a decimal comma"));
  EXPECT_THAT(no_number("1.234,5", '.'), EndsWith("correct the cell")) << "that is two marks";
  EXPECT_THAT(no_number("1.5", ','), EndsWith("correct the cell, or take --decimal out"));
  EXPECT_THAT(no_number("1,5e999", ','), EndsWith("expected less than 1.8e308 in size; correct the cell"));
  EXPECT_THAT(no_number("1 2", '.'), EndsWith("give the delimiter with -d"));
  EXPECT_THAT(no_number("0x1F", '.'), EndsWith("expected a decimal such as -1.5 or 2e3; correct the cell"));
}

}  // namespace
}  // namespace tcb
