// Tolerance: few rows whose polyline stays near the curve, by a greedy search.
//
// From each row the next one is taken as far along as the chord between them keeps every point of the curve
// within the tolerance. The points within D of a chord form a convex set, so a part of the curve lies in it
// if its Bezier control points do; parts that are not decided so are halved. That is a bound, not a sample.
// A row between keys is where its time is printed, if rounding that matters.
// A rotation is tried at places of each segment against the arc between the rows at equal times.
// With a single metric channel the polyline is its graph over time, and the distance is taken at equal times.

#include "sample/tolerance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "error.hpp"
#include "option_names.hpp"
#include "sample/errors.hpp"
#include "sample/grid.hpp"
#include "sample/least_rows.hpp"
#include "sample/turn_chord.hpp"

namespace tcb {
namespace {

using Position = std::vector<double>;

/// A point of the curve.
struct Vertex {
  std::uint64_t segment = 0;
  double u = 0;
  Time t;
  Position x;
};

std::size_t metric_size(const CurveSegment& segment) {
  return segment.metric.empty() ? segment.cubics.size() : segment.metric.size();
}

const spline::Cubic<double>& metric_cubic(const CurveSegment& segment, std::size_t i) {
  return segment.cubics[segment.metric.empty() ? i : segment.metric[i]];
}

/// The chord between two points of the curve, and whether other points are near it.
class Chord {
 public:
  Chord(const Vertex& from, const Vertex& to, double tolerance)
      : from_(from), to_(to), limit_(tolerance * (1 - 1e-9)), is_graph_(from.x.size() == 1) {
    for (std::size_t i = 0; i < from.x.size(); ++i) length2_ += (to.x[i] - from.x[i]) * (to.x[i] - from.x[i]);
  }

  /// The point x is near the chord; in a graph, near it at every time between t0 and t1.
  bool is_near(std::span<const double> x, const Time& t0, const Time& t1) const {
    if (is_graph_) return std::abs(x[0] - height(t0)) <= limit_ && std::abs(x[0] - height(t1)) <= limit_;
    double along = 0;
    for (std::size_t i = 0; i < x.size(); ++i) along += (x[i] - from_.x[i]) * (to_.x[i] - from_.x[i]);
    const double part = length2_ > 0 ? std::clamp(along / length2_, 0.0, 1.0) : 0.0;
    double distance2 = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double gap = x[i] - (from_.x[i] + part * (to_.x[i] - from_.x[i]));
      distance2 += gap * gap;
    }
    return distance2 <= limit_ * limit_;
  }

 private:
  double height(const Time& t) const {
    const double part = to_.t == from_.t ? 0 : ((t - from_.t) / (to_.t - from_.t)).hi;
    return from_.x[0] + part * (to_.x[0] - from_.x[0]);
  }

  const Vertex& from_;
  const Vertex& to_;
  double limit_;
  bool is_graph_;
  double length2_ = 0;
};

/// Finds row after row along a curve.
class Walker {
 public:
  Walker(const ShownCurve& curve, const CurveTolerance& tolerance, bool at_keys)
      : curve_(curve),
        tolerance_(tolerance.distance),
        angle_(tolerance.angle * 0.99),
        limits_distance_(tolerance.limits_distance()),
        limits_angle_(tolerance.limits_angle()),
        at_keys_(at_keys) {}

  Vertex start() const { return at(0, 0); }

  /// The next row: the farthest place that a chord from here may reach. Where keys between them are rows as well, the
  /// chords by these keys are near the curve, too.
  Vertex next(const Vertex& from) {
    const Vertex far = farthest(from, next_corner(from));
    return at_keys_ && !reaches_by_keys(from, far) ? farthest(from, next_key(from)) : far;
  }

  bool is_end(const Vertex& place) const { return place.segment + 1 == curve_.size() && place.u == 1; }

 private:
  /// The farthest place that a chord from here may reach, up to the key `corner`.
  Vertex farthest(const Vertex& from, std::uint64_t corner) const {
    std::uint64_t good = from.segment, step = 1;  // the keys that end the segments before `good` can be reached
    while (good < corner && reaches(from, key(std::min(good + step, corner)))) {
      good = std::min(good + step, corner);
      step *= 2;
    }
    for (step /= 2; step > 0; step /= 2) {
      if (good + step < corner && reaches(from, key(good + step))) good += step;
    }
    if (good == corner) return key(corner);
    return within(from, good);
  }

  Vertex at(std::uint64_t number, double u) const {
    const CurveSegment segment = curve_.segment(number);
    Vertex place{number, u, u == 0 ? segment.start : u == 1 ? segment.end : time_of(segment, u), {}};
    for (std::size_t i = 0; i < metric_size(segment); ++i) {
      place.x.push_back(spline::position(metric_cubic(segment, i), {u, u - 1}));
    }
    return u == 0 || u == 1 ? place : printed(segment, place);
  }

  /// The place at the time that its row prints, where rounding that moves it by more than limits allow for.
  Vertex printed(const CurveSegment& segment, const Vertex& place) const {
    Vertex moved{place.segment, 0, rounded_time(place.t, segment.decimals), {}};
    const auto at = segment.time_map()(segment.precise(std::clamp(moved.t, segment.start, segment.end)));
    moved.u = at.u;
    double distance = 0;
    for (std::size_t i = 0; i < place.x.size(); ++i) {
      moved.x.push_back(spline::position(metric_cubic(segment, i), at));
      distance = std::max(distance, std::abs(moved.x[i] - place.x[i]));
    }
    return distance > tolerance_ * 1e-10 ? moved : place;
  }

  /// The key with this number, as the end of the segment before it.
  Vertex key(std::uint64_t number) const { return at(number - 1, 1); }

  /// The farthest place on a segment, whose own end is out of reach.
  Vertex within(const Vertex& from, std::uint64_t number) const {
    double low = number == from.segment ? from.u : 0;
    double high = 1;
    for (int halving = 0; halving < 48; ++halving) {
      const double middle = (low + high) / 2;
      (reaches(from, at(number, middle)) ? low : high) = middle;
    }
    Vertex reached = low == 0 && number > 0 ? key(number) : at(number, low);
    if (number == from.segment && reached.u <= from.u) {
      throw tolerance_too_small().about(option::tolerance);
    }
    return reached;
  }

  /// The chord between the two places is near the curve between them.
  bool reaches(const Vertex& from, const Vertex& to) const {
    const Chord chord(from, to, tolerance_);
    std::optional<TurnChord> turns;
    if (limits_angle_) turns.emplace(turn_place(from), turn_place(to), angle_);
    for (std::uint64_t number = from.segment; number <= to.segment; ++number) {
      const double low = number == from.segment ? from.u : 0;
      const double high = number == to.segment ? to.u : 1;
      const CurveSegment segment = curve_.segment(number);
      Effort effort = effort_for(segment);
      if (low >= high) continue;
      if (limits_distance_ && !is_near(chord, segment, low, high, effort.depth, effort.parts)) return false;
      if (turns && !turns->is_near(segment, low, high)) return false;
    }
    return true;
  }

  TurnPlace turn_place(const Vertex& place) const {
    return {curve_.segment(place.segment), {place.u, place.u - 1}, place.t};
  }

  /// The chords from key to key between two places are near the curve.
  bool reaches_by_keys(Vertex from, const Vertex& to) const {
    for (std::uint64_t number = next_key(from); number <= to.segment; ++number) {
      const Vertex end = key(number);
      if (!reaches(from, end)) return false;
      from = end;
    }
    return reaches(from, to);
  }

  /// How often parts of a segment are halved, and how many are tried with one chord. A cubic comes near the limit at a
  /// few places only; with ease, the bound on a graph tightens slowly. What is not decided by then counts as too far.
  /// Where positions are rounded by more than the tolerance, halving decides nothing.
  struct Effort {
    int depth, parts;
  };
  Effort effort_for(const CurveSegment& segment) const {
    double size = 0;
    for (std::size_t i = 0; i < metric_size(segment); ++i) {
      const auto& x = metric_cubic(segment, i);
      size = std::max({size, std::abs(x.p0), std::abs(x.p1)});
    }
    if (tolerance_ < size * 0x1p-53) return {0, 1};
    return segment.warp.is_identity() ? Effort{40, 1 << 10} : Effort{16, 1 << 14};
  }

  /// The segment between two local parameters is near the chord, so its control points are, or those of its halves; as
  /// far as `parts` parts decide that.
  bool is_near(const Chord& chord, const CurveSegment& segment, double low, double high, int depth, int& parts) const {
    const Local at_low{low, low - 1};
    const Local at_high{high, high - 1};
    const double third = (high - low) / 3;
    const std::size_t size = metric_size(segment);
    std::array<Position, 4> points;
    for (auto& point : points) point.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      const auto& x = metric_cubic(segment, i);
      points[0][i] = spline::position(x, at_low);
      points[3][i] = spline::position(x, at_high);
      points[1][i] = points[0][i] + third * spline::first_derivative(x, at_low);
      points[2][i] = points[3][i] - third * spline::first_derivative(x, at_high);
    }
    const Time t0 = time_of(segment, low);
    const Time t3 = time_of(segment, high);
    if (!chord.is_near(points[0], t0, t0) || !chord.is_near(points[3], t3, t3)) return false;
    if (control_points_are_near(chord, segment, points, t0, t3)) return true;
    if (depth == 0 || --parts <= 0) return false;
    const double middle = (low + high) / 2;
    return is_near(chord, segment, low, middle, depth - 1, parts) &&
           is_near(chord, segment, middle, high, depth - 1, parts);
  }

  /// Without ease, time is linear along the segment, so control point k has its own time.
  static bool control_points_are_near(const Chord& chord, const CurveSegment& segment,
                                      const std::array<Position, 4>& points, const Time& t0, const Time& t3) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Time t = t0 + (t3 - t0) * Time(static_cast<double>(k)) / Time(3);
      const bool own_time = segment.warp.is_identity();
      if (!chord.is_near(points[k], own_time ? t : t0, own_time ? t : t3)) return false;
    }
    return true;
  }

  static Time time_of(const CurveSegment& segment, double u) {
    return segment.start + segment.warp.inverse({u, u - 1}) * (segment.end - segment.start);
  }

  /// The number of the first key after a place.
  static std::uint64_t next_key(const Vertex& from) { return from.segment + (from.u == 1 ? 2 : 1); }

  /// The number of the first key after a place where the curve has a corner, or of the last one.
  std::uint64_t next_corner(const Vertex& from) {
    if (corner_ >= next_key(from)) return corner_;
    corner_ = next_key(from);
    while (corner_ < curve_.size() && !(limits_distance_ && is_corner(corner_))) ++corner_;
    return corner_;
  }

  /// The directions before and after a key differ, or it has none.
  bool is_corner(std::uint64_t number) const {
    const CurveSegment before = curve_.segment(number - 1);
    const CurveSegment after = curve_.segment(number);
    const bool graph = metric_size(before) == 1;
    const double h0 = graph ? (before.end - before.start).hi : 1;
    const double h1 = graph ? (after.end - after.start).hi : 1;
    double in2 = 0, out2 = 0, both = 0;
    for (std::size_t i = 0; i < metric_size(before); ++i) {
      const double in = metric_cubic(before, i).in / h0;
      const double out = metric_cubic(after, i).out / h1;
      in2 += in * in;
      out2 += out * out;
      both += in * out;
    }
    constexpr double same = 1 - 1e-12;  // the cosine of an angle of a millionth
    if (graph) return std::abs(std::sqrt(in2) - std::sqrt(out2)) > 1e-9 * std::sqrt(in2) || both < 0;
    return !(both > 0 && both * both >= same * in2 * out2);
  }

  using Local = spline::LocalParameter<double>;

  const ShownCurve& curve_;
  double tolerance_, angle_;
  bool limits_distance_, limits_angle_, at_keys_;
  std::uint64_t corner_ = 0;  ///< the last one found
};

}  // namespace

std::vector<Time> times_within_tolerance(const ShownCurve& curve, const CurveTolerance& tolerance,
                                         std::uint64_t max_rows, bool at_keys) {
  constexpr double most = 1e300;
  const double least = std::min(std::floor(least_rows(curve, tolerance.distance)), most);
  require_rows(Rational(least) - 1, max_rows, true);
  Walker walker(curve, tolerance, at_keys);
  std::vector<Time> times;
  Vertex place = walker.start();
  times.push_back(place.t);
  while (!walker.is_end(place)) {
    place = walker.next(place);
    times.push_back(rounded_time(place.t, curve.segment(place.segment).decimals));
    require_rows(Rational(times.size() - 1), max_rows);
  }
  return times;
}

}  // namespace tcb
