// Samples on a grid of times.
#pragma once

#include <limits>

#include "sampler/grid.hpp"
#include "sampler/sampler.hpp"

namespace tcb::sampler {

class ByTime : public Sampler {
 public:
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

  /// Rows from the grid's start to `to` (by default the last key), `limit` at most.
  ByTime(Grid grid, std::optional<Time> to, std::uint64_t limit);

  Run place(const Piece& piece) override;
  Sample locate(const Piece& piece, std::uint64_t j) const override;
  bool done() const override { return done_; }

 private:
  Grid grid_;
  std::optional<Time> to_;
  std::uint64_t limit_;
  std::uint64_t next_ = 0;
  bool done_ = false;
};

}  // namespace tcb::sampler
