// Legend: entries for names and marks, in lines.
#include "plot/legend.hpp"

#include <gmock/gmock.h>

#include "plot/scene_of.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string drawn(const Legend& legend, const Marks& marks) {
  Svg svg;
  legend.draw(svg, {0, 0}, marks, {});
  return svg.text();
}

TEST(Legend, it_has_the_marks_that_are_there) {
  const Scene scene = small_scene();
  const Legend legend(scene, 900);
  EXPECT_THAT(drawn(legend, {.keys = true}), HasSubstr(">key<"));
  EXPECT_THAT(drawn(legend, {.keys = true}), Not(HasSubstr("sample")));
  EXPECT_THAT(drawn(legend, {.samples = true}), HasSubstr(">sample<"));
}

TEST(Legend, groups_have_colours_and_then_dashes) {
  EXPECT_EQ(colour_of(0), "c0");
  EXPECT_EQ(colour_of(5), "c5");
  EXPECT_EQ(colour_of(6), "c0 d1");
  EXPECT_EQ(colour_of(13), "c1 d2");
}

TEST(Legend, it_has_as_many_lines_as_the_names_need) {
  Scene scene = small_scene();
  scene.names = {"a", "b"};
  const double line = Legend(scene, 900).height();
  for (int i = 0; i < 100; ++i) scene.names.push_back("group " + std::to_string(i));
  const Legend legend(scene, 900);
  EXPECT_GT(legend.height(), 2 * line);
  EXPECT_THAT(drawn(legend, {}), HasSubstr("and 78 more"));
}

}  // namespace
}  // namespace tcb
