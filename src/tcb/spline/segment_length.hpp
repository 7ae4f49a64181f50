// Segment length: lengths on one segment over its metric, those of the path or the angles of rotations.
#pragma once

#include <cstddef>
#include <span>

#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/turn_length.hpp"

namespace tcb::spline {

/// The lengths of one segment after another, over its metric.
template <class S>
class SegmentLength {
 public:
  using W = working_t<S>;

  SegmentLength() = default;
  SegmentLength(std::span<const Cubic<S>> cubics, std::span<const RotationSegment<S>> rotations,
                std::span<const std::size_t> metric) {
    assign(cubics, rotations, metric);
  }

  void assign(std::span<const Cubic<S>> cubics, std::span<const RotationSegment<S>> rotations,
              std::span<const std::size_t> metric) {
    is_turn_ = is_turn(metric);
    is_turn_ ? turn_.assign(rotations) : arc_.assign(cubics, metric);
  }

  const Length<S>& total() const { return is_turn_ ? turn_.total() : arc_.total(); }

  Length<S> to(const LocalParameter<S>& place) const { return is_turn_ ? turn_.to(place) : arc_.to(place); }

  /// The places of lengths, where the whole curve has the lengths `start` and `end` at the ends of the segment.
  void places(const W& start, const W& end, std::span<const W> lengths, std::span<LocalParameter<S>> places) const {
    if (is_turn_) return turn_.places(start, lengths, places);
    ArcInverse<S>(arc_, start, end).at(lengths, places);
  }
  LocalParameter<S> place(const W& start, const W& end, const W& length) const {
    return is_turn_ ? turn_.place(start, length) : ArcInverse<S>(arc_, start, end).at(length);
  }

 private:
  bool is_turn_ = false;
  ArcLength<S> arc_;
  TurnLength<S> turn_;
};

}  // namespace tcb::spline
