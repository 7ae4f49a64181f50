// Lengths in balls: those of one segment over its metric, and their inverse, as tcb/spline/segment_length.hpp has them
// for other scalars.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "exact/ball.hpp"
#include "exact/ball_angle.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segment_length.hpp"

namespace tcb {

/// A ball of double-doubles that holds a ball, and the other way round. Throws: Undecided for one beyond their range.
inline const Ball& ball_of(const Ball& ball) { return ball; }
Ball ball_of(const RealBall& ball);
template <class B>
B from_ball(const Ball& ball);

/// The length of the path on a segment.
template <class M>
class BallArc {
 public:
  using B = BallOf<M>;

  void assign(std::span<const spline::Cubic<B>> segment, std::span<const std::size_t> metric);

  const B& total() const { return total_; }
  /// From the start to a place.
  B to(const spline::LocalParameter<B>& place) const;
  /// Where a length from the start is reached.
  spline::LocalParameter<B> place(const B& length) const;

 private:
  using Ops = Middle<M>;
  using Bound = typename B::Bound;

  /// A part of one half of the segment: the places middle + width z.
  struct Panel {
    std::size_t half;
    M middle, width;
    spline::Quartic<M> square = {};  ///< of the speed over |place|^zeros, by the powers of z
    Bound spread = 0.0;              ///< a bound on the error of the quartic for |z| <= 1
    bool is_smooth = false;
    B length = {}, before = {};  ///< of the panel, and up to its start
  };

  /// The derivatives of the channels by the local parameter about one end. All are 0 there to some order: they are
  /// these quadratics times the place to the power of `zeros`.
  struct Half {
    std::vector<spline::Quadratic<B>> channels;
    int zeros = 0;
  };

  Panel panel(std::size_t half, const M& middle, const M& width) const;
  void add(const Panel& panel, const Bound& negligible);
  M sum(const Panel& panel, const M& z) const;
  B length(const Panel& panel, const M& z) const;
  M speed(const Panel& panel, const M& z) const;
  Bound farthest(const Panel& panel) const;
  double rough_place(const Panel& panel, double fraction) const;
  M first_guess(const Panel& panel, const B& into) const;

  std::array<Half, 2> halves_;
  std::vector<Panel> panels_;
  B total_;
  std::optional<spline::Cubic<B>> monotone_;  ///< the only channel that moves, if it does so in one direction
};

/// Whether the points of a rotation's curve between keys, each an arc from the first one, have one axis, as far as
/// balls tell: then it turns about that axis alone, but for the ways that it joins at each place, which may change
/// sides.
template <class B>
bool may_be_about_one_axis(const spline::RotationSegment<B>& rotation);

/// Next to a place at which two points that a rotation's curve joins are nearly opposite: the turn from one to the
/// other. Balls around the points do not tell it from others there, and it changes fast.
struct NearTurn {
  static constexpr std::size_t nodes = 11;
  static constexpr double step = 0x1p-16, reach = 5 * step;

  std::size_t rotation, pair;
  double place;
  double nearest = 0;  ///< the distance from the place at which the points are nearest to opposite
  double width = 0;    ///< of the part in which the turn changes most
  /// Those of Newton's polynomials of the vector of the turn by the distance from the place, at the nodes.
  std::array<spline::Vector3<Ball>, nodes> coefficients = {};

  /// 0, 1, -1, 2, -2 and so on steps.
  static double node(std::size_t i) {
    const double distance = step * static_cast<double>((i + 1) / 2);
    return i % 2 == 0 ? -distance : distance;
  }
};
/// Those of the rotations of a segment, where these are known to many digits.
std::vector<NearTurn> near_turns(std::span<const spline::RotationSegment<RealBall>> rotations);
inline std::vector<NearTurn> near_turns(std::span<const spline::RotationSegment<Ball>>) { return {}; }

/// The same turns in double-doubles, in the frame of the first rotation, so that small ones keep their digits.
spline::RotationSegment<Ball> from_start(const spline::RotationSegment<RealBall>& rotation);
inline const spline::RotationSegment<Ball>& from_start(const spline::RotationSegment<Ball>& rotation) {
  return rotation;
}

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

    bool touches() const { return !is_graded && (Ops::is_zero(begin) || Ops::is_zero(end)); }
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
  static double rough_place(const Panel& panel, double fraction);
  void add(Panel panel, int depth, const Bound& negligible);

  std::span<const spline::RotationSegment<B>> rotations_;
  std::vector<NearTurn> near_;
  std::vector<Center> centers_;
  std::vector<Panel> panels_;
  std::vector<Cubics> cubics_;  ///< instead of panels, where all rotations are about axes
  B total_;
};

template <>
spline::DoubleDouble BallArc<spline::DoubleDouble>::sum(const Panel& panel, const spline::DoubleDouble& z) const;
extern template class BallArc<spline::DoubleDouble>;
extern template class BallArc<Real>;
extern template class BallTurn<spline::DoubleDouble>;
extern template class BallTurn<Real>;

}  // namespace tcb

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
