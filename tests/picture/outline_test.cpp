// Outlines: exact Bezier curves, and the distance of polylines and cells from many of them.
#include "picture/outline.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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

constexpr Box box{0, 0, 500, 200};

TEST(Outline, a_segment_is_a_bezier_curve) {
  ExactOutline outline;
  outline.add({{Pixel{0, 1}, {2, 3}, {4, 5}, {6, 7}}});
  outline.add({{Pixel{6, 7}, {8, 7.25}, {9, 8}, {10, 10}}});
  EXPECT_EQ(outline.path().data, "M0 1C2 3 4 5 6 7C8 7.25 9 8 10 10");
}

TEST(Outline, a_segment_with_ease_is_a_polyline_over_time) {
  ExactOutline outline;
  PixelSegment eased{{Pixel{0, 0}, {30, 100. / 3}, {60, 200. / 3}, {90, 100}}, spline::Warp<double>(1, 0), true};
  outline.add(eased);
  const auto line = vertices(outline.path().data.replace(outline.path().data.find('L'), 1, " "));
  for (const Pixel& at : line) EXPECT_NEAR(at.y, at.x * at.x / 81, 0.02);  // f = 1: the place is the square of the time
  EXPECT_GT(line.size(), 8U);
}

TEST(Outline, many_smooth_segments_are_a_polyline_within_a_quarter_of_a_pixel) {
  for (const bool is_graph : {true, false}) {
    ThinnedOutline outline(box);
    std::vector<PixelSegment> all;
    constexpr int number = 20000;
    const auto at = [](int i) { return Pixel{500.0 * i / number, 100 + 90 * std::sin(i / 1500.0)}; };
    for (int i = 0; i < number; ++i) {
      const Pixel a = at(i), b = at(i + 1);
      all.push_back({{a, a + (1. / 3) * (b - a), a + (2. / 3) * (b - a), b}, {}, is_graph});
      outline.add(all.back());
    }
    const auto line = vertices(outline.path().data);
    EXPECT_LT(line.size(), 250U);
    for (int i = 0; i < number; i += 7) ASSERT_LE(distance(at(i), line), 0.25) << i;
  }
}

/// Points at most a quarter of a pixel apart on the drawn path of an outline.
std::vector<Pixel> drawn(const std::string& data) {
  std::vector<Pixel> points;
  const auto add = [&points](const Pixel& from, const Pixel& to) {
    const int steps = static_cast<int>(4 * std::max(std::abs(to.x - from.x), std::abs(to.y - from.y))) + 1;
    for (int i = 0; i <= steps; ++i) points.push_back(from + static_cast<double>(i) / steps * (to - from));
  };
  if (data.find_first_of("hv") == std::string::npos) {
    const auto line = vertices(data);
    for (std::size_t i = 1; i < line.size(); ++i) add(line[i - 1], line[i]);
    return points;
  }
  std::istringstream in(data);
  for (char letter = 0; in >> letter;) {
    Pixel at;
    double length = 0;
    in >> at.x >> at.y >> letter >> length;
    add(at, at + (letter == 'h' ? Pixel{length, 0} : Pixel{0, length}));
  }
  return points;
}

/// Whether each of some points is within a distance of one of others.
bool all_near(const std::vector<Pixel>& points, const std::vector<Pixel>& others, double distance) {
  constexpr std::size_t rows = 206, columns = 506;
  std::vector<std::vector<Pixel>> cells(rows * columns);
  const auto index = [](const Pixel& at) {
    return static_cast<std::size_t>(std::floor(at.y) + 3) * columns + static_cast<std::size_t>(std::floor(at.x) + 3);
  };
  for (const Pixel& at : others) {
    auto& cell = cells.at(index(at));
    if (cell.size() < 100) cell.push_back(at);
  }
  return std::ranges::all_of(points, [&](const Pixel& at) {
    for (const std::size_t row : {index(at) - columns, index(at), index(at) + columns}) {
      for (std::size_t cell = row - 1; cell <= row + 1; ++cell) {
        for (const Pixel& other : cells.at(cell)) {
          if (std::hypot(other.x - at.x, other.y - at.y) <= distance) return true;
        }
      }
    }
    return false;
  });
}

/// Segments of some kind of path, which stays in the box.
std::vector<PixelSegment> path_of(const std::string& kind, int number) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<PixelSegment> all;
  Pixel at{250, 100};
  const auto inside = [](double value, double size) { return size / 2 + std::abs(std::remainder(value, size)); };
  for (int i = 0; i < number; ++i) {
    Pixel next, bend{};
    const double part = (i + 1.0) / number;
    if (kind == "random walk") {
      next = {at.x + 3 * normal(random), at.y + 3 * normal(random)};
      next = {std::clamp(next.x, 5.0, 495.0), std::clamp(next.y, 5.0, 195.0)};
      bend = {normal(random), normal(random)};
    } else if (kind == "laps") {
      const double turn = 2 * std::numbers::pi * std::max(number / 500, 1) * part;
      next = {250 + (200 + 8 * std::sin(turn / 37)) * std::cos(turn),
              100 + (80 + 8 * std::sin(turn / 41)) * std::sin(turn)};
    } else {
      next = {500 * part, inside(normal(random) * 10, 100)};
    }
    all.push_back({{at, at + (1. / 3) * (next - at) + bend, at + (2. / 3) * (next - at) - bend, next}, {}, false});
    at = next;
  }
  return all;
}

/// Measures the distance of the outline of a path from its curve, and of the curve from the outline.
void expect_near(const std::string& kind, int number) {
  ThinnedOutline outline(box);
  std::vector<Pixel> curve;
  for (const PixelSegment& segment : path_of(kind, number)) {
    outline.add(segment);
    const auto& p = segment.points;
    const double size = std::hypot(p[3].x - p[0].x, p[3].y - p[0].y);
    const int steps = 6 + static_cast<int>(4 * size);
    for (int i = 0; i <= steps; ++i) {
      const double u = static_cast<double>(i) / steps, v = 1 - u;
      curve.push_back(v * v * v * p[0] + 3 * v * v * u * p[1] + 3 * v * u * u * p[2] + u * u * u * p[3]);
    }
  }
  const OutlinePath path = outline.path();
  const std::vector<Pixel> line = drawn(path.data);
  EXPECT_TRUE(all_near(curve, line, 1)) << kind << " of " << number;
  EXPECT_TRUE(all_near(line, curve, 1)) << kind << " of " << number;
  EXPECT_LT(path.data.size(), 1'500'000U) << kind << " of " << number;
}

TEST(Outline, no_outline_is_farther_than_a_pixel_from_its_curve) {
  for (const char* const kind : {"random walk", "laps", "noise"}) {
    for (const int number : {10, 1000, 30000}) expect_near(kind, number);
  }
}

TEST(Outline, a_spike_among_many_segments_remains) {
  ThinnedOutline outline(box);
  for (int i = 0; i < 50000; ++i) {
    outline.add(segment(i / 125.0, 1 / 125.0, i == 30001 ? 7 : 100, i == 30000 ? 7 : 100, true));
  }
  EXPECT_THAT(outline.path().data, testing::HasSubstr(" 7"));
  const auto line = vertices(outline.path().data);
  EXPECT_EQ(std::ranges::min_element(line, {}, &Pixel::y)->y, 7);
}

TEST(Outline, straight_lines_need_their_ends_only) {
  EXPECT_EQ(thinned({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {3, 0}}, 0.1).size(), 3U);
  EXPECT_EQ(thinned({{0, 0}, {5, 0}, {2, 0}}, 0.1).size(), 3U);  // it goes back
}

}  // namespace
}  // namespace tcb
