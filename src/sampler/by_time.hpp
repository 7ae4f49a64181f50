// Samples on a grid of times.
#pragma once

#include "sampler/on_grid.hpp"

namespace tcb::sampler {

class ByTime : public OnGrid {
 public:
  using OnGrid::OnGrid;
  void locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;

 protected:
  Range range(const Piece& piece) const override { return {piece.start, piece.end}; }
  Bound lower(const Range& range) const override { return first_key(range.start); }
  Bound upper(const Range& range) const override { return last_key(range.end); }
};

}  // namespace tcb::sampler
