// Needed rows: a lower bound on the rows of any polyline within the tolerance, from points of the curve. It is much
// closer than that of sample/least_rows.hpp, which needs no rows and refuses too many before the search.
//
// If one chord is within D of three points A, X and B, then one of them, the middle one along the chord, is within 2 D
// of the segment between the others: the two ends are within D of the chord, so their segment is within D of it. So if
// each of the three is farther than 2 D from the segment between the others, a row lies between the first and the last
// of them. In a graph over time X is in the middle. Triples that share no more than end points need a row each.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sample/chord.hpp"

namespace tcb {

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
