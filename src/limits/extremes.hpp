// Extremes: the certified maximum of a measure over a curve.
//
// All pieces are bounded with doubles and a bound on their rounding; the parts that may hold the maximum are bounded
// again with rationals, from the exact keys. Nothing is sampled: a part is left out where its bound is below a value
// that is attained.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "limits/ball.hpp"
#include "limits/pieces.hpp"
#include "numbers/frame_times.hpp"
#include "numbers/rational.hpp"
#include "sample/build.hpp"
#include "stream/source.hpp"

namespace tcb::limits {

/// A curve whose segments can be read again, as doubles and as exact numbers.
struct MeasuredCurve {
  std::function<Source<SegmentBlock>()> segments;
  /// The segment with this number, in balls and exactly. Throws: Undecided where a ball does not decide it.
  std::function<spline::Segments<Ball>(std::size_t number)> in_balls;
  std::function<spline::Segments<Rational>(std::size_t number)> exact;
  std::optional<FrameTimes> frames;  ///< where the times of the keys are frames in seconds
  std::optional<Rational> from, to;  ///< the times that are measured; nothing: all
  bool closed = false;
};

/// The maximum of a measure: of a size its square, of a smallest number its negative.
struct Extreme {
  Rational low;                             ///< a value that is attained
  Rational high;                            ///< a bound that is not exceeded
  Rational time;                            ///< where `low` is attained
  std::vector<double> position = {};        ///< there, of all channels
  spline::Side side = spline::Side::right;  ///< of a key there, on whose segment
  bool is_at_key = false;
  bool is_unbounded = false;  ///< it grows beyond all numbers near this time; `low` and `high` have no meaning
  bool is_unproved = false;   ///< numbers are too far apart to bound it; nothing else has a meaning
};

/// A sudden change of the velocity.
struct Corner {
  Time time;
  double jump = 0;                         ///< the root of the sum of squares over the channels
  std::vector<std::size_t> channels = {};  ///< that change
  std::vector<double> in = {}, out = {};   ///< the velocities before and after it, of all channels that are compared

  /// Whether the velocity changes its direction in the channels `measured`. `compared`: those of all velocities.
  bool turns(const std::vector<std::size_t>& compared, const std::vector<std::size_t>& measured) const;
};

struct Extremes {
  std::vector<std::optional<Extreme>> maxima;  ///< of the measures, in their order; nothing where no time is measured
  std::vector<Corner> corners;
};

/// The maxima of the measures, and the corners in `channels`.
Extremes extremes(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                  const std::vector<std::size_t>& channels);

}  // namespace tcb::limits
