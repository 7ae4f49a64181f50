// Scene: counts, and the extent of curves between their keys.
#include "picture/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

/// A quarter turn about z for each unit of time; the first channel is 0.
Keys quarter_turns() {
  const double half = std::sqrt(0.5);
  return keys_of({0, 1, 2, 3}, {0, 0, 0, 0, 1, 0, 0, 0, half, half, 0, 0, 0, 1, 0, 0, 0, 0, half, -half});
}

TEST(Scene, rotations_have_the_angle_from_the_first_key) {
  const std::vector<RotationColumns> columns{{{{1, 2, 3, 4}}}};
  const KeyStore store(quarter_turns());
  const std::vector<FirstRotation> firsts = first_rotations(store, columns);
  const Keys with = with_angles(store, firsts).all();
  ASSERT_EQ(with.channels, 6U);
  for (const std::size_t key : {0U, 1U, 2U, 3U}) {
    EXPECT_NEAR(with.position(key)[5], 90.0 * static_cast<double>(key), 1e-12);
  }
  spline::CurveRules<double> rules = make_spec({}).rules;
  rules.rotations = {columns[0]};
  const StreamedCurve streamed{store, {}, rules, {}};
  const auto segments = [&] { return streamed.segments(); };
  const Source<SegmentBlock> blocks = with_rotations_as_cubics(segments, {{}, columns}, firsts)();
  double last = 0;
  while (const auto block = blocks()) {
    for (std::size_t i = 0; i < block->segments.size(); ++i) {
      const auto& angle = block->segments[i][5];
      EXPECT_NEAR(angle.p0, last, 1e-9);
      EXPECT_GE(angle.out, 0);
      last = angle.p1;
    }
  }
  EXPECT_NEAR(last, 270, 1e-9);
  SceneSample sample{Time(0), {0, 0, 0, 0, 1}, {0, 0, 0, 0.5, 0}};
  add_angles(sample, firsts);
  EXPECT_EQ(sample.position[5], 0);
  EXPECT_NEAR(sample.velocity[5], 57.29577951308232, 1e-12);
}

TEST(Scene, numbers_too_far_apart_are_refused) {
  Scene scene = small_scene();
  scene.curves[0].samples = {{Time(1), {0, 0, 1.5e308}, {0, 0, 0}}, {Time(1), {0, 0, -1.5e308}, {0, 0, 0}}};
  EXPECT_THROW(extent_of(scene), Error);
}

TEST(Scene, a_flat_path_is_left_out_unless_it_is_requested) {
  Scene scene = small_scene();
  ASSERT_TRUE(scene.path);
  SceneExtent extent = extent_of(scene);
  extent.channels[(*scene.path)[0]] = {Time(0), Time(100)};
  extent.channels[(*scene.path)[1]] = {Time(0), Time(4.9)};
  scene.is_path_requested = true;
  remove_flat_path(scene, extent);
  EXPECT_TRUE(scene.path);
  scene.is_path_requested = false;
  remove_flat_path(scene, extent);
  EXPECT_FALSE(scene.path);
}

TEST(Scene, the_path_has_two_channels_of_one_kind) {
  EXPECT_TRUE(path_axes({"pos_x", "pos_y"}, {}));
  EXPECT_TRUE(path_axes({"lat", "lon"}, {}));
  EXPECT_TRUE(path_axes({"a", "b"}, {}));
  EXPECT_FALSE(path_axes({"x", "temperature"}, {}));
  EXPECT_FALSE(path_axes({"pan", "tilt"}, {}));
  EXPECT_TRUE(path_axes({"pan", "tilt"}, {"pan", "tilt"}));
}

}  // namespace
}  // namespace tcb
