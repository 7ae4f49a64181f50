// Lengths in balls: those of one segment over its metric, and their inverse, as tcb/spline/segment_length.hpp has them
// for other scalars.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "exact/ball.hpp"
#include "exact/ball_angle.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segment_length.hpp"

namespace tcb {

/// The length of the path on a segment.
class BallArc {
 public:
  void assign(std::span<const spline::Cubic<Ball>> segment, std::span<const std::size_t> metric);

  const Ball& total() const { return total_; }
  /// From the start to a place.
  Ball to(const spline::LocalParameter<Ball>& place) const;
  /// Where a length from the start is reached.
  spline::LocalParameter<Ball> place(const Ball& length) const;

 private:
  /// A part of one half of the segment: the places middle + width z.
  struct Panel {
    std::size_t half;
    double middle, width;
    spline::Quartic<spline::DoubleDouble> square;  ///< of the speed over |place|^zeros, by the powers of z
    double spread;                                 ///< a bound on the error of the quartic for |z| <= 1
    double root;                                   ///< the root of the quartic at z = 0; 0: the panel is not smooth
    Ball length, before = {};                      ///< of the panel, and up to its start

    bool is_smooth() const { return root > 0; }
  };

  /// The derivatives of the channels by the local parameter about one end. All are 0 there to some order: they are
  /// these quadratics times the place to the power of `zeros`.
  struct Half {
    std::vector<spline::Quadratic<Ball>> channels;
    int zeros = 0;
  };

  Panel panel(std::size_t half, double middle, double width) const;
  void add(const Panel& panel, double negligible);
  template <class T>
  T sum(const Panel& panel, const T& z) const;
  Ball length(const Panel& panel, const spline::DoubleDouble& z) const;
  spline::DoubleDouble speed(const Panel& panel, const spline::DoubleDouble& z) const;
  double rough_place(const Panel& panel, double length) const;

  std::array<Half, 2> halves_;
  std::vector<Panel> panels_;
  Ball total_;
};

/// The angle that rotations turn through on a segment.
class BallTurn {
 public:
  void assign(std::span<const spline::RotationSegment<Ball>> rotations);

  const Ball& total() const { return total_; }
  Ball to(const spline::LocalParameter<Ball>& place) const;
  spline::LocalParameter<Ball> place(const Ball& length) const;

 private:
  struct Panel {
    double begin, width;
    Ball length, before = {};
  };

  Ball speed(const Ball& u) const;
  Ball sum(const Ball& begin, const Ball& width) const;
  void add(const Panel& panel, double negligible);

  std::span<const spline::RotationSegment<Ball>> rotations_;
  std::vector<Panel> panels_;
  Ball total_;
};

}  // namespace tcb

namespace tcb::spline {

/// Promises: balls that hold the lengths and places. Throws: Undecided where there is none.
template <>
class SegmentLength<Ball> {
 public:
  /// Requires: `rotations` outlive it.
  void assign(std::span<const Cubic<Ball>> cubics, std::span<const RotationSegment<Ball>> rotations,
              std::span<const std::size_t> metric) {
    is_turn_ = is_turn(metric);
    is_turn_ ? turn_.assign(rotations) : arc_.assign(cubics, metric);
  }

  Length<Ball> total() const { return {is_turn_ ? turn_.total() : arc_.total(), Ball()}; }
  Length<Ball> to(const LocalParameter<Ball>& place) const {
    return {is_turn_ ? turn_.to(place) : arc_.to(place), Ball()};
  }
  void places(const Ball& start, const Ball&, std::span<const Ball> lengths,
              std::span<LocalParameter<Ball>> places) const {
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      places[i] = is_turn_ ? turn_.place(lengths[i] - start) : arc_.place(lengths[i] - start);
    }
  }

 private:
  bool is_turn_ = false;
  BallArc arc_;
  BallTurn turn_;
};

}  // namespace tcb::spline
