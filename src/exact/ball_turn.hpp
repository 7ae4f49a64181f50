// Angles of rotations in balls: that which rotations turn through on one segment, and its inverse.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "exact/ball.hpp"
#include "exact/ball_arc.hpp"
#include "exact/near_turn.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

/// The angle that rotations turn through on a segment.
template <class M>
class BallTurn {
 public:
  using B = BallOf<M>;

  /// `about_axes`: each is about one axis. Requires: `rotations` outlive it. Throws: Undecided where two points that
  /// are joined are nearly opposite, and `near` does not have it.
  void assign(std::span<const spline::RotationSegment<B>> rotations, bool about_axes, std::vector<NearTurn> near);

  const B& total() const { return total_; }
  B to(const spline::LocalParameter<B>& place) const;

  /// Where a length from the start is reached: a center, and the distance from it, which has digits of its own.
  struct Place {
    M center;
    B distance;
  };
  Place place(const B& length) const;

 private:
  using Ops = Middle<M>;
  using Bound = typename B::Bound;

  /// A place next to which the speed changes fast, or may do so.
  struct Center {
    M place;
    double size = 0;                 ///< of the part in which it changes most; 0: not known
    const NearTurn* near = nullptr;  ///< there, if any
  };

  /// A part of the segment next to a center, from one value of z to another one. Its places are at the distance
  /// scale z from the center; or 4 scale (1 + 3 z)/(4 - 3 z), so that a part from the distance `scale` to 16 times as
  /// much, or from 4 times as much, is as smooth in z as all others of this kind.
  struct Panel {
    std::size_t center;
    M scale, begin, end;
    bool is_constant = false;  ///< the speed is
    bool is_graded = false;
    B length = {}, before = {};
    M last_distance = {};             ///< that of its end
    std::vector<double> speeds = {};  ///< at the nodes of the rule, over the largest of them
  };
  /// A part of the segment on which the angles about axes are cubics.
  struct Cubics {
    B begin, width;
    BallArc<M> arc;
    B before;
  };
  struct Distance {
    B value, slope;  ///< by z
  };
  static constexpr int rough_parts = 32;

  void assign_cubics();
  std::vector<B> rates(const Center& center, const B& distance) const;
  B speed(const Panel& panel, const B& z) const;
  B sum(const Panel& panel, const B& z) const;
  static Distance distance(const Panel& panel, const B& z);
  std::vector<Center> centers(const std::function<double(double)>& speed) const;
  bool is_constant(const M& begin, const M& end) const;
  M rest_near(double place) const;
  bool measure(Panel& panel, const Bound& negligible) const;
  void add(Panel panel, int depth, const Bound& negligible);

  std::span<const spline::RotationSegment<B>> rotations_;
  std::vector<NearTurn> near_;
  std::vector<Center> centers_;
  std::vector<Panel> panels_;
  std::vector<Cubics> cubics_;  ///< instead of panels, where all rotations are about axes
  B total_;
};

extern template class BallTurn<spline::DoubleDouble>;
extern template class BallTurn<Real>;

}  // namespace tcb
