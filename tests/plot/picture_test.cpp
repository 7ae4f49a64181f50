// Picture: what a picture has, and its size in bytes.
#include "plot/picture.hpp"

#include <gmock/gmock.h>

#include "plot/scene.hpp"
#include "plot/scene_of.hpp"

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

}  // namespace
}  // namespace tcb
