// Kept curve: a curve with random access to its segments, and how rows show its channels.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sample/curve_segment.hpp"
#include "sample/extrapolation.hpp"
#include "sample/request.hpp"
#include "schema/curve_channels.hpp"

namespace tcb::spline {
template <class S>
class Curve;
}

namespace tcb {

class KeptCurve {
 public:
  /// Requires: at least one segment. `extent`: of its keys, whose times may have more digits than those of segments.
  KeptCurve(spline::Curve<double> curve, CurveChannels channels, const Extent& extent,
            const Extrapolations& extrapolations = {});

  const spline::Curve<double>& curve() const { return *curve_; }
  const std::optional<FrameTimes>& frames() const { return channels_.frames; }
  const Extent& extent() const { return extent_; }
  const Extrapolations& extrapolations() const { return extrapolations_; }
  double length() const;
  /// The number of segments.
  std::uint64_t size() const;

  CurveSegment segment(std::uint64_t number) const;

 private:
  std::shared_ptr<const spline::Curve<double>> curve_;
  CurveChannels channels_;
  Extent extent_;
  Extrapolations extrapolations_;
  std::vector<double> cycle_;                      ///< last key - first key
  std::vector<spline::Quaternion<double>> turns_;  ///< last key times the inverse of the first, of each rotation
  int decimals_ = 0;                               ///< of the times
};

}  // namespace tcb
