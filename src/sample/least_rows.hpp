// Least rows: how many rows any polyline within a tolerance of a curve has at least.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sample/build.hpp"
#include "sample/chord.hpp"
#include "tcb/spline/derivatives.hpp"

namespace tcb {

// A lower bound on the rows from the curvature, by which too many are refused before the search.
//
// Where a chord is within D of a part of the curve of length h in the local parameter, then across the chord the curve
// is a cubic p with |p| <= D there. By the inequality of the brothers Markov |p'| <= 18 D / h and |p''| <= 96 D / h^2.
// Of the velocity X' and the acceleration X'' at any place of that part only p' and p'' are across the chord, so
//   |X' ^ X''| <= |X'| 96 D / h^2 + |X''| 18 D / h
// which limits h. In a graph over time where |X''| >= m, the curve departs from the chord by m h^2 / 8 in all, which is
// at most 2 D. So a part of length L takes L / h chords, of which it may share the first and the last.
// Source: P. Borwein, T. Erdelyi, "Polynomials and Polynomial Inequalities", 1995, section 5.1.

inline constexpr int parts_of_segment = 16;

/// The longest part of a graph that one chord may cover, where its second derivative is `least` at least.
inline double longest_in_graph(double least, double tolerance) { return 4 * std::sqrt(tolerance / least); }

/// The longest part of a path that one chord may cover, where |X' ^ X''| >= least, |X'| <= speed and |X''| <= change.
inline double longest_on_path(double least, double speed, double change, double tolerance) {
  const double linear = 18 * change * tolerance;
  return (linear + std::sqrt(linear * linear + 4 * least * 96 * speed * tolerance)) / (2 * least);
}

/// How many chords the part around a place takes at least, without two that it may share with its neighbours. `at`:
/// memory to reuse.
inline double chords(const CurveSegment& segment, double middle, double tolerance, spline::Derivatives<double>& at) {
  constexpr double half = 0.5 / parts_of_segment;
  spline::set_derivatives<double>(at, segment.cubics, {middle, middle - 1}, {}, middle, 1);
  const spline::MetricView<double> v(at.velocity, segment.metric), a(at.acceleration, segment.metric),
      j(at.jerk, segment.metric);
  const double jerk = spline::norm(j), change = spline::norm(a) + half * jerk, speed = spline::norm(v) + half * change;
  double longest = 0, least = 0;
  if (v.size() == 1) {
    least = std::abs(a[0]) - half * jerk;
    longest = longest_in_graph(least, tolerance);
  } else {
    least = spline::wedge(v, a) - half * speed * jerk;  // the derivative of X' ^ X'' is X' ^ X'''
    longest = longest_on_path(least, speed, change, tolerance);
  }
  const bool is_bound = least > 0 && std::isfinite(least) && longest >= 0;
  return is_bound ? std::max(2 * half / longest - 2, 0.0) : 0;
}

inline double least_rows(const KeptCurve& curve, double tolerance) {
  double sum = 2;
  spline::Derivatives<double> memory;
  for (std::uint64_t number = 0; number < curve.size(); ++number) {
    const CurveSegment segment = curve.segment(number);
    if (metric_size(segment) == 1 && !segment.warp.is_identity()) continue;  // its graph is not a cubic
    for (int part = 0; part < parts_of_segment; ++part)
      sum += chords(segment, (part + 0.5) / parts_of_segment, tolerance, memory);
  }
  return sum;
}

// A lower bound on the rows from points of the curve, which is much closer.
//
// If one chord is within D of three points A, X and B, then one of them, the middle one along the chord, is within 2 D
// of the segment between the others: the two ends are within D of the chord, so their segment is within D of it. So if
// each of the three is farther than 2 D from the segment between the others, a row lies between the first and the last
// of them. In a graph over time X is in the middle. Triples that share no more than end points need a row each.

/// Counts the rows that are needed. Points are added in their order along the curve; the more, the better the bound.
class NeededRows {
 public:
  explicit NeededRows(double tolerance) : tolerance_(tolerance) {}

  void add(const CurvePoint& point) {
    points_[size_++] = point;
    if (size_ >= 3 && no_chord_is_near(points_[0], points_[size_ / 2], point)) {
      ++between_;
      points_[0] = point;
      size_ = 1;
    } else if (size_ == points_.size()) {
      for (std::size_t i = 1; 2 * i < size_; ++i) points_[i] = points_[2 * i];
      size_ /= 2;
    }
  }

  /// With the rows at both ends.
  std::uint64_t count() const { return between_ + 2; }

 private:
  bool no_chord_is_near(const CurvePoint& a, const CurvePoint& x, const CurvePoint& b) const {
    double size = 0;
    for (const CurvePoint* point : {&a, &x, &b}) {
      for (const double number : point->x) size = std::max(size, std::abs(number));
    }
    const double least = 2 + 1e-9 + 0x1p-49 * size / tolerance_;  // with the rounding of positions
    if (a.x.size() == 1) return height(a, x, b) > least;
    const double least2 = least * least;
    return distance2(x, a, b) > least2 && distance2(a, x, b) > least2 && distance2(b, a, x) > least2;
  }

  /// How far x is from the line between the others at its time, in tolerances.
  double height(const CurvePoint& a, const CurvePoint& x, const CurvePoint& b) const {
    if (!(a.t < x.t && x.t < b.t)) return 0;
    const double part = ((x.t - a.t) / (b.t - a.t)).hi;
    return std::abs((x.x[0] - a.x[0]) / tolerance_ - part * ((b.x[0] - a.x[0]) / tolerance_));
  }

  /// The square of the distance of x from the segment between the others, in tolerances.
  double distance2(const CurvePoint& x, const CurvePoint& a, const CurvePoint& b) const {
    const auto difference = [&](const CurvePoint& p, const CurvePoint& q, std::size_t i) {
      return (p.x[i] - q.x[i]) / tolerance_;
    };
    double along = 0, length2 = 0, sum = 0;
    for (std::size_t i = 0; i < x.x.size(); ++i) {
      along += difference(x, a, i) * difference(b, a, i);
      length2 += difference(b, a, i) * difference(b, a, i);
    }
    const double part = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
    for (std::size_t i = 0; i < x.x.size(); ++i) {
      const double gap = difference(x, a, i) - part * difference(b, a, i);
      sum += gap * gap;
    }
    return sum;
  }

  double tolerance_;
  std::uint64_t between_ = 0;
  std::array<CurvePoint, 64> points_;  ///< since the last row that was counted; of more, every second one
  std::size_t size_ = 0;
};

}  // namespace tcb
