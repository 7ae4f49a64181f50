// Picture: the layout of views, their curves, titles and the legend of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "error.hpp"
#include "picture/scene.hpp"
#include "picture/svg.hpp"
#include "picture/view.hpp"

namespace tcb {
namespace {

constexpr double margin = 16, top = 62, line_height = 20, heading = 26, below_axis = 40, gap = 22;
constexpr double path_width = 400, strip_width = 460, narrow_strip = 170;
constexpr double least_width = 60, least_height = 24;
constexpr std::size_t strips_in_column = 10;

/// The size of the picture, and of the boxes of its views.
struct Arrangement {
  double width = 0, height = 0;
  std::size_t columns = 1, rows = 1;  ///< of strips
  double strip_height = 0;
};

/// The size in bytes that a picture has at most, a little less than 300 kB.
constexpr std::size_t most_bytes = 290000;

/// How many bytes an element has, about.
constexpr std::size_t bytes_of_vertex = 13, bytes_of_segment = 42, bytes_of_key = 48, bytes_of_tick = 26;

class Composer {
 public:
  Composer(const Scene& scene, const PictureSize& size) : scene_(scene), extent_(extent_of(scene)) {
    arrange(size);
    place_views();
    choose_marks();
  }

  std::string draw() {
    svg_.begin(size_.width, size_.height, scene_.title + ". " + scene_.subtitle);
    const double room = size_.width - 2 * margin;
    svg_.add_text({margin, 28}, fitted(scene_.title, room, title_size * 1.1), "t");
    svg_.add_text({margin, 47}, fitted(scene_.subtitle, room, text_size), "u");
    draw_frames();
    draw_legend();
    for (const SceneCurve& curve : scene_.curves) draw_curve(curve);
    svg_.end();
    return svg_.text();
  }

 private:
  std::size_t strips() const { return scene_.channels.size(); }
  bool is_drawn_by_name() const { return scene_.names.size() > 1; }

  // Layout

  void arrange(const PictureSize& size) {
    size_.columns = (strips() + strips_in_column - 1) / strips_in_column;
    if (size.height > 0) {
      const double room = size.height - top - below_axis - line_height - margin;
      const double in_column = std::max(1.0, std::floor((room + gap) / (least_height + heading)));
      size_.columns = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(static_cast<double>(strips()) / in_column)));
    }
    size_.rows = (strips() + size_.columns - 1) / size_.columns;
    const double wide = size_.columns == 1 ? strip_width + 60 : narrow_strip + 60;
    const double path = scene_.path ? path_width + 70 : size_.columns == 1 ? 200 : 0;
    size_.width =
        size.width > 0 ? size.width : std::floor(path + static_cast<double>(size_.columns) * wide + 2 * margin);
    lay_legend();
    const double around = top + heading + below_axis + legend_height_;
    const double between = static_cast<double>(size_.rows - 1) * heading;
    const double strip = std::clamp(std::floor(380.0 / static_cast<double>(size_.rows)) - heading, 56.0, 360.0);
    size_.height = size.height > 0 ? size.height : around + between + static_cast<double>(size_.rows) * strip;
    size_.strip_height = (size_.height - around - between) / static_cast<double>(size_.rows);
    if (size_.strip_height < least_height) refuse();
  }

  [[noreturn]] void refuse() const {
    throw Error(Exit::usage, ErrorCode::picture_too_small, {std::uint64_t{strips()}}).about(Option::size);
  }

  void place_views() {
    double left = margin;
    const double bottom = size_.height - below_axis - legend_height_;
    if (scene_.path) left = place_path(bottom) + margin + 6;
    const double room = (size_.width - margin - left) / static_cast<double>(size_.columns);
    for (std::size_t column = 0; column < size_.columns; ++column) {
      place_strips(column, left + static_cast<double>(column) * room, room);
    }
  }

  /// The path to the left, with equal scales. Returns its right end.
  double place_path(double bottom) {
    View view{{}, (*scene_.path)[0], (*scene_.path)[1], Axis(extent_.path[0], 0.05), Axis(extent_.path[1], 0.05)};
    Box& box = view.box;
    box.top = top + heading;
    const double strips_width = static_cast<double>(size_.columns) * (narrow_strip + 60);
    const double most =
        size_.columns == 1 ? (size_.width - 2 * margin) * 0.48 : size_.width - 2 * margin - strips_width;
    box.height = std::min(bottom - box.top, std::max(most * 1.1, 120.0));
    box.left = margin + width_of_numbers(view.y, box.height) + 4;
    box.width = margin + most - box.left;
    if (box.width < least_width) refuse();
    const double scale = std::min(box.width / view.x.length(), box.height / view.y.length());
    view.x.set_length(box.width / scale);
    view.y.set_length(box.height / scale);
    frames_.push_back({view.y.title(scene_.channels[view.up]), view.x.title(scene_.channels[*view.right]), box.width});
    const double right = box.right();
    views_.push_back(std::move(view));
    return right;
  }

  void place_strips(std::size_t column, double left, double room) {
    const std::size_t begin = column * size_.rows, end = std::min(begin + size_.rows, strips());
    double numbers = 0;
    std::vector<View> strips;
    for (std::size_t channel = begin; channel < end; ++channel) {
      View view{{}, {}, channel, Axis(extent_.time, 0), Axis(extent_.channels[channel], 0.06)};
      numbers = std::max(numbers, width_of_numbers(view.y, size_.strip_height));
      strips.push_back(std::move(view));
    }
    for (std::size_t i = 0; i < strips.size(); ++i) {
      View& view = strips[i];
      view.box = {left + numbers, top + heading + static_cast<double>(i) * (size_.strip_height + heading),
                  room - numbers - gap, size_.strip_height};
      if (view.box.width < least_width) refuse();
      const bool is_last = i + 1 == strips.size();
      frames_.push_back(
          {view.y.title(scene_.channels[view.up]), is_last ? view.x.title(scene_.time) : "", view.box.width});
      views_.push_back(std::move(view));
    }
  }

  // Marks

  void choose_marks() {
    const auto curves = scene_.curves.size();
    const std::uint64_t keys = scene_.keys(), rows = scene_.rows();
    bool all_samples = true;
    for (const SceneCurve& curve : scene_.curves) all_samples = all_samples && curve.samples.size() == curve.rows;
    constexpr double between_keys = 4, between_samples = 3;
    for (const View& view : views_) {
      const double room = view.is_graph() ? view.box.width : 3 * view.box.width;
      Marks marks;
      marks.keys = static_cast<double>(keys) * between_keys <= room && keys * views_.size() <= most_dots;
      marks.handles = marks.keys && (!view.is_graph() || !scene_.path);
      marks.samples = all_samples && rows > 0 && static_cast<double>(rows) * between_samples <= room &&
                      rows * views_.size() <= most_dots;
      marks_.push_back(marks);
    }
    (void)curves;
  }

  bool any(bool Marks::*mark) const {
    return std::ranges::any_of(marks_, [&](const Marks& marks) { return marks.*mark; });
  }

  /// How many bytes are left for each outline.
  std::size_t bytes_for_outlines() const {
    std::size_t others = svg_.size() + scene_.curves.size() * 40;
    for (const Marks& marks : marks_) {
      others += marks.keys ? scene_.keys() * (bytes_of_key + (marks.handles ? 2 * bytes_of_tick : 0)) : 0;
      others += marks.samples ? scene_.rows() * bytes_of_tick : 0;
    }
    return others < most_bytes ? most_bytes - others : 0;
  }

  std::unique_ptr<Outline> outline_of(const View& view) const {
    const std::size_t bytes = bytes_for_outlines_ / views_.size();
    if (extent_.segments * bytes_of_segment <= bytes) return std::make_unique<ExactOutline>();
    const std::size_t vertices = bytes / bytes_of_vertex / std::max<std::size_t>(scene_.curves.size(), 1);
    return std::make_unique<ThinnedOutline>(view.is_graph(), view.box.left, view.box.width,
                                            std::max<std::size_t>(vertices, 4));
  }

  // Drawing

  void draw_frames() {
    for (std::size_t i = 0; i < views_.size(); ++i) {
      draw_frame(svg_, views_[i], frames_[i]);
      if (frames_[i].name.empty() || (i > 0 && views_[i].is_graph() && named_time_)) continue;
      const Box& box = views_[i].box;
      const bool graphs = views_[i].is_graph();
      const double width = graphs ? size_.width - margin - box.left - gap : box.width;
      const std::string name = fitted(frames_[i].name, width, text_size * 1.1);
      svg_.add_text({box.left + width / 2, box.bottom() + 34}, name, "n", "middle");
      named_time_ = named_time_ || graphs;
    }
    bytes_for_outlines_ = bytes_for_outlines();
  }

  void draw_curve(const SceneCurve& curve) {
    std::vector<CurveDrawing> drawings;
    for (std::size_t i = 0; i < views_.size(); ++i) drawings.emplace_back(views_[i], marks_[i], outline_of(views_[i]));
    const Source<SegmentBlock> blocks = curve.segments();
    while (const std::optional<SegmentBlock> block = blocks()) {
      for (std::size_t i = 0; i < block->segments.size(); ++i) {
        for (CurveDrawing& drawing : drawings) drawing.add(block->segments, i);
      }
    }
    Keys keys;
    const Source<Keys> stored = curve.keys.source();
    while (any(&Marks::keys)) {
      const std::optional<Keys> more = stored();
      if (!more) break;
      spline::append(keys, *more, 0, more->size());
    }
    svg_.begin_group(css_of(curve.name));
    for (CurveDrawing& drawing : drawings) drawing.draw(svg_, curve, keys);
    svg_.end_group();
  }

  static std::string css_of(std::size_t name) {
    const std::size_t dashes = name / colours % 3;
    return fmt::format("c{}{}", name % colours, dashes == 0 ? "" : fmt::format(" d{}", dashes));
  }

  // Legend

  struct Entry {
    Pixel at;  ///< where it begins, from the legend's left upper corner
    std::string text;
    std::optional<std::size_t> name;
  };

  /// Names of curves, in lines; two lines at most.
  void lay_legend() {
    constexpr double mark = 30, between = 16, lines = 2;
    double x = 0, y = 0;
    for (std::size_t i = 0; is_drawn_by_name() && i < scene_.names.size(); ++i) {
      const std::string more = fmt::format("and {} more", scene_.names.size() - i);
      const std::string text = fitted(scene_.names[i], 180, text_size);
      const double width = mark + text_width(text, text_size) + between;
      const double room = size_.width - 2 * margin - (y + line_height >= lines * line_height ? 130 : 0);
      if (x > 0 && x + width > room) {
        if (y + line_height >= lines * line_height) {
          legend_.push_back({{x, y}, more, {}});
          break;
        }
        x = 0;
        y += line_height;
      }
      legend_.push_back({{x, y}, text, i});
      x += width;
    }
    legend_height_ = margin / 2 + line_height + (is_drawn_by_name() ? y + line_height : 0);
  }

  void draw_legend() {
    const double base = size_.height - legend_height_ + line_height / 2 + 2;
    draw_marks({margin, base});
    for (const Entry& entry : legend_) {
      const Pixel at = Pixel{margin, base + line_height} + entry.at;
      if (entry.name) {
        svg_.begin_group(css_of(*entry.name));
        std::string line = "M";
        append_pixel(line, at);
        svg_.add_path(line + "h22", "l");
        svg_.end_group();
      }
      svg_.add_text(at + Pixel{entry.name ? 28.0 : 0.0, 4}, entry.text, "u");
    }
  }

  /// What the marks mean.
  void draw_marks(Pixel at) {
    const auto words = [&](std::string_view text) {
      svg_.add_text(at + Pixel{28, 4}, text, "u");
      at.x += 28 + text_width(text, text_size) + margin;
    };
    const auto line = [&](const Pixel& from, std::string_view rest, std::string_view css) {
      std::string data = "M";
      append_pixel(data, from);
      svg_.add_path(data + std::string(rest), css);
    };
    svg_.begin_group("c5");
    line(at, "h22", "l");
    words("curve");
    if (any(&Marks::keys)) {
      svg_.add_circle(at + Pixel{11, 0}, 3.2, "k");
      words("key");
      svg_.add_circle(at + Pixel{11, 0}, 3.2, "q");
      words("key at a corner");
    }
    if (any(&Marks::handles)) {
      line(at, "h22", "h");
      words("tangents / 3");
    }
    if (any(&Marks::samples)) {
      line(at + Pixel{11, -4}, "v8", "s");
      words("sample");
    }
    svg_.end_group();
  }

  static constexpr std::uint64_t most_dots = 1200;

  const Scene& scene_;
  const SceneExtent extent_;
  Arrangement size_;
  std::vector<View> views_;
  std::vector<ViewFrame> frames_;
  std::vector<Marks> marks_;
  std::vector<Entry> legend_;
  double legend_height_ = 0;
  std::size_t bytes_for_outlines_ = 0;
  bool named_time_ = false;
  Svg svg_;
};

}  // namespace

std::string picture(const Scene& scene, const PictureSize& size) { return Composer(scene, size).draw(); }

}  // namespace tcb
