// Samples on a grid of arc lengths: each at the smallest time by which that much curve has passed.
#pragma once

#include "sampler/grid.hpp"
#include "sampler/sampler.hpp"

namespace tcb::sampler {

class ByLength : public Sampler {
 public:
  /// Rows from the grid's start to `to` (by default the whole length), `limit` at most.
  ByLength(Grid grid, std::optional<double> to, std::uint64_t limit);

  Run place(const Piece& piece) override;
  Sample locate(const Piece& piece, std::uint64_t j) const override;
  bool done() const override { return done_; }

 private:
  Grid grid_;
  std::optional<double> to_;
  std::uint64_t limit_;
  std::uint64_t next_ = 0;
  bool done_ = false;
};

}  // namespace tcb::sampler
