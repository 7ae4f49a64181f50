// Random access to a curve: its segments by number, time or arc length, and rows in any order, also outside it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sample/build.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The number of the segment on which a curve is at time t. Of two that meet there, the one before if `left`.
/// `end_time(i)` is the time at the end of segment i.
template <class T, class EndTime>
std::uint64_t segment_at_time(std::uint64_t segments, EndTime end_time, const T& t, bool left) {
  std::uint64_t low = 0, high = segments - 1;
  while (low < high) {  // the first segment that ends after t, or at t if `left`
    const std::uint64_t middle = low + (high - low) / 2;
    const T end = end_time(middle);
    if (left ? end >= t : end > t) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

/// All segments of a curve.
class CurveIndex {
 public:
  /// Requires: at least one segment.
  CurveIndex(const Source<SegmentBlock>& segments, CurveChannels channels);

  std::uint64_t size() const { return first_numbers_.back(); }
  double length() const { return s_.back().hi; }

  CurveSegment segment(std::uint64_t number) const;

  /// The number of the segment on which the curve is at time t, as segment_at_time() finds it.
  std::uint64_t find_time(const spline::Time<double>& t, bool left) const;

  /// The number of the segment on which the arc length s is first reached; of two that meet there, the second unless
  /// `left`.
  std::uint64_t find_length(const spline::Time<double>& s, bool left) const;

 private:
  std::vector<SegmentBlock> blocks_;
  std::vector<std::uint64_t> first_numbers_;  ///< of each block's first segment, then the number of segments
  std::vector<spline::DoubleDouble> s_;       ///< arc length at the start of each segment, then of all
  std::vector<double> s_error_;               ///< bounds on the errors of these
  CurveChannels channels_;
  std::vector<double> cycle_;                      ///< last key - first key
  std::vector<spline::Quaternion<double>> turns_;  ///< the same of the rotations
  int decimals_ = 0;                               ///< of the times
};

/// The times with those of the curve's keys in the range; a time within a billionth of a step of a key is dropped.
std::vector<spline::Time<double>> with_keys(const std::vector<spline::Time<double>>& times, const CurveIndex& curve,
                                            const spline::Time<double>& from, const spline::Time<double>& to);

/// The rows of a locator in order, in blocks.
Source<SampleBlock> look_up(const std::shared_ptr<const CurveIndex>& curve,
                            const std::shared_ptr<const AnywhereInTime>& rows, bool left);
Source<SampleBlock> look_up(const std::shared_ptr<const CurveIndex>& curve,
                            const std::shared_ptr<const AnywhereInLength>& rows, bool left);

}  // namespace tcb
