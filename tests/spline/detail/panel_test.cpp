// Panels: smoothness, rules that are accurate, and pairs of panels.
#include "tcb/spline/detail/panel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "plane_segments.hpp"

namespace tcb::spline {
namespace {

TEST(Panel, is_smooth_away_from_zeros_of_the_speed) {
  const Speed<double> parabola_speed(parabola, {}), cusp_speed(cusp, {});
  EXPECT_TRUE(make_panel<double>(parabola_speed, {0, 0.0, 0.125}).is_smooth());
  EXPECT_FALSE(make_panel<double>(cusp_speed, {0, 0.0, 0.125}).is_smooth());
  EXPECT_TRUE(make_panel<double>(cusp_speed, {0, 0.25, 0.375}).is_smooth());
}

TEST(Panel, the_rule_of_a_smooth_panel_is_accurate) {
  const Speed<double> speed(parabola, {});
  const auto panel = make_panel<double>(speed, {0, 0.0, 0.25});
  ASSERT_TRUE(panel.is_smooth());
  const auto length = [](double u) { return u / 2 * std::hypot(1, 2 * u) + std::asinh(2 * u) / 4; };
  EXPECT_NEAR(panel_sum(panel, speed, -1.0, 1.0) * speed.unit(), length(0.25), 1e-16);
  EXPECT_NEAR(panel_sum(panel, speed, -1.0, 0.0) * speed.unit(), length(0.125), 1e-16);
}

TEST(Panel, two_panels_as_a_pair_have_the_bits_of_each) {
  const Speed<double> speed(cusp, {});
  const Bounds<double> a{0, 0.25, 0.5}, b{1, -0.5, -0.125};
  const auto both = make_panels(speed, a, b);
  for (const auto& [found, alone] :
       {std::pair(both[0], make_panel(speed, a)), std::pair(both[1], make_panel(speed, b))}) {
    EXPECT_EQ(found.square, alone.square);
    EXPECT_EQ(found.points, alone.points);
    EXPECT_EQ(found.middle, alone.middle);
  }
}

TEST(Panel, the_quartic_about_a_place_has_the_same_values) {
  const Quartic<double> q{1, 2, 3, 4, 5};
  const auto about = quartic_about(q, 0.5);
  const auto value = [](const Quartic<double>& of, double z) {
    return of[0] + z * (of[1] + z * (of[2] + z * (of[3] + z * of[4])));
  };
  for (const double z : {-1.0, -0.25, 0.0, 0.5}) EXPECT_EQ(value(about, z), value(q, 0.5 + z));
}

TEST(Panel, terms_are_added_in_pairs) {
  std::array<double, 5> terms{1, 2, 3, 4, 5};
  EXPECT_EQ(sum_in_pairs(terms), 15);
}

}  // namespace
}  // namespace tcb::spline
