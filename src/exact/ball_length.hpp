// Lengths in balls: those of one segment over its metric, and their inverse, as tcb/spline/segment_length.hpp has them
// for other scalars.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "exact/ball_arc.hpp"
#include "exact/ball_turn.hpp"
#include "tcb/spline/segment_length.hpp"

namespace tcb::spline {

/// Promises: balls that hold the lengths and places. Throws: Undecided where there is none.
template <class M>
class SegmentLength<BallOf<M>> {
 public:
  using B = BallOf<M>;

  /// `about_axes`: each rotation is about one axis. `in_double_doubles`: rotations are measured in these, also where
  /// they are known to more digits. Requires: `rotations` outlive it.
  void assign(std::span<const Cubic<B>> cubics, std::span<const RotationSegment<B>> rotations,
              std::span<const std::size_t> metric, bool about_axes = false, bool in_double_doubles = false) {
    if (!is_turn(metric)) {
      kind_ = Kind::arc;
      arc_.assign(cubics, metric);
    } else if (!in_double_doubles || (about_axes && rotations.size() == 1)) {  // those about an axis take no quadrature
      kind_ = Kind::turn;
      turn_.assign(rotations, about_axes, near_turns(rotations));
    } else {
      kind_ = Kind::rough_turn;
      rough_rotations_.clear();
      for (const RotationSegment<B>& rotation : rotations) rough_rotations_.push_back(from_start(rotation));
      rough_turn_.assign(rough_rotations_, about_axes, near_turns(rotations));
    }
  }

  Length<B> total() const {
    if (kind_ == Kind::rough_turn) return {from_ball<B>(rough_turn_.total()), B()};
    return {kind_ == Kind::turn ? turn_.total() : arc_.total(), B()};
  }
  Length<B> to(const LocalParameter<B>& place) const {
    if (kind_ == Kind::rough_turn) return {from_ball<B>(rough_turn_.to({ball_of(place.u), ball_of(place.w)})), B()};
    return {kind_ == Kind::turn ? turn_.to(place) : arc_.to(place), B()};
  }
  void places(const B& start, const B&, std::span<const B> lengths, std::span<LocalParameter<B>> places) const {
    for (std::size_t i = 0; i < lengths.size(); ++i) places[i] = place(lengths[i] - start);
  }

 private:
  enum class Kind { arc, turn, rough_turn };

  LocalParameter<B> place(const B& length) const {
    if (kind_ == Kind::arc) return arc_.place(length);
    B u;
    if (kind_ == Kind::turn) {
      const auto [center, distance] = turn_.place(length);
      u = B(center) + distance;
    } else {
      const auto [center, distance] = rough_turn_.place(ball_of(length));
      u = from_ball<B>(Ball(center)) + from_ball<B>(distance);
    }
    return {u, u - B(1.0)};
  }

  Kind kind_ = Kind::arc;
  BallArc<M> arc_;
  BallTurn<M> turn_;
  std::vector<RotationSegment<Ball>> rough_rotations_;
  BallTurn<DoubleDouble> rough_turn_;
};

}  // namespace tcb::spline
