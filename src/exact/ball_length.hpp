// Lengths in balls: those of one segment over its metric, and their inverse, as tcb/spline/segment_length.hpp has them
// for other scalars.
#pragma once

#include <array>
#include <cstddef>
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

/// The angle that rotations turn through on a segment.
template <class M>
class BallTurn {
 public:
  using B = BallOf<M>;

  /// `about_axes`: each is about one axis. Requires: `rotations` outlive it.
  void assign(std::span<const spline::RotationSegment<B>> rotations, bool about_axes);

  const B& total() const { return total_; }
  B to(const spline::LocalParameter<B>& place) const;
  spline::LocalParameter<B> place(const B& length) const;

 private:
  using Ops = Middle<M>;
  using Bound = typename B::Bound;

  /// A part of the segment on which the speed is constant, or smooth enough for the rule.
  struct Panel {
    M begin, width;
    bool is_constant = false;
    B length = {}, before = {};

    M end() const { return begin + width; }
  };

  /// A part of the segment on which the angles about axes are cubics.
  struct Cubics {
    B begin, width;
    BallArc<M> arc;
    B before;
  };

  void assign_cubics();
  B speed(const B& u) const;
  B sum(const Panel& panel, const B& width) const;
  std::vector<M> rests() const;
  M rest_near(double place) const;
  bool is_constant(const M& begin, const M& end) const;
  void accept(Panel panel);
  void add(const Panel& panel, const Bound& negligible);

  std::span<const spline::RotationSegment<B>> rotations_;
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
    } else if (!in_double_doubles) {
      kind_ = Kind::turn;
      turn_.assign(rotations, about_axes);
    } else {
      kind_ = Kind::rough_turn;
      rough_rotations_.clear();
      for (const RotationSegment<B>& rotation : rotations) {
        rough_rotations_.push_back(rotation.template converted<Ball>([](const B& number) { return ball_of(number); }));
      }
      rough_turn_.assign(rough_rotations_, about_axes);
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
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const B length = lengths[i] - start;
      if (kind_ == Kind::rough_turn) {
        const LocalParameter<Ball> place = rough_turn_.place(ball_of(length));
        places[i] = {from_ball<B>(place.u), from_ball<B>(place.w)};
      } else {
        places[i] = kind_ == Kind::turn ? turn_.place(length) : arc_.place(length);
      }
    }
  }

 private:
  enum class Kind { arc, turn, rough_turn };

  Kind kind_ = Kind::arc;
  BallArc<M> arc_;
  BallTurn<M> turn_;
  std::vector<RotationSegment<Ball>> rough_rotations_;
  BallTurn<DoubleDouble> rough_turn_;
};

}  // namespace tcb::spline
