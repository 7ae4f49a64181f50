// Outlines: segments as exact Bezier curves in pixels; many of them as a polyline within a quarter of a pixel, or as
// the cells of half a pixel that they cross. No outline is farther than a pixel from its curve.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/svg.hpp"
#include "tcb/spline/ease.hpp"

namespace tcb {

/// A segment in a view, as the control points of a cubic Bezier curve.
struct PixelSegment {
  std::array<Pixel, 4> points;
  spline::Warp<double> warp = {};  ///< of the local parameter; `is_graph` only
  bool is_graph = false;           ///< the view shows time to the right, which is linear without a warp
};

/// The data of a path and its class.
struct OutlinePath {
  std::string data;
  std::string_view css = "l";
};

/// The outline of one curve in one view.
class Outline {
 public:
  virtual ~Outline() = default;
  virtual void add(const PixelSegment& segment) = 0;
  virtual OutlinePath path() = 0;
};

/// Every segment as a Bezier curve; an eased one in a graph as a polyline within a tenth of a pixel.
class ExactOutline : public Outline {
 public:
  void add(const PixelSegment& segment) override;
  OutlinePath path() override { return {data_}; }

 private:
  std::string data_;
};

/// The cells of half a pixel that lines cross. Memory: a bit for each cell of the box.
class CrossedCells {
 public:
  explicit CrossedCells(const Box& box);

  /// Adds points of a line that are at most a cell apart.
  void add_line(const Pixel& from, const Pixel& to);

  /// The cells as horizontal or as vertical lines through neighbouring ones, whichever are fewer. Promises: a line is
  /// within 0.75 pixels of every point of the lines added, and every point of a line is as near to one of them.
  std::string data() const;

 private:
  void add(const Pixel& at);
  std::string lines(bool along_rows) const;

  Pixel corner_;
  std::size_t columns_;
  std::vector<std::vector<bool>> rows_;
};

/// Many segments as a polyline within a quarter of a pixel, or as cells where that takes fewer bytes.
/// Memory: up to `most_vertices`, or the cells.
class ThinnedOutline : public Outline {
 public:
  /// `box`: that of the view.
  explicit ThinnedOutline(const Box& box) : box_(box) {}
  void add(const PixelSegment& segment) override;
  OutlinePath path() override;

 private:
  void add_vertex(const Pixel& at);
  CrossedCells cells_of(const std::vector<Pixel>& vertices) const;

  static constexpr std::size_t most_vertices = 100000;

  Box box_;
  std::vector<Pixel> vertices_;        ///< without those that are near the one before; empty once there are cells
  std::optional<CrossedCells> cells_;  ///< of a curve with more vertices
  std::optional<Pixel> last_;          ///< vertex
};

/// The fewest vertices that Douglas and Peucker's method finds, so that all others are within `distance` of them.
std::vector<Pixel> thinned(const std::vector<Pixel>& vertices, double distance);

}  // namespace tcb
