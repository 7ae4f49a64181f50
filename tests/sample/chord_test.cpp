// Chords: departures are bounds on distances, and nearly the least, at any size.
#include "sample/chord.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sample/kept_curve_of.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb {
namespace {

spline::Keys<double> random_keys(std::mt19937_64& random, std::size_t channels, double size) {
  std::uniform_real_distribution<double> place(-1, 1);
  spline::Keys<double> keys;
  keys.channels = channels;
  for (int i = 0; i < 4; ++i) {
    keys.times.emplace_back(i);
    keys.tcbs.push_back({place(random), place(random), place(random)});
    for (std::size_t c = 0; c < channels; ++c) keys.positions.push_back(place(random) * size);
  }
  return keys;
}

CurvePoint point(const KeptCurve& curve, std::uint64_t number, double u) {
  const CurveSegment segment = curve.segment(number);
  CurvePoint result{number, u, time_on(segment, u), {}};
  for (std::size_t i = 0; i < metric_size(segment); ++i) {
    result.x.push_back(spline::position(metric_cubic(segment, i), {u, u - 1}));
  }
  return result;
}

/// The distance of a point from the chord, in tolerances; in a graph at equal times.
double distance(const CurvePoint& p, const CurvePoint& a, const CurvePoint& b, double tolerance) {
  double along = 0, length2 = 0, distance2 = 0;
  const auto difference = [&](const CurvePoint& x, const CurvePoint& y, std::size_t i) {
    return (x.x[i] - y.x[i]) / tolerance;
  };
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    along += difference(p, a, i) * difference(b, a, i);
    length2 += difference(b, a, i) * difference(b, a, i);
  }
  double part = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
  if (p.x.size() == 1) part = ((p.t - a.t) / (b.t - a.t)).hi;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const double gap = difference(p, a, i) - part * difference(b, a, i);
    distance2 += gap * gap;
  }
  return std::sqrt(distance2);
}

/// Departures of random chords are compared with the largest distance of many points.
void expect_bounds(std::size_t channels, double size, bool eased) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> place(0, 1);
  constexpr double rounding = 1e-12;  // of positions that are some tolerances large
  int finite = 0;
  for (int round = 0; round < 400; ++round) {
    auto keys = random_keys(random, channels, size);
    if (eased) {
      for (int i = 0; i < 4; ++i) keys.eases.push_back({place(random), place(random)});
    }
    const KeptCurve curve = kept_curve_of(*spline::Curve<double>::build(keys, {}));
    const CurvePoint from = point(curve, 0, place(random)),
                     to = point(curve, round % 2 == 0 ? 0 : 2, from.u + (1 - from.u) * place(random));
    const double tolerance = size * (round % 3 == 0 ? 10 : 0.5);
    Chord chord(tolerance);
    const CurveSegment first = curve.segment(0);
    chord.set_start(from, first);
    chord.set_end(to);
    double bound = 0, largest = 0;
    for (std::uint64_t number = 0; number <= to.segment; ++number) {
      const double low = number == 0 ? from.u : 0, high = number == to.segment ? to.u : 1;
      bound = std::max(bound, chord.departure(curve.segment(number), low, high));
      for (int i = 0; i <= 256; ++i) {
        const CurvePoint p = point(curve, number, low + (high - low) * i / 256);
        largest = std::max(largest, distance(p, from, to, tolerance));
      }
    }
    EXPECT_GE(std::sqrt(bound), largest * (1 - 1e-9) - rounding) << round;
    if (std::sqrt(bound) <= 1) ++finite;
    if (channels == 1) {
      EXPECT_LE(std::sqrt(bound), largest * 1.001 + 1e-2) << round;
    }
    if (channels == 1 && eased) continue;
    if (to.segment == 0 && to.u > from.u) {
      EXPECT_GE(std::sqrt(chord.departure(to.u)), largest * (1 - 1e-9) - rounding) << round;
    }
  }
  EXPECT_GT(finite, 100);
}

TEST(Chord, departures_bound_the_distances_of_paths) { expect_bounds(3, 1, false); }
TEST(Chord, departures_bound_the_distances_of_graphs) { expect_bounds(1, 1, false); }
TEST(Chord, departures_bound_the_distances_of_graphs_with_ease) { expect_bounds(1, 1, true); }
TEST(Chord, departures_bound_the_distances_of_tiny_paths) { expect_bounds(2, 1e-300, false); }
TEST(Chord, departures_bound_the_distances_of_huge_paths) { expect_bounds(2, 1e300, false); }

}  // namespace
}  // namespace tcb
