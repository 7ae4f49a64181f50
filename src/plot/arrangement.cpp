// Arrangement: the size of a picture, and the boxes of its views.
#include "plot/arrangement.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "option_names.hpp"
#include "plot/errors.hpp"

namespace tcb {
namespace {

constexpr double top = 62, heading = 22, below_axis = 40, gap_between = 18;
constexpr double path_width = 470, strip_width = 520, narrow_strip = 230;
constexpr double least_width = 40, least_height = 28;
constexpr std::size_t strips_in_column = 10, most_columns = 6;

std::size_t columns_of(const Scene& scene) {
  return std::clamp<std::size_t>((scene.strip_count() + strips_in_column - 1) / strips_in_column, 1, most_columns);
}

/// The title of an axis; a name that is too long is cut, the base is not.
std::string title_within(const Axis& axis, const std::string& name, double width) {
  return axis.title(fitted(name, width - text_width(axis.title(""), bold_size), bold_size));
}

class Arranger {
 public:
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
    if (!has_room) throw picture_too_small(strips_);
  }

  /// The path, with equal scales. Returns its right end.
  double place_path() {
    View view{{}, (*scene_.path)[0], (*scene_.path)[1], Axis(extent_.path[0], 0.05), Axis(extent_.path[1], 0.05)};
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
    result_.frames.push_back({title_within(view.y, scene_.channels[view.up], view.box.width),
                              name.empty() ? "" : title_within(view.x, name, room)});
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

}  // namespace

double picture_width(const Scene& scene, const PictureSize& size) {
  if (size.width > 0) return size.width;
  const std::size_t columns = columns_of(scene);
  const double strips = columns == 1 ? strip_width : static_cast<double>(columns) * narrow_strip;
  return 2 * picture_margin + strips + (scene.path ? path_width : columns == 1 ? 200 : 0);
}

Arrangement arranged(const Scene& scene, const SceneExtent& extent, const PictureSize& size, double legend_height) {
  return Arranger(scene, extent, size, legend_height).arrange();
}

}  // namespace tcb
