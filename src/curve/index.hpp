// Looking a curve up anywhere: it is kept whole, and rows may come in any order, also outside it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "curve/rows.hpp"
#include "curve/segment_blocks.hpp"
#include "sampling/at_places.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// All pieces of a curve.
class CurveIndex {
 public:
  /// Requires: a segment at least.
  CurveIndex(const Source<SegmentBlock>& segment_blocks, std::vector<std::size_t> metric);

  std::uint64_t size() const { return first_numbers_.back(); }
  double length() const { return s_.back().hi; }

  CurveSegment piece(std::uint64_t number) const;

  /// The number of the piece on which the curve is at time t. Of two that meet there, the one before if `left`.
  std::uint64_t find_time(const spline::Time<double>& t, bool left) const;

  /// The number of the first piece by whose end the arc length s is reached; at that end, the one after unless `left`.
  std::uint64_t find_length(const spline::Time<double>& s, bool left) const;

 private:
  std::vector<SegmentBlock> stretches_;
  std::vector<std::uint64_t> first_numbers_;  ///< of each block's first piece, and how many there are
  std::vector<spline::DoubleDouble> s_;       ///< arc length at the start of each piece, and of all
  std::vector<double> s_error_;               ///< bounds on the errors of these
  std::vector<std::size_t> metric_;
  std::vector<double> cycle_;  ///< last key - first key
};

/// The times with those of the curve's keys in the range; a time within a billionth of a step from a key gives way.
std::vector<spline::Time<double>> with_keys(const std::vector<spline::Time<double>>& times, const CurveIndex& curve,
                                            const spline::Time<double>& from, const spline::Time<double>& to);

/// The rows of a locator, in batches.
Source<SampleBlock> look_up(const std::shared_ptr<const CurveIndex>& curve,
                            const std::shared_ptr<const AnywhereInTime>& rows, bool left);
Source<SampleBlock> look_up(const std::shared_ptr<const CurveIndex>& curve,
                            const std::shared_ptr<const AnywhereInLength>& rows, bool left);

}  // namespace tcb
