// SVG: numbers, texts and elements.
#include "picture/svg.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

std::string pixels(double value) {
  std::string out;
  append_pixels(out, value);
  return out;
}

TEST(Svg, numbers_have_two_decimals_at_most) {
  EXPECT_EQ(pixels(12), "12");
  EXPECT_EQ(pixels(0.125), "0.12");
  EXPECT_EQ(pixels(-3.999), "-4");
  EXPECT_EQ(pixels(-0.001), "0");
  EXPECT_EQ(pixels(100), "100");
  EXPECT_EQ(pixels(1e300), "10000000");
}

TEST(Svg, pixels_are_separated) {
  std::string out = "M";
  append_pixel(out, {1, 2.5});
  append_pixel(out, {-3, 4});
  EXPECT_EQ(out, "M1 2.5 -3 4");
}

TEST(Svg, texts_are_escaped) {
  EXPECT_EQ(xml_text("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(xml_text("line\nend\x01"), "line\\x0Aend\\x01");
  EXPECT_EQ(xml_text("\xFFu"), "\xEF\xBF\xBDu");
  EXPECT_EQ(xml_text("\xEF\xBF\xBF"), "\xEF\xBF\xBD");
  EXPECT_EQ(xml_text("Größe 高さ"), "Größe 高さ");
}

TEST(Svg, texts_that_do_not_fit_end_in_an_ellipsis) {
  EXPECT_EQ(fitted("time", 100, 12), "time");
  const std::string cut = fitted("a very long name of a column", 60, 12);
  EXPECT_THAT(cut, testing::EndsWith("…"));
  EXPECT_LE(text_width(cut, 12), 60);
  EXPECT_GT(text_width("高さ", 10), text_width("ab", 10));
}

TEST(Svg, elements) {
  Svg svg;
  svg.add_circle({1, 2}, 3, "k");
  svg.add_text({1, 2}, "a&b", "v", "end");
  svg.add_path("M1 2h3", "l");
  svg.add_box({1, 2, 3, 4}, "f");
  EXPECT_EQ(svg.text(),
            "<circle class=\"k\" cx=\"1\" cy=\"2\" r=\"3\"/>\n"
            "<text x=\"1\" y=\"2\" text-anchor=\"end\" class=\"v\">a&amp;b</text>\n"
            "<path class=\"l\" d=\"M1 2h3\"/>\n"
            "<rect class=\"f\" x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>\n");
}

}  // namespace
}  // namespace tcb
