// Places: the segments of rows in any order, from either side of a key.
#include "sample/places.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "sample/kept_curve_of.hpp"
#include "sample/rows.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb {
namespace {

/// Straight segments between keys at t = 0, 1, 2, 4 with a hold from 1 to 2.
std::shared_ptr<const KeptCurve> curve() {
  spline::Keys<double> keys{1, {0, 1, 2, 4}, {0, 3, 3, 7}, {}, {.tension = 1}, {}};
  return std::make_shared<const KeptCurve>(kept_curve_of(*spline::Curve<double>::build(keys)));
}

TEST(FindRows, neighbouring_rows_on_a_segment_are_located_together) {
  const auto block = find_rows(curve(), {.places = {0.25, 0.5, 3, 3.5, 0.75}}, false, spline::Side::right).blocks();
  ASSERT_TRUE(block);
  ASSERT_EQ(block->parts.size(), 3U);
  EXPECT_EQ(block->parts[0].last, 2U);
  EXPECT_EQ(block->parts[1].segment.number, 2U);
  EXPECT_EQ(block->parts[2].first, 4U);
}

TEST(FindRows, a_row_at_a_key_is_on_the_side_that_was_asked_for) {
  const auto number = [](double place, bool by_length, spline::Side side) {
    return find_rows(curve(), {.places = {place}}, by_length, side).blocks()->parts[0].segment.number;
  };
  EXPECT_EQ(number(1, false, spline::Side::left), 0U);
  EXPECT_EQ(number(1, false, spline::Side::right), 1U);
  constexpr double start_of_hold = 3;
  EXPECT_EQ(number(start_of_hold, true, spline::Side::left), 0U);
  EXPECT_EQ(number(start_of_hold, true, spline::Side::right), 1U);
}

}  // namespace
}  // namespace tcb
