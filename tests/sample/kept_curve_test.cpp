// Kept curve: segments have their place on the curve.
#include "sample/kept_curve.hpp"

#include <gtest/gtest.h>

#include "sample/kept_curve_of.hpp"

namespace tcb {
namespace {

TEST(KeptCurve, segments_have_their_place_on_the_curve) {
  const spline::Keys<double> keys{1, {0, 1, 2, 4}, {0, 3, 3, 7}, {}, {.tension = 1}, {}};
  const KeptCurve curve = kept_curve_of(*spline::Curve<double>::build(keys));
  EXPECT_EQ(curve.size(), 3U);
  const CurveSegment segment = curve.segment(2);
  EXPECT_EQ(segment.start.hi, 2);
  EXPECT_EQ(segment.s_start.hi, 3);
  EXPECT_EQ(segment.s_end.hi, 7);
  EXPECT_TRUE(segment.last);
  EXPECT_EQ(segment.end_key, 3U);
  EXPECT_EQ(segment.cycle[0], 7);
}

TEST(KeptCurve, a_closed_curve_ends_at_its_first_key) {
  const spline::Keys<double> keys{1, {0, 1, 2}, {0, 3, 5}, {}, {}, {}};
  const KeptCurve curve = kept_curve_of(*spline::Curve<double>::build_closed(keys, {}, spline::DoubleDouble(4.0)));
  EXPECT_EQ(curve.size(), 3U);
  EXPECT_EQ(curve.segment(1).end_key, 2U);
  EXPECT_EQ(curve.segment(2).end_key, 0U);
  EXPECT_EQ(curve.segment(2).cycle[0], 0);
}

}  // namespace
}  // namespace tcb
