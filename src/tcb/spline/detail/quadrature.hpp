// Gauss-Legendre quadrature: nodes and weights, computed for any scalar.
//
// Source: G. H. Golub, J. H. Welsch, "Calculation of Gauss quadrature rules", doi:10.1090/S0025-5718-69-99647-1.
// Differs: the roots of P_n are found by bisection between those of P_(n-1), which interlace with them, then by Newton
//   steps, the last ones in full precision, so that no trigonometric function is needed. They are symmetric about 0.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// An N-point rule on [0, 1]: the integral of f is about the sum of weight[i] f(node[i]).
template <class S, std::size_t N>
struct GaussRule {
  std::array<S, N> node{};
  std::array<S, N> weight{};
};

/// The Legendre polynomials P_n and P_(n-1) at x.
template <class W>
struct Legendre {
  W value, before;
};
template <class W>
constexpr Legendre<W> legendre(std::size_t n, const W& x) {
  if (n == 0) return {W(1), W(0)};
  W before(1);
  W value = x;
  for (std::size_t k = 2; k <= n; ++k) {
    const W next = (W(static_cast<double>(2 * k - 1)) * x * value - W(static_cast<double>(k - 1)) * before) /
                   W(static_cast<double>(k));
    before = value;
    value = next;
  }
  return {value, before};
}

/// The derivative of P_n at x in (-1, 1).
template <class W>
constexpr W legendre_slope(std::size_t n, const W& x) {
  const auto [value, before] = legendre(n, x);
  return W(static_cast<double>(n)) * (x * value - before) / (x * x - W(1));
}

/// The only root of P_n in (low, high), to most of a double's digits.
constexpr double legendre_root(std::size_t n, double low, double high) {
  const bool rising = legendre(n, high).value > 0;
  double middle = (low + high) / 2;
  for (int halving = 0; halving < 20; ++halving) {
    ((legendre(n, middle).value > 0) == rising ? high : low) = middle;
    middle = (low + high) / 2;
  }
  for (int step = 0; step < 3; ++step) middle = middle - legendre(n, middle).value / legendre_slope(n, middle);
  return middle;
}

/// A root in full precision, by the fewest Newton steps from a root in double precision.
template <class W>
constexpr W polished_root(std::size_t n, W root) {
  for (int right = 48; right < std::numeric_limits<W>::digits; right *= 2) {
    root = root - legendre(n, root).value / legendre_slope(n, root);
  }
  return root - legendre(n, root).value / legendre_slope(n, root);
}

template <class S, std::size_t N>
constexpr GaussRule<S, N> make_gauss_rule() {
  std::array<double, N + 2> fence{-1, 0, 1};  // -1, the roots of P_n, 1
  for (std::size_t n = 2; n <= N; ++n) {
    const auto previous = fence;
    for (std::size_t i = 1; i <= (n + 1) / 2; ++i) {
      const double root = legendre_root(n, previous[i - 1], previous[i]);
      fence[n + 1 - i] = -root;
      fence[i] = root;
    }
    fence[n + 1] = 1;
  }
  GaussRule<S, N> rule;
  const working_t<S> one(1), half(0.5);
  for (std::size_t i = 0; i < (N + 1) / 2; ++i) {
    const working_t<S> x = polished_root(N, working_t<S>(fence[i + 1]));
    const working_t<S> slope = legendre_slope(N, x);
    rule.node[N - 1 - i] = high_part<S>((one - x) * half);
    rule.node[i] = high_part<S>((x + one) * half);
    rule.weight[i] = rule.weight[N - 1 - i] = high_part<S>(one / ((one - x * x) * slope * slope));
  }
  return rule;
}

/// The rule, computed once.
template <class S, std::size_t N>
const GaussRule<S, N>& gauss_rule() {
  static const GaussRule<S, N> rule = make_gauss_rule<S, N>();
  return rule;
}

}  // namespace tcb::spline
