// Turn chords: the arcs of rotations between two rows, and whether the curve is near them.
#pragma once

#include <algorithm>
#include <array>
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

  /// The arcs between two points.
  void set(const TurnPlace& from, const TurnPlace& to) {
    from_ = from.segment.precise(from.t);
    duration_ = to.segment.precise(to.t) - from_;
    arcs_.clear();
    for (std::size_t i = 0; i < from.segment.rotations.size(); ++i) {
      const auto start = from.segment.rotations[i].at(from.at), end = to.segment.rotations[i].at(to.at);
      arcs_.emplace_back(start, spline::dot(start, end) < 0 ? -end : end);  // as a reader interpolates
    }
  }

  /// The square of the sine of half the largest angle between the arcs and the part of a segment between two local
  /// parameters, where that of the tolerance is 1: at `places` that are evenly spread over the time of each part of an
  /// ease, and at the vertex of the parabola through the largest of them. Of more than `most` it tells only that it is
  /// more.
  double departure(const CurveSegment& segment, double low, double high, double most) const {
    double largest = 0, start = low;
    for (const double next : {segment.warp.end_of_first_part(), segment.warp.start_of_last_part(), high}) {
      const double end = std::min(next, high);
      if (!(end > start) || largest > most) continue;
      for (std::size_t k = 0; k < arcs_.size(); ++k) {
        largest = std::max(largest, on_part(segment, k, time_on(segment, start), time_on(segment, end), most));
      }
      start = end;
    }
    return largest;
  }

 private:
  static constexpr std::size_t places = 16;  // per part; between them no angle was found that exceeds the peak by 1 %
  static constexpr double most_angle = 3.1;
  static double square(double number) { return number * number; }

  /// The largest square for an arc between two times of a segment, between which its ease, if any, is smooth.
  double on_part(const CurveSegment& segment, std::size_t arc, const Time& start, const Time& end, double most) const {
    const spline::TimeMap<double> local = segment.time_map();
    std::array<double, places + 1> squares;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const Time t = start + (end - start) * Time(static_cast<double>(i) / places);
      const double part = ((segment.precise(t) - from_) / duration_).hi;
      squares[i] = 0;
      if (part <= 0 || part >= 1) continue;  // the arc joins two points of the curve
      const auto turn = spline::conjugate(spline::normalized(arcs_[arc].at(part, 1 - part))) *
                        segment.rotations[arc].at(local(segment.precise(std::clamp(t, segment.start, segment.end))));
      squares[i] = (square(turn.x) + (square(turn.y) + square(turn.z))) / sine2_;
      if (squares[i] > most) return squares[i];
    }
    return peak(squares);
  }

  /// The largest number, or the vertex of the parabola through it and those next to it.
  static double peak(const std::array<double, places + 1>& numbers) {
    const auto top = std::ranges::max_element(numbers);
    if (top == numbers.begin() || top + 1 == numbers.end()) return *top;
    const double before = *(top - 1), after = *(top + 1), bend = before - 2 * *top + after;
    return bend < 0 ? *top - square(after - before) / (8 * bend) : *top;
  }

  Time from_, duration_;
  double sine2_;  ///< of half the angle
  std::vector<spline::Arc<double>> arcs_;
};

}  // namespace tcb
