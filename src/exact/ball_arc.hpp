// Lengths of paths in balls: that of the path on one segment, and its inverse.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "exact/ball.hpp"
#include "tcb/spline/arc_length.hpp"

namespace tcb {

/// The length of the path on a segment.
template <class M>
class BallArc {
 public:
  using B = BallOf<M>;

  void assign(std::span<const spline::Cubic<B>> segment, std::span<const std::size_t> metric);

  const B& total() const { return total_; }
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
  M first_guess(const Panel& panel, const B& into) const;

  std::array<Half, 2> halves_;
  std::vector<Panel> panels_;
  B total_;
  std::optional<spline::Cubic<B>> monotone_;  ///< the only channel that moves, if it does so in one direction
};

template <>
spline::DoubleDouble BallArc<spline::DoubleDouble>::sum(const Panel& panel, const spline::DoubleDouble& z) const;
extern template class BallArc<spline::DoubleDouble>;
extern template class BallArc<Real>;

}  // namespace tcb
