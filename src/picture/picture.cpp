// Picture: the views of a scene with their curves, titles and the legend, as SVG.
//
// The Arranger gives each view its box. The Composer decides which marks have room in each view, draws the curves with
// them (view.hpp), and the Legend shows those that were drawn.
#include "picture/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "error.hpp"
#include "picture/scene.hpp"
#include "picture/svg.hpp"
#include "picture/view.hpp"
#include "sample/build.hpp"

namespace tcb {

namespace {

/// Between the edge of the picture and its contents.
constexpr double picture_margin = 16;

struct Arrangement {
  double width = 0, height = 0;
  std::vector<View> views;  ///< the path, if there is one, then a strip per channel
  Box time_title;           ///< below the strips
};

constexpr double top = 62, heading = 22, below_axis = 40, gap_between = 18;
constexpr double path_width = 470, strip_width = 520, narrow_strip = 230;
constexpr double least_width = 40, least_height = 28;
constexpr std::size_t strips_in_column = 10, most_columns = 6;

std::size_t columns_of(const Scene& scene) {
  return std::clamp<std::size_t>((scene.strip_count() + strips_in_column - 1) / strips_in_column, 1, most_columns);
}

double picture_width(const Scene& scene, const PictureSize& size) {
  if (size.width > 0) return size.width;
  const std::size_t columns = columns_of(scene);
  const double strips = columns == 1 ? strip_width : static_cast<double>(columns) * narrow_strip;
  return 2 * picture_margin + strips + (scene.path ? path_width : columns == 1 ? 200 : 0);
}

/// The title of an axis; a name that is too long is cut, the base is not.
std::string title_within(const Axis& axis, const std::string& name, double width) {
  return axis.title(fitted(name, width - text_width(axis.title(""), bold_size), bold_size));
}

/// Places the path to the left, and the strips to the right, in columns if there are many.
class Arranger {
 public:
  /// `legend_height`: left free at the bottom. Throws: Error (usage) if the channels need a larger picture.
  Arranger(const Scene& scene, const SceneExtent& extent, const PictureSize& size, double legend_height)
      : scene_(scene), extent_(extent), strips_(scene.strip_count()), columns_(columns_of(scene)) {
    result_.width = picture_width(scene, size);
    const double around = top + below_axis + legend_height;
    if (size.height > 0) {
      const double in_column = std::max(1.0, std::floor((size.height - around) / (least_height + heading)));
      columns_ = static_cast<std::size_t>(std::ceil(static_cast<double>(strips_) / in_column));
    }
    rows_ = (strips_ + columns_ - 1) / columns_;
    const auto rows = static_cast<double>(rows_);
    const double usual = std::clamp(std::floor(400 / rows) - heading, 56.0, 360.0);
    result_.height = size.height > 0 ? size.height : around + rows * (usual + heading);
    strip_height_ = (result_.height - around) / rows - heading;
    bottom_ = result_.height - below_axis - legend_height;
    require(strip_height_ >= least_height);
  }

  Arrangement arrange() {
    double left = picture_margin;
    if (scene_.path) left = place_path() + picture_margin + 6;
    const double right = result_.width - picture_margin;
    const double room = (right - left) / static_cast<double>(columns_);
    result_.time_title = {left, bottom_, right - left, below_axis};
    for (std::size_t column = 0; column < columns_; ++column) {
      place_strips(column, left + static_cast<double>(column) * room, room);
    }
    return std::move(result_);
  }

 private:
  void require(bool has_room) const {
    if (has_room) return;
    throw usage_error("the picture is too small for {} channels; give a larger --size, or leave it out", strips_);
  }

  /// The path, with equal scales. Returns its right end.
  double place_path() {
    const auto& [right, up] = extent_.path;
    const double larger = std::max(size_of(right), size_of(up));
    View view{{}, (*scene_.path)[0], (*scene_.path)[1], Axis(right, 0.05, larger), Axis(up, 0.05, larger)};
    Box& box = view.box;
    const double room = result_.width - 2 * picture_margin;
    const double width = columns_ == 1 ? room * 0.48 : std::min(path_width, room * 0.48);
    box.top = top + heading;
    box.height = std::min(bottom_ - box.top, std::max(width * 1.1, 120.0));
    const double numbers = width_of_numbers(view.y, box.height) + 4;
    box.left = picture_margin + numbers;
    box.width = width - numbers;
    require(box.width >= least_width);
    const double scale = std::min(box.width / view.x.length(), box.height / view.y.length());
    view.x.set_length(box.width / scale);
    view.y.set_length(box.height / scale);
    const std::string name = scene_.channels[*view.right];
    const double name_room = view.box.width;
    return add(std::move(view), name, name_room);
  }

  /// Keys have tangents in strips if there is no path, and if there is room for them.
  const Interval& extent_of_strip(std::size_t channel) const {
    constexpr std::uint64_t most_keys = 120;
    const bool has_tangents = !scene_.path && scene_.keys() <= most_keys && channel < extent_.with_tangents.size() &&
                              !extent_.with_tangents[channel].empty();
    return has_tangents ? extent_.with_tangents[channel] : extent_.channels[channel];
  }

  void place_strips(std::size_t column, double left, double room) {
    const std::size_t begin = column * rows_, end = std::min(begin + rows_, strips_);
    std::vector<View> strips;
    double numbers = 0;
    for (std::size_t strip = begin; strip < end; ++strip) {
      const std::size_t channel = scene_.strips.empty() ? strip : scene_.strips[strip];
      strips.push_back({{}, {}, channel, Axis(extent_.time, scene_.time_scale), Axis(extent_of_strip(channel), 0.06)});
      numbers = std::max(numbers, width_of_numbers(strips.back().y, strip_height_));
    }
    for (std::size_t i = 0; i < strips.size(); ++i) {
      const double above = top + heading + static_cast<double>(i) * (strip_height_ + heading);
      strips[i].box = {left + numbers, above, room - numbers - gap_between, strip_height_};
      require(strips[i].box.width >= least_width);
      add(std::move(strips[i]), i + 1 == strips.size() ? scene_.time : "", result_.time_title.width);
    }
  }

  /// `name`: of the axis to the right, which has so much room for its title; empty: it has none.
  double add(View view, const std::string& name, double room) {
    const double right = view.box.right();
    view.heading = title_within(view.y, scene_.channels[view.up], view.box.width);
    if (!name.empty()) view.name = title_within(view.x, name, room);
    result_.views.push_back(std::move(view));
    return right;
  }

  const Scene& scene_;
  const SceneExtent& extent_;
  const std::size_t strips_;
  std::size_t columns_, rows_ = 1;
  double strip_height_ = 0, bottom_ = 0;
  Arrangement result_;
};

constexpr double symbol_width = 28, between_entries = 16, line_height = 20, widest_name = 200;
constexpr std::size_t most_names = 24;

double width_of(std::string_view text, bool has_symbol) {
  return (has_symbol ? symbol_width : 0) + text_width(text, text_size) + between_entries;
}

/// The class of a curve's colour and dashes.
std::string colour_of(std::size_t name) {
  const std::size_t dashes = name / colours % 3;
  return fmt::format("c{}{}", name % colours, dashes == 0 ? "" : fmt::format(" d{}", dashes));
}

/// Entries side by side, in as many lines as the width requires.
class Legend {
 public:
  Legend(const Scene& scene, double width) : scene_(scene), width_(width) {}

  /// The height of the legend with every mark.
  double height() const {
    const Marks all{true, true, true, true, scene_.worst.has_value(), true, true, false, true};
    return entries(all).back().at.y + line_height + 8;
  }
  /// Draws the marks that the picture has, and the names.
  void draw(Svg& svg, const Pixel& corner, const Marks& marks) const {
    for (const Entry& entry : entries(marks)) {
      const Pixel at = corner + entry.at + Pixel{0, line_height / 2};
      svg.begin_group(entry.css);
      draw_symbol(svg, entry.symbol, at);
      svg.end_group();
      svg.add_text(at + Pixel{entry.symbol == Symbol::none ? 0 : symbol_width, 4}, entry.text, "u");
    }
  }

 private:
  enum class Symbol { none, curve, key, corner, tangent, sample, worst, axis_x, axis_y, axis_z };
  struct Entry {
    Symbol symbol = Symbol::none;
    std::string text;
    std::string css = {};
    Pixel at = {};  ///< where it begins, from the legend's left upper corner
  };

  std::vector<Entry> entries(const Marks& marks) const {
    std::vector<Entry> all;
    if (scene_.names.size() > 1) {
      add_names(all);
    } else {
      if (marks.curve) all.push_back({Symbol::curve, "curve", colour_of(0)});
    }
    const std::string css = scene_.names.size() > 1 ? "c5" : "c0";
    if (marks.keys) all.push_back({Symbol::key, "key", css});
    if (marks.corners) all.push_back({Symbol::corner, "key at a corner", css});
    if (marks.handles) all.push_back({Symbol::tangent, "tangents", css});
    if (marks.samples) {
      const std::size_t stride = marks.sample_stride;
      all.push_back({Symbol::sample, stride == 1 ? "sample" : fmt::format("one of {} samples", stride), css});
    }
    if (scene_.frame) {
      all.push_back({Symbol::axis_x, "x axis", css});
      all.push_back({Symbol::axis_y, "y axis", css});
      all.push_back({Symbol::axis_z, "z axis", css});
    }
    if (marks.worst) all.push_back({Symbol::worst, scene_.worst_in_words, css});
    if (marks.hides_keys) all.push_back({Symbol::none, "keys are too dense to be shown", css});
    if (marks.hides_samples) all.push_back({Symbol::none, "samples are too dense to be shown", css});
    Pixel at;
    for (Entry& entry : all) {
      const double width = width_of(entry.text, entry.symbol != Symbol::none);
      if (at.x > 0 && at.x + width - between_entries > width_) at = {0, at.y + line_height};
      entry.at = at;
      at.x += width;
    }
    return all;
  }

  void add_names(std::vector<Entry>& entries) const {
    const std::size_t shown = std::min(scene_.names.size(), most_names);
    for (std::size_t i = 0; i < shown; ++i) {
      entries.push_back({Symbol::curve, fitted(scene_.names[i], widest_name, text_size), colour_of(i)});
    }
    const std::size_t more = scene_.names.size() - shown;
    if (more > 0) entries.push_back({Symbol::none, fmt::format("and {} more", more), "c5"});
  }

  static void draw_symbol(Svg& svg, Symbol symbol, const Pixel& at) {
    const Pixel middle = at + Pixel{11, 0};
    const auto line = [&svg](const Pixel& from, std::string_view rest, std::string_view css) {
      std::string data = "M";
      append_pixel(data, from);
      svg.add_path(data + std::string(rest), css);
    };
    switch (symbol) {
      case Symbol::none: return;
      case Symbol::curve: return line(at, "h22", "l");
      case Symbol::key: return svg.add_circle(middle, key_radius, "k");
      case Symbol::corner: return svg.add_circle(middle, key_radius, "q");
      case Symbol::tangent: return line(at, "h22", "h");
      case Symbol::worst: return svg.add_circle(middle, worst_radius, "w");
      case Symbol::axis_x: return line(at, "h22", "ax");
      case Symbol::axis_y: return line(at, "h22", "ay");
      case Symbol::axis_z: return line(at, "h22", "az");
      case Symbol::sample: return line(middle - Pixel{0, half_tick}, "v8", "s");
    }
  }

  const Scene& scene_;
  double width_;
};

/// The size of a picture in bytes up to which outlines are exact, a little less than 300 kB.
constexpr std::size_t most_bytes = 290000;

/// The approximate size of an element in bytes, with the one between others.
constexpr std::size_t bytes_of_segment = 42, bytes_of_dot = 48, bytes_of_tick = 26, bytes_of_path = 40;

/// More dots or ticks would be too close together in a view, or too many bytes.
constexpr double between_keys = 4, between_samples = 7;
constexpr std::uint64_t most_dots = 1200;

class Composer {
 public:
  Composer(const Scene& scene, const SceneExtent& extent, const PictureSize& size)
      : scene_(scene),
        extent_(extent),
        legend_(scene, picture_width(scene, size) - 2 * picture_margin),
        arrangement_(Arranger(scene, extent_, size, legend_.height()).arrange()) {
    for (const View& view : arrangement_.views) marks_.push_back(marks_of(view));
    for (const Marks& marks : marks_) shown_.sample_stride = std::max(shown_.sample_stride, marks.sample_stride);
    for (Marks& marks : marks_) marks.sample_stride = shown_.sample_stride;
  }

  std::string compose() {
    svg_.begin(arrangement_.width, arrangement_.height, scene_.title + ". " + scene_.subtitle);
    draw_titles();
    for (const View& view : arrangement_.views) draw_frame(svg_, view);
    bytes_for_outlines_ = bytes_for_outlines();
    for (const SceneCurve& curve : scene_.curves) draw_curve(curve);
    if (scene_.worst) draw_worst(*scene_.worst);
    shown_.worst = scene_.worst.has_value();
    shown_.hides_keys = scene_.keys() > 0 && !any(&Marks::keys);
    shown_.hides_samples = scene_.rows() > 0 && !any(&Marks::samples);
    legend_.draw(svg_, {picture_margin, arrangement_.height - legend_.height()}, shown_);
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
    marks.samples = rows > 0 && scene_.has_samples();
    marks.sample_stride = sample_stride_of(view);
    return marks;
  }

  /// One of so many samples is drawn, so that their ticks do not hide the curve.
  std::size_t sample_stride_of(const View& view) const {
    const double room = (view.is_graph() ? 1 : 3) * view.box.width;
    std::uint64_t most = 0;
    for (const SceneCurve& curve : scene_.curves) most = std::max(most, curve.rows);
    const auto views = static_cast<double>(arrangement_.views.size());
    const double ticks =
        std::min(room / between_samples * static_cast<double>(scene_.rows()) / static_cast<double>(most),
                 static_cast<double>(most_dots) / views);
    return static_cast<std::size_t>(std::max(1.0, std::ceil(static_cast<double>(scene_.rows()) / ticks)));
  }

  bool any(bool Marks::*mark) const {
    return std::ranges::any_of(marks_, [&](const Marks& marks) { return marks.*mark; });
  }

  void draw_titles() {
    const double room = arrangement_.width - 2 * picture_margin;
    svg_.add_text({picture_margin, 28}, fitted(scene_.title, room, title_size), "t");
    svg_.add_text({picture_margin, 47}, fitted(scene_.subtitle, room, text_size), "u");
    bool named_time = false;
    for (const View& view : arrangement_.views) {
      if (view.name.empty() || (view.is_graph() && named_time)) continue;
      named_time = named_time || view.is_graph();
      const Box& box = view.is_graph() ? arrangement_.time_title : view.box;
      const double bottom = view.is_graph() ? box.top : box.bottom();
      svg_.add_text({box.left + box.width / 2, bottom + 34}, view.name, "n", "middle");
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
      const Marks& drawn = drawings[i].drawn();
      for (bool Marks::*mark : {&Marks::keys, &Marks::corners, &Marks::handles, &Marks::samples, &Marks::curve}) {
        shown_.*mark = shown_.*mark || drawn.*mark;
      }
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
  Marks shown_;               ///< in any view
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
