// Pictures of checks: samples as a curve of their own, differences as further channels, and the worst place.
#include "check/check_picture.hpp"

#include <gmock/gmock.h>

#include "check/comparing.hpp"
#include "check/errors.hpp"

namespace tcb {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string keys = "time,x,y\n0,0,0\n1,1,2\n2,4,4\n";

std::string drawn(const Comparison& comparison) {
  const PictureOptions options;
  CheckPicture picture(options);
  const Check result = check(comparison, [&picture](const CheckedPair& pair) { picture.add(pair); });
  return picture.svg(result, result.passed() ? "check passed" : "check failed");
}

TEST(CheckPicture, the_largest_difference_is_marked_in_its_channel) {
  const Comparing comparing(keys, "time,x,y\n0,0,0\n1,1,2.5\n2,4,4\n");
  const std::string svg = drawn(comparing.comparison);
  EXPECT_THAT(svg, AllOf(HasSubstr("rows.csv against keys.csv"), HasSubstr("check failed · largest difference 0.5"),
                         HasSubstr(">y, difference<")));
  std::size_t marks = 0;
  for (std::size_t at = 0; (at = svg.find("class=\"w\"", at)) != std::string::npos; ++at) ++marks;
  EXPECT_EQ(marks, 4U);  // the path, y, its difference, and the legend
}

TEST(CheckPicture, equal_samples_have_no_mark) {
  const Comparing comparing(keys, "time,x,y\n0,0,0\n1,1,2\n2,4,4\n");
  EXPECT_THAT(drawn(comparing.comparison), AllOf(HasSubstr("check passed"), Not(HasSubstr("class=\"w\""))));
}

TEST(CheckPicture, channels_that_are_not_compared_are_not_drawn) {
  const Comparing comparing(keys, "time,y\n0,0\n2,4\n");
  EXPECT_THAT(drawn(comparing.comparison), AllOf(HasSubstr(">y<"), Not(HasSubstr(">x<"))));
}

TEST(CheckPicture, positions_are_needed) {
  const Comparing comparing(keys, "time,speed\n0,1\n2,1\n");
  EXPECT_EQ(error_of([&] { drawn(comparing.comparison); }).message(), no_position_column({"x", "y"}).message());
}

}  // namespace
}  // namespace tcb
