// Segment length: lengths on one segment over its metric, and their places.
#pragma once

#include <cstddef>
#include <span>

#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/arc_length.hpp"

namespace tcb::spline {

/// The lengths of one segment after another, over its metric.
template <class S>
class SegmentLength {
 public:
  using W = working_t<S>;

  SegmentLength() = default;
  SegmentLength(std::span<const Cubic<S>> cubics, std::span<const std::size_t> metric) { assign(cubics, metric); }

  void assign(std::span<const Cubic<S>> cubics, std::span<const std::size_t> metric) { arc_.assign(cubics, metric); }

  const Length<S>& total() const { return arc_.total(); }

  Length<S> to(const LocalParameter<S>& place) const { return arc_.to(place); }

  /// The places of lengths, where the whole curve has the lengths `start` and `end` at the ends of the segment.
  void places(const W& start, const W& end, std::span<const W> lengths, std::span<LocalParameter<S>> places) const {
    ArcInverse<S>(arc_, start, end).at(lengths, places);
  }
  LocalParameter<S> place(const W& start, const W& end, const W& length) const {
    return ArcInverse<S>(arc_, start, end).at(length);
  }

 private:
  ArcLength<S> arc_;
};

}  // namespace tcb::spline
