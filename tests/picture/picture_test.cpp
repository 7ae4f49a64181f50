// Picture: what a picture has, and its size in bytes.
#include "picture/picture.hpp"

#include <gmock/gmock.h>

#include "picture/scene.hpp"
#include "picture/scene_of.hpp"
#include "picture/svg.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++number;
  return number;
}

TEST(Picture, every_view_has_a_dot_for_each_key) {
  const std::string svg = picture(small_scene(), {});
  EXPECT_EQ(count(svg, "<circle"), 4U * 4U + 1U);  // and one in the legend
  EXPECT_EQ(count(svg, "<rect class=\"f\""), 4U);
  EXPECT_THAT(svg, HasSubstr("keys &lt;&amp;&gt;.csv"));
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_EQ(svg, picture(small_scene(), {}));
}

TEST(Picture, samples_are_ticks_where_they_have_room) {
  Scene scene = small_scene();
  for (int i = 0; i < 20; ++i) scene.curves[0].samples.push_back({Time(i / 5.0), {0, 0, 0}, {1, 0, 0}});
  scene.curves[0].rows = 20;
  EXPECT_EQ(count(picture(scene, {}), "class=\"s\""), 4U + 1U);
  scene.curves[0].rows = 1000000;
  scene.curves[0].samples.clear();
  EXPECT_EQ(count(picture(scene, {}), "class=\"s\""), 0U);
  EXPECT_THAT(picture(scene, {}), HasSubstr("too dense"));
}

TEST(Picture, many_keys_make_no_large_picture_which_says_that_they_are_not_shown) {
  std::vector<Time> times;
  std::vector<double> positions;
  for (int i = 0; i < 30000; ++i) {
    times.emplace_back(i);
    for (int channel = 0; channel < 3; ++channel) positions.push_back((i * (31 + channel)) % 977);
  }
  Scene scene = small_scene();
  scene.curves = {scene_curve(keys_of(times, positions))};
  EXPECT_LT(picture(scene, {}).size(), 1000000U);
  EXPECT_THAT(picture(scene, {}), HasSubstr("keys are too dense to be shown"));
  EXPECT_THAT(picture(small_scene(), {}), Not(HasSubstr("too dense")));
  scene = small_scene();
  scene.curves.assign(Scene::most_curves, scene.curves[0]);
  EXPECT_LT(picture(scene, {}).size(), 300000U);
}

TEST(Picture, a_single_key_is_a_dot) {
  Scene scene = small_scene();
  scene.curves = {scene_curve(keys_of({5}, {1, 2, 3}))};
  EXPECT_EQ(count(picture(scene, {}), "<circle"), 4U + 1U);
}

TEST(Picture, a_rotation_has_axes_along_the_path) {
  Scene scene = small_scene();
  scene.channels = {"x", "y", "qx", "qy", "qz", "qw", "angle"};
  scene.strips = {0, 1, 6};
  scene.frame = {{2, 3, 4, 5}, {0, 1}};
  // Two keys; axis x of the first one points up.
  const double half = std::sqrt(0.5);
  scene.curves = {scene_curve(keys_of({0, 1}, {0, 0, 0, 0, half, half, 0, 1, 1, 0, 0, 0, 1, 90}))};
  const std::string svg = picture(scene, {});
  const std::size_t x = svg.find("class=\"ax\"");
  ASSERT_NE(x, std::string::npos);
  const std::string path = svg.substr(svg.rfind('<', x), 200);
  EXPECT_NE(path.find("l0 -15"), std::string::npos) << path;
  EXPECT_NE(svg.find(">x axis<"), std::string::npos);
  EXPECT_NE(svg.find(">angle<"), std::string::npos);
  EXPECT_EQ(svg.find(">qx<"), std::string::npos);
}

Scene scene_of_channels(std::size_t channels) {
  Scene scene = small_scene();
  scene.channels.assign(channels, "channel");
  if (channels < 2) scene.path.reset();
  std::vector<double> positions;
  for (std::size_t i = 0; i < 3 * channels; ++i) positions.push_back(static_cast<double>(i * i % 11));
  scene.curves = {scene_curve(keys_of({0, 1, 2}, positions))};
  return scene;
}

/// The numbers of an attribute of all elements of a class.
std::vector<double> numbers_of(const std::string& svg, const std::string& element, const std::string& attribute) {
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = svg.find(element, at)) != std::string::npos; ++at) {
    numbers.push_back(std::stod(svg.substr(svg.find(" " + attribute + "=\"", at) + attribute.size() + 3, 20)));
  }
  return numbers;
}

std::vector<Box> views_of(const std::string& svg) {
  const std::string frame = "<rect class=\"f\"";
  const auto left = numbers_of(svg, frame, "x"), top = numbers_of(svg, frame, "y");
  const auto width = numbers_of(svg, frame, "width"), height = numbers_of(svg, frame, "height");
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < left.size(); ++i) boxes.push_back({left[i], top[i], width[i], height[i]});
  return boxes;
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

TEST(Picture, views_are_within_it_and_do_not_overlap) {
  for (const std::size_t channels : {1U, 2U, 3U, 10U, 11U, 57U, 200U}) {
    const std::string svg = picture(scene_of_channels(channels), {});
    const double width = numbers_of(svg, "<svg", "width")[0], height = numbers_of(svg, "<svg", "height")[0];
    const std::vector<Box> views = views_of(svg);
    ASSERT_EQ(views.size(), channels + (channels > 1 ? 1 : 0));
    for (std::size_t i = 0; i < views.size(); ++i) {
      EXPECT_GE(views[i].left, 20);
      EXPECT_GE(views[i].top, 60);
      EXPECT_LE(views[i].right(), width - 16);
      EXPECT_LE(views[i].bottom(), height - 60);
      for (std::size_t other = 0; other < i; ++other) EXPECT_FALSE(overlap(views[i], views[other]));
    }
  }
}

TEST(Picture, a_given_size_is_kept_or_refused) {
  const std::string svg = picture(scene_of_channels(4), {500, 320});
  EXPECT_EQ(numbers_of(svg, "<svg", "width")[0], 500);
  EXPECT_EQ(numbers_of(svg, "<svg", "height")[0], 320);
  EXPECT_THROW(picture(scene_of_channels(200), {500, 320}), Error);
}

TEST(Picture, more_strips_than_can_be_read_are_refused) {
  EXPECT_NO_THROW(scene_of_channels(1000).require_few_strips());
  EXPECT_THROW(scene_of_channels(1001).require_few_strips(), Error);
  Scene chosen = scene_of_channels(1001);
  chosen.strips = {0, 7};
  EXPECT_NO_THROW(chosen.require_few_strips());
}

TEST(Picture, the_path_has_equal_scales) {
  for (const PictureSize& size : {PictureSize{}, PictureSize{600, 300}, PictureSize{500, 900}}) {
    const std::string svg = picture(small_scene(), size);
    const auto x = numbers_of(svg, "<circle", "cx"), y = numbers_of(svg, "<circle", "cy");
    EXPECT_NEAR(x[1] - x[0], -2 * (y[1] - y[0]), 0.05) << "keys at (0, 0) and (2, 1)";
  }
}

TEST(Picture, the_lowest_strip_of_each_column_has_the_time) {
  const std::string svg = picture(scene_of_channels(20), {});
  EXPECT_EQ(count(svg, ">time<"), 1U);
  const auto frames = views_of(svg);
  EXPECT_EQ(frames.size(), 21U);
}

TEST(Picture, the_legend_has_colours_and_dashes_of_groups_in_as_many_lines_as_they_need) {
  Scene scene = small_scene();
  scene.names = {"a", "b"};
  const double few = numbers_of(picture(scene, {}), "<svg", "height")[0];
  for (int i = 0; i < 100; ++i) scene.names.push_back("group " + std::to_string(i));
  const std::string svg = picture(scene, {});
  EXPECT_THAT(svg, HasSubstr("and 78 more"));
  EXPECT_THAT(svg, HasSubstr("class=\"c5\""));
  EXPECT_THAT(svg, HasSubstr("class=\"c0 d1\""));
  EXPECT_THAT(svg, HasSubstr("class=\"c1 d2\""));
  EXPECT_GT(numbers_of(svg, "<svg", "height")[0], few + 40);
}

}  // namespace
}  // namespace tcb
