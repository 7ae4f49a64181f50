// Panels: stretches of a segment short enough for one quadrature rule.
//
// With a panel mapped to z in [-1, 1], the square of the speed is a quartic q(z). Where q has no zero in a disc that
// is wide enough, the panel is smooth: the rule is right to the last digit, and q may be taken by its coefficients,
// whatever the number of channels, for nothing cancels.
// Source: L. N. Trefethen, "Is Gauss quadrature better than Clenshaw-Curtis?", doi:10.1137/060659831, theorem 4.5;
//   for the disc, G. Dandelin's and C. Graeffe's squaring of roots (V. Y. Pan, doi:10.1137/S0036144595288554, 4).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "spline/quadrature.hpp"
#include "spline/speed.hpp"

namespace tcb::spline {

/// A polynomial of fourth degree: its coefficients, from the constant up.
template <class T>
using Quartic = std::array<T, 5>;

/// Part of a half of a segment: its places are middle + width z.
template <class S>
struct Panel {
  std::size_t half;
  S middle, width;
  Quartic<S> square;         ///< of the speed, by the powers of z
  std::size_t points;        ///< of the rule that is right on it and on any part of it; 0: it is not smooth
  S length{};                ///< in units of Speed::unit(), as all lengths here
  working_t<S> before = {};  ///< the length up to its start

  bool is_smooth() const { return points != 0; }
};

/// The rules that panels are integrated by. What is not smooth takes the one with more points. Scalars with more digits
/// have more, so that the panels need not be much shorter.
template <class S>
inline constexpr std::size_t most_points = std::numeric_limits<S>::digits <= 64
                                               ? 16
                                               : std::bit_ceil(std::size_t{std::numeric_limits<S>::digits10} * 3 / 4);
template <class S>
inline constexpr std::size_t few_points = most_points<S> / 2;

/// The points that are enough from an end of a panel to places on its side of the middle. A disc of radius R about the
/// panel's middle holds one of radius 2 R - 1 about the middle of such a part, in terms of the part's width.
template <class S>
inline constexpr std::size_t part_points = std::numeric_limits<S>::digits <= 53 ? 12 : most_points<S>;

/// How often zeros are squared: the more often, the sharper the bound on the least one.
inline constexpr int squarings = 3;

/// The radius in which q must be free of zeros for a rule with N points (a power of two), to the power of 2^squarings.
///
/// Then the speed is analytic in the ellipse with foci -1, 1 and half axes' sum rho = R + sqrt(R^2 - 1), and there at
/// most 4 sqrt(q(0)): q(z) is q(0) times four factors 1 - z / zero. The rule errs by at most
/// 64/15 * 4 sqrt(q(0)) / (rho^2N - rho^(2N - 2)), which rho^2N = 32 / epsilon makes less than a rounding.
template <class S, std::size_t N>
const S& smooth_radius_power() {
  static const S power = [] {
    using std::sqrt;
    S rho = S(32) / std::numeric_limits<S>::epsilon();
    for (std::size_t root = 1; root < 2 * N; root *= 2) rho = sqrt(rho);
    S radius = (rho + S(1) / rho) * S(0.5);
    for (int squaring = 0; squaring < squarings; ++squaring) radius *= radius;
    return radius;
  }();
  return power;
}

/// The points that a panel's rule needs, by the zeros of q. Promises: never too few, and seldom more than the zeros ask
/// for within 1.2 times the radius.
template <class S>
std::size_t points_needed(const Quartic<S>& q) {
  using std::abs;
  if (!(q[0] > S(0))) return 0;
  const S unit = S(1) / q[0];
  S a1 = q[1] * unit, a2 = q[2] * unit, a3 = q[3] * unit, a4 = q[4] * unit;
  for (int squaring = 0; squaring < squarings; ++squaring) {  // a(z) a(-z), a polynomial in z^2: each zero is squared
    const S b1 = S(2) * a2 - a1 * a1;
    const S b2 = a2 * a2 + S(2) * (a4 - a1 * a3);
    const S b3 = S(2) * a2 * a4 - a3 * a3;
    a4 = a4 * a4;
    a3 = b3;
    a2 = b2;
    a1 = b1;
  }
  // There is no zero where the other terms are less than the first.
  const auto is_free = [&](const S& r) { return r * (abs(a1) + r * (abs(a2) + r * (abs(a3) + r * abs(a4)))) < S(1); };
  if (!is_free(smooth_radius_power<S, most_points<S>>())) return 0;
  return is_free(smooth_radius_power<S, few_points<S>>()) ? few_points<S> : most_points<S>;
}

template <class S>
Panel<S> make_panel(const Speed<S>& speed, std::size_t half, const S& begin, const S& end) {
  Panel<S> panel{half, (begin + end) * S(0.5), (end - begin) * S(0.5), {}, 0};
  panel.square = speed.square_about(half, panel.middle, panel.width);
  panel.points = points_needed(panel.square);
  return panel;
}

/// The quartic q about z, by the powers of a step from there.
template <class T>
Quartic<T> quartic_about(const Quartic<T>& q, const T& z) {
  return {q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * q[4]))),
          q[1] + z * (2.0 * q[2] + z * (3.0 * q[3] + z * (4.0 * q[4]))), q[2] + z * (3.0 * q[3] + z * (6.0 * q[4])),
          q[3] + z * (4.0 * q[4]), q[4]};
}

/// The square of the speed about a place on a panel, by the powers of a step in z.
template <class S>
Quartic<S> square_near(const Panel<S>& panel, const Speed<S>& speed, const S& z) {
  if (panel.is_smooth()) return quartic_about(panel.square, z);
  return speed.square_about(panel.half, panel.middle + panel.width * z, panel.width);
}

/// The sum of the terms, in pairs, so that rounding stays small.
template <class T, std::size_t N>
T sum_in_pairs(std::array<T, N>& terms) {
  for (std::size_t count = N; count > 1;) {
    const std::size_t kept = (count + 1) / 2;
    for (std::size_t i = 0; i < count - kept; ++i) terms[i] = terms[i] + terms[kept + i];
    count = kept;
  }
  return terms[0];
}

/// The integral of sqrt(q) over [begin, end] by an N-point Gauss-Legendre rule. S is the scalar of T.
template <class S, std::size_t N, class T>
T root_integral(const Quartic<T>& q, const T& begin, const T& end) {
  using std::sqrt;
  const auto& rule = gauss_rule<S, N>();
  const auto [q0, q1, q2, q3, q4] = q;
  const T width = end - begin;
  std::array<T, N> terms;
  for (std::size_t i = 0; i < N; ++i) {
    const T z = begin + width * rule.node[i];
    terms[i] = rule.weight[i] * sqrt(T(q0 + z * (q1 + z * (q2 + z * (q3 + z * q4)))));
  }
  return sum_in_pairs(terms) * width;
}

/// The length over [begin, end] of z by an N-point Gauss-Legendre rule.
template <std::size_t N, class S>
S gauss_sum(const Panel<S>& panel, const Speed<S>& speed, const S& begin, const S& end) {
  if (panel.is_smooth()) return root_integral<S, N>(panel.square, begin, end) * panel.width;
  const auto& rule = gauss_rule<S, N>();
  const S width = end - begin;
  std::array<S, N> terms;
  for (std::size_t i = 0; i < N; ++i) terms[i] = panel.middle + panel.width * (begin + width * rule.node[i]);
  terms = speed(panel.half, terms);
  for (std::size_t i = 0; i < N; ++i) terms[i] *= rule.weight[i];
  return sum_in_pairs(terms) * (width * panel.width);
}

/// The length over [begin, end] of z by the panel's rule.
template <class S>
S panel_sum(const Panel<S>& panel, const Speed<S>& speed, const S& begin, const S& end) {
  return panel.points == few_points<S> ? gauss_sum<few_points<S>>(panel, speed, begin, end)
                                       : gauss_sum<most_points<S>>(panel, speed, begin, end);
}

}  // namespace tcb::spline
