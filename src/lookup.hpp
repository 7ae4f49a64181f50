// Looking a curve up anywhere: it is kept whole, and rows may come in any order, also outside it.
#pragma once

#include <memory>
#include <vector>

#include "pieces.hpp"
#include "rows.hpp"
#include "sampler/anywhere.hpp"
#include "stream.hpp"

namespace tcb {

/// All pieces of a curve.
class WholeCurve {
 public:
  /// Requires: a segment at least.
  WholeCurve(const Source<Stretch>& stretches, std::vector<std::size_t> metric);

  /// The piece on which the curve is at time t; of two that meet there, the later one.
  sampler::Piece piece_at(const spline::Time<double>& t) const;

 private:
  std::vector<Stretch> stretches_;
  std::vector<spline::Twice> s_;  ///< arc length where each stretch begins
  std::vector<std::size_t> metric_;
  std::vector<double> cycle_;  ///< last key - first key
};

/// The rows of a locator, in batches.
Source<Batch> look_up(std::shared_ptr<const WholeCurve> curve, std::shared_ptr<const sampler::Anywhere> rows);

}  // namespace tcb
