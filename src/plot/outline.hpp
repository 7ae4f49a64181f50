// Outlines: segments as exact Bezier curves in pixels, or many of them as a polyline within a quarter of a pixel.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plot/svg.hpp"
#include "tcb/spline/ease.hpp"

namespace tcb {

/// A segment in a view, as the control points of a cubic Bezier curve.
struct PixelSegment {
  std::array<Pixel, 4> points;
  spline::Warp<double> warp = {};  ///< of the local parameter; `is_graph` only
  bool is_graph = false;           ///< the view shows time to the right, which is linear without a warp
};

/// The outline of one curve in one view as the data of a path.
class Outline {
 public:
  virtual ~Outline() = default;
  virtual void add(const PixelSegment& segment) = 0;
  virtual std::string data() = 0;
};

/// Every segment as a Bezier curve; an eased one in a graph as a polyline within a tenth of a pixel.
class ExactOutline : public Outline {
 public:
  void add(const PixelSegment& segment) override;
  std::string data() override { return data_; }

 private:
  std::string data_;
};

/// A polyline of a bounded number of vertices. Promises: within a quarter of a pixel of the curve if that needs no
/// more vertices; otherwise it has the extremes of each part of the curve, in a graph of each column of pixels.
/// Memory: a few times the number of vertices.
class ThinnedOutline : public Outline {
 public:
  ThinnedOutline(bool is_graph, double left, double width, std::size_t most_vertices);
  void add(const PixelSegment& segment) override;
  std::string data() override;

 private:
  void add_vertex(const Pixel& at);
  void add_to_column(const Pixel& at);
  void end_column();
  void halve();

  bool is_graph_;
  double left_, column_width_;
  std::size_t most_;
  std::vector<Pixel> vertices_;
  std::vector<Pixel> column_;  ///< first, lowest, highest and last vertex of the current column
  double column_number_ = 0;
  double nearest_ = 0.1;       ///< vertices of a path that are nearer to the previous one are dropped
  std::optional<Pixel> last_;  ///< of all
};

/// The fewest vertices that Douglas and Peucker's method finds, so that all others are within `distance` of them.
std::vector<Pixel> thinned(const std::vector<Pixel>& vertices, double distance);

}  // namespace tcb
