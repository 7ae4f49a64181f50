// Quadrature in balls: the Gauss-Legendre rules of double-doubles and of other floats, and places in panels, the parts
// of a segment under one rule.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "exact/real.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

/// A Gauss-Legendre rule on [0, 1]. Each number errs by at most a unit of its last digit.
template <class M>
struct BallRule {
  std::vector<M> node, weight;
};

/// A rule with an even number of points, for the digits in use.
template <class M>
const BallRule<M>& ball_rule();
template <>
const BallRule<spline::DoubleDouble>& ball_rule();
template <>
const BallRule<Real>& ball_rule();

/// The quotient of two numbers as a double, also where they are beyond the range of doubles.
double rough_ratio(const spline::DoubleDouble& a, const spline::DoubleDouble& b);
double rough_ratio(const Real& a, const Real& b);

/// The last panel that begins at a length or before it.
template <class Panel, class M>
const Panel& panel_at_length(const std::vector<Panel>& panels, const M& length) {
  const auto after =
      std::ranges::upper_bound(panels, length, {}, [](const Panel& panel) { return panel.before.middle(); });
  return after == panels.begin() ? *after : *(after - 1);
}

/// The place in [0, 1] up to which the integral of a speed is a fraction of the integral up to 1, nearly.
double rough_place(const std::function<double(double)>& speed, double fraction);

}  // namespace tcb
