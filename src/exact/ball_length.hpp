// Lengths in balls: those of one segment over its metric, and their inverse, as tcb/spline/segment_length.hpp has them
// for other scalars.
#pragma once

#include <cstddef>
#include <span>

#include "exact/ball_arc.hpp"
#include "tcb/spline/segment_length.hpp"

namespace tcb::spline {

/// Promises: balls that hold the lengths and places. Throws: Undecided where there is none.
template <class M>
class SegmentLength<BallOf<M>> {
 public:
  using B = BallOf<M>;

  void assign(std::span<const Cubic<B>> cubics, std::span<const std::size_t> metric) { arc_.assign(cubics, metric); }

  Length<B> total() const { return {arc_.total(), B()}; }
  Length<B> to(const LocalParameter<B>& place) const { return {arc_.to(place), B()}; }
  void places(const B& start, const B&, std::span<const B> lengths, std::span<LocalParameter<B>> places) const {
    for (std::size_t i = 0; i < lengths.size(); ++i) places[i] = arc_.place(lengths[i] - start);
  }

 private:
  BallArc<M> arc_;
};

}  // namespace tcb::spline
