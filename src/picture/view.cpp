// Views: two axes in a box of the picture, one for time or a channel to the right and one for a channel up.
#include "picture/view.hpp"

#include <algorithm>
#include <cmath>

#include "tcb/spline/rotation_notation.hpp"

namespace tcb {
namespace {

double length(const Pixel& a) { return std::sqrt(a.x * a.x + a.y * a.y); }

/// The first of some differences that is not zero.
Pixel first_direction(std::initializer_list<Pixel> differences) {
  for (const Pixel& difference : differences) {
    if (difference.x != 0 || difference.y != 0) return difference;
  }
  return {};
}

/// The tangents of a segment at its ends, divided by 3 as for a Bezier curve. In a graph they are by time.
std::pair<Pixel, Pixel> tangents(const PixelSegment& segment) {
  const auto& [a, b, c, d] = segment.points;
  Pixel out = b - a, in = d - c;
  if (segment.is_graph) {
    out.y *= segment.warp.first_derivative(0);
    in.y *= segment.warp.first_derivative(1);
  }
  return {out, in};
}

/// A short line across a curve at a sample.
void append_tick(std::string& data, const Pixel& at, const Pixel& direction) {
  const double size = length(direction);
  const Pixel across =
      size > 0 && std::isfinite(size) ? half_tick / size * Pixel{-direction.y, direction.x} : Pixel{0, half_tick};
  data += 'M';
  append_pixel(data, at - across);
  data += 'l';
  append_pixel(data, 2.0 * across);
}

bool is_finite(const Pixel& at) { return std::isfinite(at.x) && std::isfinite(at.y); }

/// The ticks of an axis whose numbers have room in `pixels`.
std::vector<Tick> ticks_with_room(const Axis& axis, double pixels, bool is_upward) {
  constexpr double line = 22, gap = 18;
  if (is_upward) return axis.ticks(std::max(2.0, pixels / line + 1));
  double most = std::max(2.0, pixels / 50 + 1);
  for (;; most -= 1) {
    std::vector<Tick> ticks = axis.ticks(most);
    double widest = 0;
    for (const Tick& tick : ticks) widest = std::max(widest, text_width(tick.text, small_size));
    const double apart = (ticks[1].value - ticks[0].value) / axis.length() * pixels;
    if (apart >= widest + gap || most <= 3) return ticks;
  }
}

}  // namespace

Pixel View::at(const Time& t, std::span<const double> position) const {
  const double to_right = x.from_base(right ? Time(position[*right]) : t) - x.low();
  const double upward = y.from_base(Time(position[up])) - y.low();
  return {box.left + to_right * x_scale(), box.bottom() - upward * y_scale()};
}

Pixel View::direction(std::span<const double> velocity) const {
  return {x_scale() * x.in_units(right ? velocity[*right] : 1), -y_scale() * y.in_units(velocity[up])};
}

PixelSegment View::segment(const spline::Segments<double>& segments, std::size_t i) const {
  const auto cubics = segments[i];
  const auto& vertical = cubics[up];
  const auto bottom = [&](double value) { return box.bottom() - (y.from_base(Time(value)) - y.low()) * y_scale(); };
  const auto left = [&](const Time& value) { return box.left + (x.from_base(value) - x.low()) * x_scale(); };
  PixelSegment result;
  double x0 = 0, x3 = 0, out = 0, in = 0;
  if (right) {
    const auto& horizontal = cubics[*right];
    x0 = left(Time(horizontal.p0));
    x3 = left(Time(horizontal.p1));
    out = x.in_units(horizontal.out) * x_scale();
    in = x.in_units(horizontal.in) * x_scale();
  } else {
    x0 = left(segments.times[i]);
    x3 = left(segments.times[i + 1]);
    out = in = x3 - x0;
    result.warp = segments.warp(i);
    result.is_graph = true;
  }
  const double y0 = bottom(vertical.p0), y3 = bottom(vertical.p1);
  result.points = {Pixel{x0, y0}, Pixel{x0 + out / 3, y0 - y.in_units(vertical.out) * y_scale() / 3},
                   Pixel{x3 - in / 3, y3 + y.in_units(vertical.in) * y_scale() / 3}, Pixel{x3, y3}};
  return result;
}

double width_of_numbers(const Axis& axis, double pixels) {
  double widest = 0;
  for (const Tick& tick : ticks_with_room(axis, pixels, true)) {
    widest = std::max(widest, text_width(tick.text, small_size));
  }
  return widest + 6;
}

void draw_frame(Svg& svg, const View& view) {
  const Box& box = view.box;
  constexpr double half_height = 4, below = 17, above = 6, line_of_numbers = 14;
  std::string grid;
  double last = box.bottom() + line_of_numbers;
  for (const Tick& tick : ticks_with_room(view.y, box.height, true)) {
    const double at = box.bottom() - (tick.value - view.y.low()) * view.y_scale();
    grid += 'M';
    append_pixel(grid, {box.left, at});
    grid += 'h';
    append_pixels(grid, box.width);
    if (last - at < line_of_numbers) continue;
    svg.add_text({box.left - 5, at + half_height}, tick.text, "v", "end");
    last = at;
  }
  for (const Tick& tick : ticks_with_room(view.x, box.width, false)) {
    const double at = box.left + (tick.value - view.x.low()) * view.x_scale();
    grid += 'M';
    append_pixel(grid, {at, box.top});
    grid += 'v';
    append_pixels(grid, box.height);
    if (view.name.empty()) continue;
    const double half = text_width(tick.text, small_size) / 2;
    const bool before = at - half<box.left, after = at + half> box.right();
    const double place = before ? box.left : after ? box.right() : at;
    svg.add_text({place, box.bottom() + below}, tick.text, "v", before ? "start" : after ? "end" : "middle");
  }
  svg.add_path(grid, "g");
  svg.add_box(box, "f");
  svg.add_text({box.left, box.top - above}, view.heading, "n");
}

void AxesDrawing::add(const spline::Segments<double>& segments) {
  if (!frame_) return;
  constexpr double axis_length = 15;
  for (; next_ < segments.size(); next_ += between_) {
    const auto cubics = segments[next_];
    const auto number = [&](std::size_t i) { return cubics[frame_->rotation[i]].p0; };
    const auto matrix = spline::matrix_of(spline::Quaternion<double>{number(0), number(1), number(2), number(3)});
    const Pixel origin = view_.segment(segments, next_).points[0];
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      axes_[axis] += 'M';
      append_pixel(axes_[axis], origin);
      axes_[axis] += 'l';
      append_pixel(axes_[axis],
                   axis_length * Pixel{matrix[3 * frame_->axes[0] + axis], -matrix[3 * frame_->axes[1] + axis]});
    }
  }
  next_ -= segments.size();
}

void AxesDrawing::draw(Svg& svg) const {
  constexpr std::array classes{"ax", "ay", "az"};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (!axes_[axis].empty()) svg.add_path(axes_[axis], classes[axis]);
  }
}

bool is_corner(const Pixel& incoming, const Pixel& outgoing) {
  constexpr double sine = 0.005;
  const double sizes = length(incoming) * length(outgoing);
  const double cross = incoming.x * outgoing.y - incoming.y * outgoing.x;
  return std::abs(cross) > sine * sizes || incoming.x * outgoing.x + incoming.y * outgoing.y < 0;
}

void CurveDrawing::add(const spline::Segments<double>& segments, std::size_t i) {
  const PixelSegment segment = view_.segment(segments, i);
  outline_->add(segment);
  if (!marks_.keys) return;
  const auto [out, in] = tangents(segment);
  const auto& [a, b, c, d] = segment.points;
  const Pixel outgoing = first_direction({out, c - a, d - a});
  corners_.push_back(incoming_ && is_corner(*incoming_, outgoing));
  const bool rests = length(outgoing) == 0;  // a hold has no direction; the one before it counts at its end
  if (!first_ && !rests) first_ = outgoing;
  if (!rests) incoming_ = first_direction({in, d - b, d - a});
  if (marks_.handles) add_handles(segment, out, in);
}

void CurveDrawing::add_handles(const PixelSegment& segment, const Pixel& out, const Pixel& in) {
  const Pixel starts[] = {segment.points[0], segment.points[3]}, ends[] = {out, -1.0 * in};
  for (const std::size_t i : {0U, 1U}) {
    if (length(ends[i]) < 0.5) continue;
    handles_ += 'M';
    append_pixel(handles_, starts[i]);
    handles_ += 'l';
    append_pixel(handles_, ends[i]);
  }
}

void CurveDrawing::draw(Svg& svg, const SceneCurve& curve, const Keys& keys) {
  if (!handles_.empty()) svg.add_path(handles_, "h");
  drawn_.handles = !handles_.empty();
  const bool is_dotted = marks_.keys && view_.up < curve.dotted;
  if (const OutlinePath path = outline_->path(); !path.data.empty() && !is_dotted) {
    svg.add_path(path.data, path.css);
    drawn_.curve = true;
  }
  std::string ticks;
  for (std::size_t i = 0; marks_.samples && i < curve.samples.size(); i += marks_.sample_stride) {
    const SceneSample& sample = curve.samples[i];
    append_tick(ticks, view_.at(sample.t, sample.position), view_.direction(sample.velocity));
  }
  if (!ticks.empty()) svg.add_path(ticks, "s");
  drawn_.samples = !ticks.empty();
  if (!marks_.keys) return;
  if (curve.closed && first_ && incoming_ && !corners_.empty()) corners_[0] = is_corner(*incoming_, *first_);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Pixel at = view_.at(keys.times[i], keys.position(i));
    if (!is_finite(at)) continue;  // the channel has no position here
    const bool corner = !curve.is_polyline && i < corners_.size() && corners_[i];
    drawn_.keys = drawn_.keys || !curve.is_polyline;
    drawn_.corners = drawn_.corners || corner;
    svg.add_circle(at, curve.is_polyline ? sample_radius : key_radius, corner ? "q" : "k");
  }
}

}  // namespace tcb
