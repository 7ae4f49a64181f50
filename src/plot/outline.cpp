// Outlines: segments as exact Bezier curves in pixels, or many of them as a polyline within a quarter of a pixel.
//
// Three steps sum up to a quarter of a pixel: chords within 0.05 of the curve, vertices nearer than 0.1 to the previous
// one dropped, and the others thinned by 0.1.
#include "plot/outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tcb {
namespace {

constexpr double chord_error = 0.05, thinning = 0.1;

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

ThinnedOutline::ThinnedOutline(bool is_graph, double left, double width, std::size_t most_vertices)
    : is_graph_(is_graph),
      left_(left),
      column_width_(std::max(0.25, 4 * width / static_cast<double>(most_vertices))),
      most_(most_vertices) {}

void ThinnedOutline::add(const PixelSegment& segment) {
  if (!last_) add_vertex(segment.points[0]);
  each_vertex(segment, [this](const Pixel& at) { add_vertex(at); });
}

void ThinnedOutline::add_vertex(const Pixel& at) {
  last_ = at;
  if (is_graph_) return add_to_column(at);
  if (!vertices_.empty()) {
    const Pixel step = at - vertices_.back();
    if (step.x * step.x + step.y * step.y < nearest_ * nearest_) return;
  }
  vertices_.push_back(at);
  constexpr std::size_t spare = 16;
  if (vertices_.size() > spare * most_) halve();
}

/// Replaces the vertices between the first and the last of a column by the lowest and the highest.
void ThinnedOutline::add_to_column(const Pixel& at) {
  const double number = std::floor((at.x - left_) / column_width_);
  if (column_.empty() || number != column_number_) {
    end_column();
    column_number_ = number;
    column_.assign(4, at);
    return;
  }
  if (at.y < column_[1].y) column_[1] = at;
  if (at.y > column_[2].y) column_[2] = at;
  column_[3] = at;
}

void ThinnedOutline::end_column() {
  if (column_.empty()) return;
  if (column_[1].x > column_[2].x) std::swap(column_[1], column_[2]);
  for (const Pixel& at : std::exchange(column_, {})) {
    const bool repeats = !vertices_.empty() && vertices_.back().x == at.x && vertices_.back().y == at.y;
    if (!repeats) vertices_.push_back(at);
  }
}

/// Keeps of every 24 successive vertices the first and those with the extremes of x and y, so that no more than about
/// a fifth of randomly placed vertices remain.
void ThinnedOutline::halve() {
  constexpr std::size_t together = 24;
  std::vector<Pixel> kept;
  for (std::size_t begin = 0; begin < vertices_.size(); begin += together) {
    const std::size_t end = std::min(begin + together, vertices_.size());
    std::array<std::size_t, 5> chosen{begin, begin, begin, begin, begin};
    for (std::size_t i = begin; i < end; ++i) {
      if (vertices_[i].x < vertices_[chosen[1]].x) chosen[1] = i;
      if (vertices_[i].x > vertices_[chosen[2]].x) chosen[2] = i;
      if (vertices_[i].y < vertices_[chosen[3]].y) chosen[3] = i;
      if (vertices_[i].y > vertices_[chosen[4]].y) chosen[4] = i;
    }
    std::ranges::sort(chosen);
    const auto end_of_unique = std::unique(chosen.begin(), chosen.end());
    for (auto i = chosen.begin(); i != end_of_unique; ++i) kept.push_back(vertices_[*i]);
  }
  vertices_ = std::move(kept);
}

std::string ThinnedOutline::data() {
  end_column();
  if (!is_graph_ && last_) vertices_.push_back(*last_);
  std::vector<Pixel> all = thinned(vertices_, thinning);
  while (all.size() > most_ && !is_graph_ && most_ > 8) {
    vertices_ = std::move(all);
    halve();
    all = thinned(vertices_, thinning);
  }
  std::string data = all.empty() ? "" : "M";
  for (const Pixel& at : all) append_pixel(data, at);
  return data;
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
