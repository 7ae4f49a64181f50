// Views: two axes in a box of the picture, one for time or a channel to the right and one for a channel up.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "picture/axis.hpp"
#include "picture/outline.hpp"
#include "picture/scene.hpp"
#include "picture/svg.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb {

/// Two axes in a box. Without a channel to the right the view is a graph over time.
struct View {
  Box box = {};
  std::optional<std::size_t> right;
  std::size_t up = 0;
  Axis x = {}, y = {};
  std::string heading = {};  ///< above the box, to the left: the name of the axis that points up
  std::string name = {};     ///< of the axis to the right; empty: it has no texts

  bool is_graph() const { return !right.has_value(); }
  double x_scale() const { return box.width / x.length(); }
  double y_scale() const { return box.height / y.length(); }

  /// The place of a point. A channel without a position gives a number that is not finite.
  Pixel at(const Time& t, std::span<const double> position) const;
  Pixel direction(std::span<const double> velocity) const;
  PixelSegment segment(const spline::Segments<double>& segments, std::size_t i) const;
};

/// Room for the numbers to the left of an axis that points up.
double width_of_numbers(const Axis& axis, double pixels);

void draw_frame(Svg& svg, const View& view);

/// Which marks a picture has.
struct Marks {
  bool keys = false, corners = false, handles = false, samples = false, worst = false, curve = false;
  bool dots = false;                               ///< of the samples of polylines
  bool hides_keys = false, hides_samples = false;  ///< no view has them, as they are too many
  std::size_t sample_stride = 1;                   ///< one of so many samples
};

inline constexpr double key_radius = 3.2, sample_radius = 2.2, half_tick = 4, worst_radius = 7;

/// Draws one curve in one view, segment by segment in order.
class CurveDrawing {
 public:
  CurveDrawing(const View& view, const Marks& marks, std::unique_ptr<Outline> outline)
      : view_(view), marks_(marks), outline_(std::move(outline)) {}

  void add(const spline::Segments<double>& segments, std::size_t i);
  /// `keys`: all keys of the curve, or none.
  void draw(Svg& svg, const SceneCurve& curve, const Keys& keys);
  const Marks& drawn() const { return drawn_; }

 private:
  void add_handles(const PixelSegment& segment, const Pixel& out, const Pixel& in);

  const View& view_;
  Marks marks_;
  std::unique_ptr<Outline> outline_;
  std::string handles_;
  Marks drawn_;
  std::vector<bool> corners_;      ///< of the keys so far
  std::optional<Pixel> incoming_;  ///< the direction at the end of the previous segment
  std::optional<Pixel> first_;     ///< the direction at the start of the first segment
};

/// Draws the axes of a rotation along the path of one curve, at equal numbers of segments.
class AxesDrawing {
 public:
  /// `view`: of the path; `segments`: those of all curves.
  AxesDrawing(const Scene& scene, const View& view, std::size_t segments)
      : frame_(scene.frame), view_(view), between_((segments + most_places - 1) / most_places) {}

  void add(const spline::Segments<double>& segments);
  void draw(Svg& svg) const;

 private:
  static constexpr std::size_t most_places = 40;

  const std::optional<SceneFrame>& frame_;
  const View& view_;
  std::size_t between_, next_ = 0;   ///< segments
  std::array<std::string, 3> axes_;  ///< as data of paths
};

/// Whether the directions differ visibly.
bool is_corner(const Pixel& incoming, const Pixel& outgoing);

}  // namespace tcb
