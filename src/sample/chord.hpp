// Chords: straight lines between two points of a curve, and how far the curve departs from them.
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

#include <array>
#include <cstdint>
#include <vector>

#include "sample/curve_segment.hpp"

namespace tcb {

/// A point of the curve.
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

}  // namespace tcb
