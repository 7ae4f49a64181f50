// A lower bound on the rows that a tolerance needs, from the curvature: so that too many are refused at once.
//
// Where a chord is within D of a part of the curve of length h in the local parameter, then across the chord the curve
// is a cubic p with |p| <= D there. By the inequality of the brothers Markov |p'| <= 18 D / h and |p''| <= 96 D / h^2.
// Of the velocity X' and the acceleration X'' at any place of that part only p' and p'' are across the chord, so
//   |X' ^ X''| <= |X'| 96 D / h^2 + |X''| 18 D / h
// which limits h. In a graph over time where |X''| >= m, the curve departs from the chord by m h^2 / 8 in all, which is
// at most 2 D. So a part of length L takes L / h chords, of which it may share the first and the last.
// Source: P. Borwein, T. Erdelyi, "Polynomials and Polynomial Inequalities", 1995, section 5.1.
#include "sample/least_rows.hpp"

#include <algorithm>
#include <cmath>

#include "tcb/spline/derivatives.hpp"

namespace tcb {
namespace {

constexpr int parts_of_segment = 16;

using spline::MetricView;

/// The longest part of a graph that one chord may cover, where its second derivative is `least` at least.
double longest_in_graph(double least, double tolerance) { return 4 * std::sqrt(tolerance / least); }

/// The same for a path with |X' ^ X''| >= least, |X'| <= speed and |X''| <= change.
double longest_on_path(double least, double speed, double change, double tolerance) {
  const double linear = 18 * change * tolerance;
  return (linear + std::sqrt(linear * linear + 4 * least * 96 * speed * tolerance)) / (2 * least);
}

/// How many chords the part around a place takes at least, without two that it may share with its neighbours. `at`:
/// memory to reuse.
double chords(const CurveSegment& segment, double middle, double tolerance, spline::Derivatives<double>& at) {
  constexpr double half = 0.5 / parts_of_segment;
  spline::set_derivatives<double>(at, segment.cubics, {middle, middle - 1}, {}, middle, 1);
  const MetricView<double> v(at.velocity, segment.metric), a(at.acceleration, segment.metric),
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

}  // namespace

double least_rows(const ShownCurve& curve, double tolerance) {
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

}  // namespace tcb
