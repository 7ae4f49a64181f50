// Extremes: the certified maximum of a measure over a curve.
//
// All pieces are bounded with double-doubles and bounds on their errors; those that this does not settle with
// rationals, from the exact keys. Nothing is sampled: a part is left out where its bound is not above a value that is
// attained.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "limits/pieces.hpp"
#include "numbers/rational.hpp"

namespace tcb::limits {

/// A curve whose segments can be read in any order.
struct MeasuredCurve {
  std::size_t size = 0;                              ///< how many segments it has
  std::function<Time(std::size_t number)> key_time;  ///< where a segment begins, and the end of the last one
  /// The segments of these numbers, and one of them exactly. Nothing where there are only exact ones.
  std::function<std::optional<spline::Segments<Bounded>>(std::size_t first, std::size_t to)> bounded;
  std::function<spline::Segments<Rational>(std::size_t number)> exact;
  bool is_rational = true;           ///< those are exact; otherwise they have 448 bits
  std::optional<Rational> from, to;  ///< the times that are measured; nothing: all
  bool closed = false;
  bool has_positions = false;  ///< where the maxima are
};

/// The maximum of a measure: of a size its square, of a smallest number its negative.
struct Extreme {
  Rational low;                             ///< a value that is attained
  Rational high;                            ///< a bound that is not exceeded
  Rational time;                            ///< where `low` is attained
  std::vector<double> position = {};        ///< there, of all channels, if the curve has positions
  spline::Side side = spline::Side::right;  ///< of a key there, on whose segment
  bool is_at_key = false;
  bool is_unbounded = false;  ///< it grows beyond all numbers near this time; `low` and `high` have no meaning
  bool is_unproved = false;   ///< numbers are too far apart to bound it; nothing else has a meaning
};

/// A sudden change of the velocity.
struct Corner {
  Time time;
  double jump = 0;                         ///< the root of the sum of squares over the channels
  std::vector<std::size_t> channels = {};  ///< that change, in ascending order
  std::vector<double> in = {}, out = {};   ///< the velocities before and after it, of all channels that are compared

  /// Whether the velocity changes its direction in the channels `measured`. `compared`: those of all velocities.
  bool turns(const std::vector<std::size_t>& compared, const std::vector<std::size_t>& measured) const;
};

struct Extremes {
  std::vector<std::optional<Extreme>> maxima;  ///< of the measures, in their order; nothing where no time is measured
  std::vector<Corner> corners;
};

/// The maxima of the measures, and the corners in `channels`, which ascend.
Extremes extremes(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                  const std::vector<std::size_t>& channels);

}  // namespace tcb::limits
