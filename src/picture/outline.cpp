// Outlines: segments as exact Bezier curves in pixels; many of them as a polyline within a quarter of a pixel, or as
// the cells of half a pixel that they cross.
//
// Three errors of a polyline sum up to a quarter of a pixel: chords within 0.05 of the curve, vertices nearer than 0.1
// to the previous one dropped, and the others thinned by 0.1.
#include "picture/outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tcb {
namespace {

constexpr double chord_error = 0.05, least_step = 0.1, thinning = 0.1;

/// The side of a cell in pixels.
constexpr double cell_size = 0.5;

Pixel bezier(const std::array<Pixel, 4>& p, double u) {
  const double v = 1 - u;
  return v * v * v * p[0] + 3 * (v * v * u) * p[1] + 3 * (v * u * u) * p[2] + u * u * u * p[3];
}

/// The number of equal chords that stay within chord_error of the curve: its second derivative is at most 6 times the
/// larger second difference of its control points, and a chord errs by at most an eighth of that.
int chords(const std::array<Pixel, 4>& p) {
  double second = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Pixel difference = p[i] - 2 * p[i + 1] + p[i + 2];
    second = std::max(second, std::abs(difference.x) + std::abs(difference.y));
  }
  constexpr double most = 1000;
  const double number = std::ceil(std::sqrt(0.75 * second / chord_error));
  return static_cast<int>(std::clamp(number, 1.0, most));
}

double distance_to_chord(const Pixel& p, const Pixel& a, const Pixel& b) {
  const Pixel chord = b - a, to = p - a;
  const double length2 = chord.x * chord.x + chord.y * chord.y;
  const double along = length2 > 0 ? std::clamp((to.x * chord.x + to.y * chord.y) / length2, 0.0, 1.0) : 0.0;
  const Pixel gap = to - along * chord;
  return std::sqrt(gap.x * gap.x + gap.y * gap.y);
}

/// A segment with ease over time: the local parameter is warped.
Pixel eased(const PixelSegment& segment, double part) {
  const auto at = segment.warp.at(spline::DoubleDouble(part), spline::DoubleDouble(1 - part));
  const Pixel first = segment.points[0], last = segment.points[3];
  return {first.x + part * (last.x - first.x), bezier(segment.points, at.near_start() ? at.u : 1 + at.w).y};
}

/// Calls use(pixel) for vertices after the one at `low`, up to the one at `high`: halves until a chord is near the
/// curve at its quarters.
template <class Use>
void halve_eased(const PixelSegment& segment, double low, double high, int depth, const Use& use) {
  const Pixel a = eased(segment, low), b = eased(segment, high);
  double off = 0;
  for (const double part : {0.25, 0.5, 0.75}) {
    off = std::max(off, distance_to_chord(eased(segment, low + part * (high - low)), a, b));
  }
  if (depth >= 10 || (depth >= 3 && off < chord_error)) return use(b);
  const double middle = (low + high) / 2;
  halve_eased(segment, low, middle, depth + 1, use);
  halve_eased(segment, middle, high, depth + 1, use);
}

/// Calls use(pixel) for the vertices of a segment after its first.
template <class Use>
void each_vertex(const PixelSegment& segment, const Use& use) {
  if (segment.is_graph && !segment.warp.is_identity()) return halve_eased(segment, 0, 1, 0, use);
  const int number = chords(segment.points);
  for (int i = 1; i < number; ++i) use(bezier(segment.points, static_cast<double>(i) / number));
  use(segment.points[3]);
}

}  // namespace

void ExactOutline::add(const PixelSegment& segment) {
  if (data_.empty()) {
    data_ = "M";
    append_pixel(data_, segment.points[0]);
  }
  if (segment.is_graph && !segment.warp.is_identity()) {
    data_ += 'L';
    each_vertex(segment, [this](const Pixel& at) { append_pixel(data_, at); });
    return;
  }
  data_ += 'C';
  for (std::size_t i = 1; i < 4; ++i) append_pixel(data_, segment.points[i]);
}

CrossedCells::CrossedCells(const Box& box)
    : corner_{box.left - 1, box.top - 1},
      columns_(static_cast<std::size_t>((box.width + 2) / cell_size) + 1),
      rows_(static_cast<std::size_t>((box.height + 2) / cell_size) + 1, std::vector<bool>(columns_)) {}

void CrossedCells::add(const Pixel& at) {
  const auto index = [](double distance, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(distance / cell_size, 0.0, static_cast<double>(size - 1)));
  };
  rows_[index(at.y - corner_.y, rows_.size())][index(at.x - corner_.x, columns_)] = true;
}

void CrossedCells::add_line(const Pixel& from, const Pixel& to) {
  const Pixel step = to - from;
  const double steps = std::ceil(std::max(std::abs(step.x), std::abs(step.y)) / cell_size);
  for (double i = 0; i < steps; ++i) add(from + i / steps * step);
  add(to);
}

std::string CrossedCells::lines(bool along_rows) const {
  const std::size_t lines = along_rows ? rows_.size() : columns_, cells = along_rows ? columns_ : rows_.size();
  const auto is_crossed = [&](std::size_t line, std::size_t i) { return along_rows ? rows_[line][i] : rows_[i][line]; };
  std::string data;
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t i = 0; i < cells; ++i) {
      if (!is_crossed(line, i)) continue;
      const std::size_t first = i;
      while (i + 1 < cells && is_crossed(line, i + 1)) ++i;
      const double begin = static_cast<double>(first), middle = static_cast<double>(line) + 0.5;
      data += 'M';
      append_pixel(data, corner_ + cell_size * (along_rows ? Pixel{begin, middle} : Pixel{middle, begin}));
      data += along_rows ? 'h' : 'v';
      append_pixels(data, cell_size * static_cast<double>(i + 1 - first));
    }
  }
  return data;
}

std::string CrossedCells::data() const {
  std::string along_rows = lines(true), along_columns = lines(false);
  return along_rows.size() < along_columns.size() ? along_rows : along_columns;
}

void ThinnedOutline::add(const PixelSegment& segment) {
  if (!last_) add_vertex(segment.points[0]);
  each_vertex(segment, [this](const Pixel& at) { add_vertex(at); });
}

void ThinnedOutline::add_vertex(const Pixel& at) {
  const std::optional<Pixel> before = std::exchange(last_, at);
  if (cells_) return cells_->add_line(*before, at);
  if (!vertices_.empty()) {
    const Pixel step = at - vertices_.back();
    if (step.x * step.x + step.y * step.y < least_step * least_step) return;
  }
  vertices_.push_back(at);
  if (vertices_.size() <= most_vertices) return;
  cells_ = cells_of(vertices_);
  vertices_ = {};
}

CrossedCells ThinnedOutline::cells_of(const std::vector<Pixel>& vertices) const {
  CrossedCells cells(box_);
  for (std::size_t i = 1; i < vertices.size(); ++i) cells.add_line(vertices[i - 1], vertices[i]);
  return cells;
}

OutlinePath ThinnedOutline::path() {
  constexpr std::string_view of_cells = "s";  // the class of thin lines, which are never dashed
  if (cells_) return {cells_->data(), of_cells};
  if (last_) vertices_.push_back(*last_);
  std::string polyline = vertices_.empty() ? "" : "M";
  for (const Pixel& at : thinned(vertices_, thinning)) append_pixel(polyline, at);
  constexpr std::size_t small = 50000;  // bytes
  if (polyline.size() < small) return {std::move(polyline)};
  std::string cells = cells_of(vertices_).data();
  if (cells.size() < polyline.size()) return {std::move(cells), of_cells};
  return {std::move(polyline)};
}

std::vector<Pixel> thinned(const std::vector<Pixel>& vertices, double distance) {
  if (vertices.size() < 3) return vertices;
  std::vector<bool> kept(vertices.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, vertices.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = distance;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_to_chord(vertices[i], vertices[first], vertices[last]);
      if (off > most) {
        most = off;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.push_back({first, farthest});
    open.push_back({farthest, last});
  }
  std::vector<Pixel> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (kept[i]) result.push_back(vertices[i]);
  }
  return result;
}

}  // namespace tcb
