// Panels: parts of a segment, each short enough for one quadrature rule.
//
// With a panel mapped to z in [-1, 1], the square of the speed is a quartic q(z). Where q has no zero in a disc that is
// wide enough, the panel is smooth: the rule is accurate to the last digit, and q can be evaluated by its coefficients
// for any number of channels, because nothing cancels.
// Source: L. N. Trefethen, "Is Gauss quadrature better than Clenshaw-Curtis?", doi:10.1137/060659831, theorem 4.5;
//   for the disc, G. Dandelin's and C. Graeffe's squaring of roots (V. Y. Pan, doi:10.1137/S0036144595288554, 4).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "tcb/spline/detail/quadrature.hpp"
#include "tcb/spline/detail/speed.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// A part of one half of a segment: the places middle + width z.
template <class S>
struct Panel {
  std::size_t half;
  S middle, width;
  Quartic<S> square;         ///< of the speed, by the powers of z
  std::size_t points;        ///< of the rule that is accurate on it and on any part of it; 0: it is not smooth
  S length{};                ///< in units of Speed::unit(), as all lengths here
  working_t<S> before = {};  ///< the length up to its start

  bool is_smooth() const { return points != 0; }
};

/// The points of the two rules that integrate panels. Panels that are not smooth take the rule with more points.
/// Scalars with more digits have rules with more points, so that the panels need not be much shorter.
template <class S>
inline constexpr std::size_t most_points = std::numeric_limits<S>::digits <= 64
                                               ? 16
                                               : std::bit_ceil(std::size_t{std::numeric_limits<S>::digits10} * 3 / 4);
template <class S>
inline constexpr std::size_t few_points = most_points<S> / 2;

/// The points that suffice from an end of a panel to places in the half next to it. A disc of radius R about the
/// panel's middle contains one of radius 2 R - 1 about the middle of such a part, in units of the part's width.
template <class S>
inline constexpr std::size_t part_points = std::numeric_limits<S>::digits <= 53 ? 12 : most_points<S>;

/// The number of times that zeros are squared; more give a sharper bound on the smallest zero.
inline constexpr int squarings = 3;

/// The radius in which q must be free of zeros for a rule with N points (a power of two), to the power of 2^squarings.
///
/// Then the speed is analytic in the ellipse with foci -1, 1 and semi-axes' sum rho = R + square_root(R^2 - 1), and
/// there at most 4 square_root(q(0)): q(z) is q(0) times four factors 1 - z / zero. The rule errs by at most 64/15 * 4
/// square_root(q(0)) / (rho^2N - rho^(2N - 2)), which is below a rounding for rho^2N = 32 / epsilon.
template <class S, std::size_t N>
const S& smooth_radius_power() {
  static const S power = [] {
    S rho = S(32) / std::numeric_limits<S>::epsilon();
    for (std::size_t root = 1; root < 2 * N; root *= 2) rho = square_root(rho);
    S radius = (rho + S(1) / rho) * S(0.5);
    for (int squaring = 0; squaring < squarings; ++squaring) radius *= radius;
    return radius;
  }();
  return power;
}

/// A bound on the terms of q after the first within a radius, relative to the first, after each zero has been squared
/// `squarings` times: where it is below 1, there is no zero within the radius.
template <class T>
class OtherTerms {
 public:
  explicit OtherTerms(const Quartic<T>& q) {
    const T unit = T(1.0) / q[0];
    a1_ = q[1] * unit, a2_ = q[2] * unit, a3_ = q[3] * unit, a4_ = q[4] * unit;
    for (int squaring = 0; squaring < squarings; ++squaring) {  // a(z) a(-z), a polynomial in z^2
      const T b1 = T(2.0) * a2_ - a1_ * a1_;
      const T b2 = a2_ * a2_ + T(2.0) * (a4_ - a1_ * a3_);
      const T b3 = T(2.0) * a2_ * a4_ - a3_ * a3_;
      a4_ = a4_ * a4_;
      a3_ = b3;
      a2_ = b2;
      a1_ = b1;
    }
  }

  /// `r`: the radius, to the power of 2^squarings. NaN where q(0) is 0.
  T within(const T& r) const {
    using std::abs;
    return r * (abs(a1_) + r * (abs(a2_) + r * (abs(a3_) + r * abs(a4_))));
  }

 private:
  T a1_, a2_, a3_, a4_;
};

/// The bounds of a panel.
template <class S>
struct Bounds {
  std::size_t half;
  S begin, end;

  S middle() const { return (begin + end) * S(0.5); }
  S width() const { return (end - begin) * S(0.5); }
};

/// The points that a panel's rule needs, by OtherTerms within the radius that each rule requires. Promises: never too
/// few, and seldom more than zeros within 1.2 times the radius require.
template <class S, class T>
std::size_t points_needed(const T& for_most, const T& for_few) {
  return for_few < S(1) ? few_points<S> : for_most < S(1) ? most_points<S> : 0;
}

template <class S>
Panel<S> make_panel(const Speed<S>& speed, const Bounds<S>& at) {
  const auto q = speed.square_about(at.half, at.middle(), at.width());
  const OtherTerms<S> others(q);
  const auto points = points_needed<S>(others.within(smooth_radius_power<S, most_points<S>>()),
                                       others.within(smooth_radius_power<S, few_points<S>>()));
  return {at.half, at.middle(), at.width(), q, points};
}

/// Two panels, computed as a pair where that saves time.
template <class S>
std::array<Panel<S>, 2> make_panels(const Speed<S>& speed, const Bounds<S>& a, const Bounds<S>& b) {
  if constexpr (has_pairs<S>) {
    const auto q = speed.squares_about({a.half, b.half}, {a.middle(), b.middle()}, {a.width(), b.width()});
    // The digits of doubles suffice, also of double-doubles.
    const OtherTerms<DoublePair> others({rough(q[0]), rough(q[1]), rough(q[2]), rough(q[3]), rough(q[4])});
    const auto within = [&others](const S& radius_power) { return others.within(rough(radius_power)); };
    const DoublePair for_most = within(smooth_radius_power<S, most_points<S>>());
    const DoublePair for_few = within(smooth_radius_power<S, few_points<S>>());
    const auto panel = [&](const Bounds<S>& at, std::size_t i) {
      return Panel<S>{at.half,
                      at.middle(),
                      at.width(),
                      {one_of(q[0], i), one_of(q[1], i), one_of(q[2], i), one_of(q[3], i), one_of(q[4], i)},
                      points_needed<S>(for_most[i], for_few[i])};
    };
    return {panel(a, 0), panel(b, 1)};
  } else {
    return {make_panel(speed, a), make_panel(speed, b)};
  }
}

/// The quartic q about z, in powers of a step from z.
template <class T>
Quartic<T> quartic_about(const Quartic<T>& q, const T& z) {
  return {q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * q[4]))),
          q[1] + z * (T(2.0) * q[2] + z * (T(3.0) * q[3] + z * (T(4.0) * q[4]))),
          q[2] + z * (T(3.0) * q[3] + z * (T(6.0) * q[4])), q[3] + z * (T(4.0) * q[4]), q[4]};
}

/// The square of the speed about a place on a panel, in powers of a step in z.
template <class S>
Quartic<S> square_near(const Panel<S>& panel, const Speed<S>& speed, const S& z) {
  if (panel.is_smooth()) return quartic_about(panel.square, z);
  return speed.square_about(panel.half, panel.middle + panel.width * z, panel.width);
}

/// The sum of the terms, added in pairs to keep the rounding error small.
template <class T, std::size_t N>
T sum_in_pairs(std::array<T, N>& terms) {
  for (std::size_t count = N; count > 1;) {
    const std::size_t kept = (count + 1) / 2;
    for (std::size_t i = 0; i < count - kept; ++i) terms[i] = terms[i] + terms[kept + i];
    count = kept;
  }
  return terms[0];
}

/// The integral of square_root(q) over [begin, end] by an N-point Gauss-Legendre rule. S is the scalar of T.
template <class S, std::size_t N, class T>
T root_integral(const Quartic<T>& q, const T& begin, const T& end) {
  const auto& rule = gauss_rule<S, N>();
  const T width = end - begin;
  if constexpr (std::is_same_v<T, DoubleDouble>) {  // two nodes as a pair
    static_assert(N % 2 == 0);
    const auto both = [](const T& x) { return pair_of(x, x); };
    const auto q0 = both(q[0]), q1 = both(q[1]), q2 = both(q[2]), q3 = both(q[3]), q4 = both(q[4]);
    const auto first = both(begin), widths = both(width);
    std::array<DoubleDoublePair, N / 2> terms;
    for (std::size_t i = 0; i < N / 2; ++i) {
      const auto z = first + widths * pair_of(rule.node[2 * i], rule.node[2 * i + 1]);
      const auto weight = pair_of(rule.weight[2 * i], rule.weight[2 * i + 1]);
      terms[i] = weight * square_root(q0 + z * (q1 + z * (q2 + z * (q3 + z * q4))));
    }
    const auto sum = sum_in_pairs(terms);
    return (one_of(sum, 0) + one_of(sum, 1)) * width;
  } else {
    const auto [q0, q1, q2, q3, q4] = q;
    std::array<T, N> terms;
    for (std::size_t i = 0; i < N; ++i) {
      const T z = begin + width * rule.node[i];
      terms[i] = rule.weight[i] * square_root(T(q0 + z * (q1 + z * (q2 + z * (q3 + z * q4)))));
    }
    return sum_in_pairs(terms) * width;
  }
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
