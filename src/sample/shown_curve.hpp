// Shown curve: a kept curve, and how rows show its channels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sample/curve_segment.hpp"
#include "schema/curve_channels.hpp"
#include "stream/source.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb {

struct SegmentBlock;

/// The curve of these segments. `count`: the number of segments.
spline::Curve<double> kept_curve(const Source<SegmentBlock>& segments, const spline::CurveRules<double>& rules,
                                 bool closed, std::size_t count);

/// A kept curve with random access to its segments, as rows need them.
class ShownCurve {
 public:
  /// Requires: at least one segment.
  ShownCurve(spline::Curve<double> curve, CurveChannels channels);

  const spline::Curve<double>& curve() const { return curve_; }
  const std::optional<FrameTimes>& frames() const { return channels_.frames; }
  /// The number of segments.
  std::uint64_t size() const { return curve_.segment_count(); }

  CurveSegment segment(std::uint64_t number) const;

 private:
  spline::Curve<double> curve_;
  CurveChannels channels_;
  std::vector<double> cycle_;                      ///< last key - first key
  std::vector<spline::Quaternion<double>> turns_;  ///< last key times the inverse of the first, of each rotation
  int decimals_ = 0;                               ///< of the times
};

}  // namespace tcb
