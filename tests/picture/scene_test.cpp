// Scene: counts, and the extent of curves between their keys.
#include "picture/scene.hpp"

#include <gtest/gtest.h>

#include "error.hpp"
#include "picture/scene_of.hpp"

namespace tcb {
namespace {

TEST(Scene, the_extent_has_the_extremes_between_keys) {
  Scene scene = small_scene();
  scene.channels = {"x"};
  scene.path.reset();
  // Through 0, 1, 1, 0 at equal times the middle segment is 1 + u (1 - u) / 2 where the tangents are 1/2 and -1/2.
  scene.curves = {scene_curve(keys_of({0, 1, 2, 3}, {0, 1, 1, 0}))};
  const SceneExtent extent = extent_of(scene);
  EXPECT_EQ(extent.time.high.hi, 3);
  EXPECT_EQ(extent.channels[0].low.hi, 0);
  EXPECT_DOUBLE_EQ(extent.channels[0].high.hi, 1.125);
  EXPECT_EQ(extent.segments, 3U);
}

TEST(Scene, samples_outside_the_curve_are_in_the_extent) {
  Scene scene = small_scene();
  scene.curves[0].samples = {{Time(6), {9, 0, 0}, {0, 0, 0}}};
  scene.curves[0].rows = 1;
  EXPECT_TRUE(scene.has_samples());
  const SceneExtent extent = extent_of(scene);
  EXPECT_EQ(extent.time.high.hi, 6);
  EXPECT_EQ(extent.channels[0].high.hi, 9);
  EXPECT_EQ(extent.path[0].high.hi, 9);
}

TEST(Scene, keys_and_rows_are_counted) {
  Scene scene = small_scene();
  scene.curves.push_back(scene.curves[0]);
  scene.curves[1].rows = 7;
  EXPECT_EQ(scene.keys(), 8U);
  EXPECT_EQ(scene.rows(), 7U);
  EXPECT_FALSE(scene.has_samples());
}

TEST(Scene, numbers_too_far_apart_are_refused) {
  Scene scene = small_scene();
  scene.curves[0].samples = {{Time(1), {0, 0, 1.5e308}, {0, 0, 0}}, {Time(1), {0, 0, -1.5e308}, {0, 0, 0}}};
  EXPECT_THROW(extent_of(scene), Error);
}

}  // namespace
}  // namespace tcb
