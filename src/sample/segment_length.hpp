// Segment length: what arc-length sampling measures on a segment, lengths of the path or angles of rotations.
#pragma once

#include <span>

#include "sample/curve_segment.hpp"
#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/turn_length.hpp"

namespace tcb {

/// The lengths of one segment after another, over its metric.
template <class S>
class SegmentLength {
 public:
  using W = spline::working_t<S>;

  /// Requires: the rotations outlive it.
  void assign(std::span<const spline::Cubic<S>> cubics, std::span<const spline::RotationSegment<S>> rotations,
              std::span<const std::size_t> metric) {
    is_turn_ = spline::is_turn(metric);
    is_turn_ ? turn_.assign(rotations) : arc_.assign(cubics, metric);
  }

  const spline::Length<S>& total() const { return is_turn_ ? turn_.total() : arc_.total(); }

  /// From the start to a place.
  spline::Length<S> to(const spline::LocalParameter<S>& place) const {
    return is_turn_ ? turn_.to(place) : arc_.to(place);
  }

  /// The places of lengths, where the whole curve has the lengths `start` and `end` at the ends of the segment.
  void places(const W& start, const W& end, std::span<const W> lengths,
              std::span<spline::LocalParameter<S>> places) const {
    if (is_turn_) return turn_.places(start, lengths, places);
    spline::ArcInverse<S>(arc_, start, end).at(lengths, places);
  }

 private:
  bool is_turn_ = false;
  spline::ArcLength<S> arc_;
  spline::TurnLength<S> turn_;
};

}  // namespace tcb
