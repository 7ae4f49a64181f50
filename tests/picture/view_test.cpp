// Views: places of points, control points of segments, corners, and frames.
#include "picture/view.hpp"

#include <gmock/gmock.h>

#include "picture/scene_of.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

/// Time from 0 to 4 to the right, y from 0 to 2 up, 100 pixels a unit.
View graph() { return {{10, 20, 400, 200}, {}, 1, Axis({Time(0), Time(4)}, 0), Axis({Time(0), Time(2)}, 0)}; }

TEST(View, a_point_is_where_its_numbers_are_on_the_axes) {
  const std::vector<double> position{7, 1.5, 0};
  const Pixel at = graph().at(Time(1), position);
  EXPECT_DOUBLE_EQ(at.x, 110);
  EXPECT_DOUBLE_EQ(at.y, 70);
  View path = graph();
  path.right = 0;
  EXPECT_DOUBLE_EQ(path.at(Time(1), position).x, 710);
}

TEST(View, nanoseconds_since_1970_are_told_from_each_other) {
  const Time first(1731931200000000000.0);
  View view = graph();
  view.x = Axis({first, first + Time(4)}, 0);
  EXPECT_DOUBLE_EQ(view.at(first + Time(3), std::vector<double>{0, 0}).x, 310);
}

TEST(View, control_points_are_a_third_of_the_tangents_away) {
  spline::Segments<double> segments{2, {Time(1), Time(2)}, {}, {}};
  segments.cubics = {spline::cubic<double>(0, 0, {0.0}, {0.0}), spline::cubic<double>(1, 2, {0.3}, {-0.6})};
  const PixelSegment segment = graph().segment(segments, 0);
  EXPECT_TRUE(segment.is_graph);
  EXPECT_DOUBLE_EQ(segment.points[0].x, 110);
  EXPECT_DOUBLE_EQ(segment.points[1].x, 110 + 100. / 3);
  EXPECT_DOUBLE_EQ(segment.points[1].y, 120 - 10);
  EXPECT_DOUBLE_EQ(segment.points[2].y, 20 - 20);
  EXPECT_DOUBLE_EQ(segment.points[3].y, 20);
}

TEST(View, corners_are_changes_of_direction) {
  EXPECT_FALSE(is_corner({1, 1}, {3, 3.001}));
  EXPECT_TRUE(is_corner({1, 1}, {1, 0}));
  EXPECT_TRUE(is_corner({1, 0}, {-1, 0}));
}

TEST(View, frames_have_numbers_and_names) {
  Svg svg;
  View view = graph();
  view.heading = "height [m]";
  view.name = "time";
  draw_frame(svg, view);
  EXPECT_THAT(svg.text(), HasSubstr(">height [m]<"));
  EXPECT_THAT(svg.text(), HasSubstr("text-anchor=\"middle\" class=\"v\">2.0<"));
}

TEST(View, a_key_without_a_position_has_no_dot) {
  const Scene scene = small_scene();
  const View view = graph();
  CurveDrawing drawing(view, {.keys = true}, std::make_unique<ExactOutline>());
  Keys keys = scene.curves[0].keys.all();
  keys.positions[4] = std::numeric_limits<double>::quiet_NaN();
  Svg svg;
  drawing.draw(svg, scene.curves[0], keys);
  std::size_t dots = 0;
  for (std::size_t at = 0; (at = svg.text().find("<circle", at)) != std::string::npos; ++at) ++dots;
  EXPECT_EQ(dots, 3U);
}

TEST(View, a_turn_after_a_hold_is_a_corner) {
  Scene scene = small_scene();
  Keys keys = keys_of({0, 1, 2, 3}, {0, 0, 1, 1, 1, 1, 2, 0});
  keys.tcbs.assign(4, {1, 0, 0});
  scene.curves = {scene_curve(keys)};
  View view = graph();
  view.right = 0;
  CurveDrawing drawing(view, {.keys = true}, std::make_unique<ExactOutline>());
  const Source<SegmentBlock> blocks = scene.curves[0].segments();
  while (const auto block = blocks()) {
    for (std::size_t i = 0; i < block->segments.size(); ++i) drawing.add(block->segments, i);
  }
  Svg svg;
  drawing.draw(svg, scene.curves[0], keys);
  EXPECT_TRUE(drawing.drawn().corners);
}

}  // namespace
}  // namespace tcb
