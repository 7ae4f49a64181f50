// Picture: the views of a scene with their curves, titles and the legend, as SVG.
#include "plot/picture.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "plot/arrangement.hpp"
#include "plot/legend.hpp"
#include "plot/scene.hpp"
#include "plot/svg.hpp"
#include "plot/view.hpp"

namespace tcb {
namespace {

/// The size of a picture in bytes up to which outlines are exact, a little less than 300 kB.
constexpr std::size_t most_bytes = 290000;

/// The approximate size of an element in bytes, with the one between others.
constexpr std::size_t bytes_of_segment = 42, bytes_of_dot = 48, bytes_of_tick = 26, bytes_of_path = 40;

/// More dots or ticks would be too close together in a view, or too many bytes.
constexpr double between_keys = 4, between_samples = 3;
constexpr std::uint64_t most_dots = 1200;

class Composer {
 public:
  Composer(const Scene& scene, const SceneExtent& extent, const PictureSize& size)
      : scene_(scene),
        extent_(extent),
        legend_(scene, picture_width(scene, size) - 2 * picture_margin),
        arrangement_(arranged(scene, extent_, size, legend_.height())) {
    for (const View& view : arrangement_.views) marks_.push_back(marks_of(view));
  }

  std::string compose() {
    svg_.begin(arrangement_.width, arrangement_.height, scene_.title + ". " + scene_.subtitle);
    draw_titles();
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      draw_frame(svg_, arrangement_.views[i], arrangement_.frames[i]);
    }
    bytes_for_outlines_ = bytes_for_outlines();
    for (const SceneCurve& curve : scene_.curves) draw_curve(curve);
    if (scene_.worst) draw_worst(*scene_.worst);
    const Marks shown{any(&Marks::keys), any(&Marks::corners), any(&Marks::handles), any(&Marks::samples),
                      scene_.worst.has_value()};
    legend_.draw(svg_, {picture_margin, arrangement_.height - legend_.height()}, shown,
                 {scene_.keys() > 0 && !shown.keys, scene_.rows() > 0 && !shown.samples});
    svg_.end();
    return svg_.text();
  }

 private:
  Marks marks_of(const View& view) const {
    const std::uint64_t rows = scene_.rows();
    const std::size_t views = arrangement_.views.size();
    const auto fits = [&](std::uint64_t count, double spacing) {
      const double room = view.is_graph() ? view.box.width : 3 * view.box.width;
      return static_cast<double>(count) * spacing <= room && count * (view.is_graph() ? views : 1) <= most_dots;
    };
    Marks marks;
    marks.keys = fits(scene_.keys(), between_keys);
    marks.dots = marks.keys && fits(scene_.keys() + scene_.dots(), between_keys);
    marks.handles = marks.keys && (!view.is_graph() || !scene_.path);
    marks.samples = rows > 0 && scene_.has_samples() && fits(rows, between_samples);
    return marks;
  }

  bool any(bool Marks::*mark) const {
    return std::ranges::any_of(marks_, [&](const Marks& marks) { return marks.*mark; });
  }

  void draw_titles() {
    const double room = arrangement_.width - 2 * picture_margin;
    svg_.add_text({picture_margin, 28}, fitted(scene_.title, room, title_size), "t");
    svg_.add_text({picture_margin, 47}, fitted(scene_.subtitle, room, text_size), "u");
    bool named_time = false;
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      const bool is_graph = arrangement_.views[i].is_graph();
      if (arrangement_.frames[i].name.empty() || (is_graph && named_time)) continue;
      named_time = named_time || is_graph;
      const Box& box = is_graph ? arrangement_.time_title : arrangement_.views[i].box;
      const double bottom = is_graph ? box.top : box.bottom();
      svg_.add_text({box.left + box.width / 2, bottom + 34}, arrangement_.frames[i].name, "n", "middle");
    }
  }

  /// The number of bytes left for the outlines of all curves in one view.
  std::size_t bytes_for_outlines() const {
    std::size_t others = svg_.size() + scene_.curves.size() * bytes_of_path;
    for (const Marks& marks : marks_) {
      others += scene_.curves.size() * bytes_of_path;
      if (marks.keys) others += scene_.keys() * (bytes_of_dot + (marks.handles ? 2 * bytes_of_tick : 0));
      if (marks.dots) others += scene_.dots() * bytes_of_dot;
      if (marks.samples) others += scene_.rows() * bytes_of_tick;
    }
    return others < most_bytes ? (most_bytes - others) / marks_.size() : 0;
  }

  std::unique_ptr<Outline> outline_of(const View& view) const {
    if (extent_.segments * bytes_of_segment <= bytes_for_outlines_) return std::make_unique<ExactOutline>();
    return std::make_unique<ThinnedOutline>(view.box);
  }

  void draw_curve(const SceneCurve& curve) {
    const std::vector<View>& views = arrangement_.views;
    std::vector<CurveDrawing> drawings;
    for (std::size_t i = 0; i < views.size(); ++i) {
      Marks marks = marks_[i];
      if (curve.is_polyline) {
        marks.keys = marks.dots;
        marks.handles = false;
      }
      drawings.emplace_back(views[i], marks, outline_of(views[i]));
    }
    const Source<SegmentBlock> blocks = curve.segments();
    AxesDrawing axes(scene_, arrangement_.views[0], extent_.segments);
    while (const std::optional<SegmentBlock> block = blocks()) {
      axes.add(block->segments);
      for (CurveDrawing& drawing : drawings) {
        for (std::size_t i = 0; i < block->segments.size(); ++i) drawing.add(block->segments, i);
      }
    }
    const Keys keys = any(&Marks::keys) ? curve.keys.all() : Keys();
    axes.draw(svg_);
    svg_.begin_group(colour_of(curve.name));
    for (std::size_t i = 0; i < views.size(); ++i) {
      drawings[i].draw(svg_, curve, keys);
      marks_[i].corners = marks_[i].corners || drawings[i].has_corner();
    }
    svg_.end_group();
  }

  void draw_worst(const SceneMark& mark) {
    for (const View& view : arrangement_.views) {
      if (std::ranges::count(mark.channels, view.up) == 0) continue;
      svg_.add_circle(view.at(mark.t, mark.position), worst_radius, "w");
    }
  }

  const Scene& scene_;
  const SceneExtent& extent_;
  const Legend legend_;
  const Arrangement arrangement_;
  std::vector<Marks> marks_;  ///< one a view
  std::size_t bytes_for_outlines_ = 0;
  Svg svg_;
};

}  // namespace

std::string picture(Scene scene, const PictureSize& size) {
  const SceneExtent extent = extent_of(scene);
  remove_flat_path(scene, extent);
  return Composer(scene, extent, size).compose();
}

}  // namespace tcb
