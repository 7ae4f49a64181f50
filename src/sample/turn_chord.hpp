// Turn chords: the arcs of rotations between two rows, and whether the curve is near them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sample/curve_segment.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

/// A point of the curve.
struct TurnPlace {
  CurveSegment segment;
  spline::LocalParameter<double> at;
  Time t;
};

/// The arcs of the rotations between two points of the curve, at equal rates over time.
class TurnChord {
 public:
  /// `angle`: how far from the arcs is near, in radians.
  explicit TurnChord(double angle) : sine2_(square(spline::sine(std::min(angle, most_angle) / 2))) {}

  void set(const TurnPlace& from, const TurnPlace& to) {
    from_ = from.t;
    duration_ = to.t - from.t;
    arcs_.clear();
    for (std::size_t i = 0; i < from.segment.rotations.size(); ++i) {
      const auto start = from.segment.rotations[i].at(from.at), end = to.segment.rotations[i].at(to.at);
      arcs_.emplace_back(start, spline::dot(start, end) < 0 ? -end : end);  // as a reader interpolates
    }
  }

  /// The square of the sine of half the largest angle between the arcs and the part of a segment between two local
  /// parameters, as far as `places` of it tell, where that of the tolerance is 1.
  double departure(const CurveSegment& segment, double low, double high) const {
    double largest = 0;
    for (int i = 0; i <= places; ++i) {
      const double u = low + (high - low) * i / places;
      const Time t = time_on(segment, u);
      const double part = ((t - from_) / duration_).hi;
      for (std::size_t k = 0; k < arcs_.size(); ++k) {
        const auto turn =
            spline::conjugate(spline::normalized(arcs_[k].at(part, 1 - part))) * segment.rotations[k].at({u, u - 1});
        largest = std::max(largest, square(turn.x) + (square(turn.y) + square(turn.z)));
      }
    }
    return largest / sine2_;
  }

 private:
  static constexpr int places = 16;  // per part; between two of them the angle exceeds theirs by about 1 % at most
  static constexpr double most_angle = 3.1;
  static double square(double number) { return number * number; }

  Time from_, duration_;
  double sine2_;  ///< of half the angle
  std::vector<spline::Arc<double>> arcs_;
};

}  // namespace tcb
