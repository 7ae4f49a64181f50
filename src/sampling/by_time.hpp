// Samples on a grid of times.
#pragma once

#include "sampling/on_grid.hpp"

namespace tcb {

class ByTime : public OnGrid {
 public:
  using OnGrid::OnGrid;
  void locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;

 protected:
  Range range(const CurveSegment& piece) const override { return {piece.start, piece.end}; }
  Bound lower(const Range& range) const override { return first_key(range.start); }
  Bound upper(const Range& range) const override { return last_key(range.end); }
};

}  // namespace tcb
