// Samples on a grid of arc lengths: each at the smallest time by which that much curve has passed.
#pragma once

#include "sampling/on_grid.hpp"

namespace tcb {

/// A time worked out from a place on a segment, rounded once: to a double, or beyond 2^53 to a whole number.
Time rounded_time(const Time& t);

/// Locates the samples at which the curve has the lengths in `located`, which lie on the piece; their times are
/// rounded once.
void locate_lengths(const CurveSegment& piece, Located& located);

class ByLength : public OnGrid {
 public:
  using OnGrid::OnGrid;
  void locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;

 protected:
  Range range(const CurveSegment& piece) const override { return {{piece.s_start.hi}, {piece.s_end.hi}}; }
  Bound lower(const Range&) const override { return curve_start(); }
  Bound upper(const Range& range) const override { return curve_length(range.end.hi); }
};

}  // namespace tcb
