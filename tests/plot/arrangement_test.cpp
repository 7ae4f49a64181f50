// Arrangement: views within the picture, side by side and below each other, and equal scales of the path.
#include "plot/arrangement.hpp"

#include <gtest/gtest.h>

#include "error.hpp"
#include "plot/scene_of.hpp"

namespace tcb {
namespace {

Scene scene_of_channels(std::size_t channels) {
  Scene scene = small_scene();
  scene.channels.assign(channels, "channel");
  if (channels < 2) scene.path.reset();
  std::vector<double> positions;
  for (std::size_t i = 0; i < 3 * channels; ++i) positions.push_back(static_cast<double>(i * i % 11));
  scene.curves = {scene_curve(keys_of({0, 1, 2}, positions))};
  return scene;
}

Arrangement arrangement_of(const Scene& scene, const PictureSize& size = {}) {
  return arranged(scene, extent_of(scene), size, 30);
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

TEST(Arrangement, views_are_within_the_picture_and_do_not_overlap) {
  for (const std::size_t channels : {1U, 2U, 3U, 10U, 11U, 57U, 200U}) {
    const Arrangement arrangement = arrangement_of(scene_of_channels(channels));
    ASSERT_EQ(arrangement.views.size(), channels + (channels > 1 ? 1 : 0));
    for (std::size_t i = 0; i < arrangement.views.size(); ++i) {
      const Box& box = arrangement.views[i].box;
      EXPECT_GE(box.left, 20);
      EXPECT_GE(box.top, 60);
      EXPECT_LE(box.right(), arrangement.width - 16);
      EXPECT_LE(box.bottom(), arrangement.height - 60);
      for (std::size_t other = 0; other < i; ++other) EXPECT_FALSE(overlap(box, arrangement.views[other].box));
    }
  }
}

TEST(Arrangement, more_strips_than_can_be_read_are_refused) {
  EXPECT_NO_THROW(scene_of_channels(1000).require_few_strips());
  EXPECT_THROW(scene_of_channels(1001).require_few_strips(), Error);
  Scene chosen = scene_of_channels(1001);
  chosen.strips = {0, 7};
  EXPECT_NO_THROW(chosen.require_few_strips());
}

TEST(Arrangement, the_path_has_equal_scales) {
  for (const PictureSize& size : {PictureSize{}, PictureSize{600, 300}, PictureSize{500, 900}}) {
    const View path = arrangement_of(scene_of_channels(3), size).views[0];
    EXPECT_NEAR(path.x_scale(), path.y_scale(), 1e-9 * path.x_scale());
  }
}

TEST(Arrangement, a_given_size_is_kept_or_refused) {
  const Arrangement arrangement = arrangement_of(scene_of_channels(4), {500, 320});
  EXPECT_EQ(arrangement.width, 500);
  EXPECT_EQ(arrangement.height, 320);
  EXPECT_THROW(arrangement_of(scene_of_channels(200), {500, 320}), Error);
}

TEST(Arrangement, the_lowest_strip_of_each_column_has_the_time) {
  const Arrangement arrangement = arrangement_of(scene_of_channels(20));
  std::size_t named = 0;
  for (std::size_t i = 1; i < arrangement.frames.size(); ++i) named += arrangement.frames[i].name.empty() ? 0 : 1;
  EXPECT_EQ(named, 2U);
}

}  // namespace
}  // namespace tcb
