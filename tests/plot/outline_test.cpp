// Outlines: exact Bezier curves, polylines near them, and the extremes of many vertices.
#include "plot/outline.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace tcb {
namespace {

/// From one column of pixels to a place on the right of it, without tangents upwards.
PixelSegment segment(double x, double width, double y0, double y3, bool is_graph) {
  return {{Pixel{x, y0}, {x + width / 3, y0}, {x + 2 * width / 3, y3}, {x + width, y3}}, {}, is_graph};
}

/// The vertices of a polyline.
std::vector<Pixel> vertices(const std::string& data) {
  std::istringstream in(data.substr(1));
  std::vector<Pixel> all;
  for (Pixel at; in >> at.x >> at.y;) all.push_back(at);
  return all;
}

double distance(const Pixel& p, const Pixel& a, const Pixel& b) {
  const double length2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  const double along = length2 > 0 ? ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length2 : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - part * (b.x - a.x), p.y - a.y - part * (b.y - a.y));
}

double distance(const Pixel& p, const std::vector<Pixel>& line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance(p, line[i - 1], line[i]));
  return least;
}

TEST(Outline, a_segment_is_a_bezier_curve) {
  ExactOutline outline;
  outline.add({{Pixel{0, 1}, {2, 3}, {4, 5}, {6, 7}}});
  outline.add({{Pixel{6, 7}, {8, 7.25}, {9, 8}, {10, 10}}});
  EXPECT_EQ(outline.data(), "M0 1C2 3 4 5 6 7C8 7.25 9 8 10 10");
}

TEST(Outline, a_segment_with_ease_is_a_polyline_over_time) {
  ExactOutline outline;
  PixelSegment eased{{Pixel{0, 0}, {30, 100. / 3}, {60, 200. / 3}, {90, 100}}, spline::Warp<double>(1, 0), true};
  outline.add(eased);
  const auto line = vertices(outline.data().replace(outline.data().find('L'), 1, " "));
  for (const Pixel& at : line) EXPECT_NEAR(at.y, at.x * at.x / 81, 0.02);  // f = 1: the place is the square of the time
  EXPECT_GT(line.size(), 8U);
}

TEST(Outline, many_smooth_segments_are_a_polyline_within_a_quarter_of_a_pixel) {
  for (const bool is_graph : {true, false}) {
    ThinnedOutline outline(is_graph, 0, 500, 4000);
    std::vector<PixelSegment> all;
    constexpr int number = 20000;
    const auto at = [](int i) { return Pixel{500.0 * i / number, 100 + 90 * std::sin(i / 1500.0)}; };
    for (int i = 0; i < number; ++i) {
      const Pixel a = at(i), b = at(i + 1);
      all.push_back({{a, a + (1. / 3) * (b - a), a + (2. / 3) * (b - a), b}, {}, is_graph});
      outline.add(all.back());
    }
    const auto line = vertices(outline.data());
    EXPECT_LT(line.size(), 250U);
    for (int i = 0; i < number; i += 7) ASSERT_LE(distance(at(i), line), 0.25) << i;
  }
}

TEST(Outline, corners_and_extremes_of_disorder_remain) {
  std::mt19937 random(1);
  for (const bool is_graph : {true, false}) {
    ThinnedOutline outline(is_graph, 0, 400, 1000);
    double low = 1e9, high = -1e9, y = 0;
    for (int i = 0; i < 100000; ++i) {
      const double next = static_cast<double>(random() % 20000) / 100;
      outline.add(segment(i / 250.0, 1 / 250.0, y, next, is_graph));
      low = std::min(low, y = next);
      high = std::max(high, y);
    }
    const auto line = vertices(outline.data());
    EXPECT_LE(line.size(), 1004U);
    const auto [least, most] = std::ranges::minmax_element(line, {}, &Pixel::y);
    EXPECT_NEAR(least->y, low, 0.11);
    EXPECT_NEAR(most->y, high, 0.11);
  }
}

TEST(Outline, a_spike_among_many_segments_remains) {
  ThinnedOutline outline(true, 0, 400, 400);
  for (int i = 0; i < 50000; ++i) {
    outline.add(segment(i / 125.0, 1 / 125.0, i == 30001 ? 7 : 100, i == 30000 ? 7 : 100, true));
  }
  EXPECT_THAT(outline.data(), testing::HasSubstr(" 7"));
  const auto line = vertices(outline.data());
  EXPECT_EQ(std::ranges::min_element(line, {}, &Pixel::y)->y, 7);
}

TEST(Outline, straight_lines_need_their_ends_only) {
  EXPECT_EQ(thinned({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {3, 0}}, 0.1).size(), 3U);
  EXPECT_EQ(thinned({{0, 0}, {5, 0}, {2, 0}}, 0.1).size(), 3U);  // it goes back
}

}  // namespace
}  // namespace tcb
