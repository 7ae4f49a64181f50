// Chords: straight lines between two points of a curve, and how far the curve departs from them; the arcs of rotations
// between two points, and whether the curve is near them.
//
// A part of the curve is a cubic of s in [0, 1]. Across the chord it is
//   q(s) = s (1 - s) (a + b s)
// if it is the whole part between the two points, with a and b across the chord of its first and third derivative, so
//   |q(s)|^2 = (s (1 - s))^2 (A + 2 B s + C s^2),   A = a.a, B = a.b, C = b.b
// whose derivative by s is s (1 - s) times the cubic
//   2 [(1 - 2 s) (A + 2 B s + C s^2) + s (1 - s) (B + C s)]
// with Bernstein coefficients A, A/3 + B, (2 C + B - A)/3, -(A + 2 B + C). If their signs change once there is one
// maximum, by Descartes' rule. Otherwise, and for parts of the chord, |q|^2 is bounded as a polynomial of degree six.
// A graph of one channel over time departs from the chord at equal times. It is a polynomial of time: of degree six in
// each part of an ease, of degree nine with monotone timing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sample/curve_segment.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

struct CurvePoint {
  std::uint64_t segment = 0;
  double u = 0;
  Time t;
  std::vector<double> x;  ///< of the metric channels
};

/// Chords from one point of a curve after another, and how far the curve departs from them: upper bounds on the square
/// of the distance of any point of a part of the curve, where the tolerance is 1. They are nearly the least bounds
/// where the part does not turn back beyond an end of the chord; otherwise they are infinite if none of at most 1 was
/// found.
class Chord {
 public:
  /// A part of the curve by powers of s in one channel, relative to the first point of the chord.
  using Powers = std::array<double, 4>;

  /// `tolerance`: the unit of departures.
  explicit Chord(double tolerance);

  /// Chords start at a point of a segment. Requires: the point outlives them.
  void set_start(const CurvePoint& from, const CurveSegment& segment);

  /// The departure of the part from there to another local parameter of the same segment, where the chord ends.
  double departure(double u);

  /// The chord from there to another point. Requires: the point outlives it.
  void set_end(const CurvePoint& to);

  /// The departure of the part of a segment between two local parameters from the chord between the points.
  double departure(const CurveSegment& segment, double low, double high);

 private:
  /// The powers of u - low, and the square of the largest distance that counts as within the tolerance.
  void expand(std::vector<Powers>& powers, const CurveSegment& segment, double low) const;
  double limit2(const CurveSegment& segment) const;

  void set_direction();
  double on_graph(const CurveSegment& segment, double low, double high);
  double on_part_of_graph(const std::array<double, 3>& u, double first, double last, int& parts) const;
  double place(const CurveSegment& segment, const Time& passed) const;
  double across(const std::vector<Powers>& expansion, double size, bool is_whole, double limit2);

  double scale_, tolerance_;  ///< a power of 2 that brings the tolerance near 1, and the tolerance times it
  const CurvePoint* from_ = nullptr;
  const CurvePoint* to_ = nullptr;
  double first_limit2_ = 0;                ///< on the segment of the start
  std::vector<Powers> start_, expansion_;  ///< at the start, and of a part; times the scale, as all that follows
  double length_ = 0;
  std::vector<double> direction_;  ///< of length 1, or 0 between equal points
  std::vector<Powers> across_;     ///< a part across the chord
};

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
