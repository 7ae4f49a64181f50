// Gauss-Legendre quadrature: nodes and weights, from tables for float and double, computed for other scalars.
//
// Source: G. H. Golub, J. H. Welsch, "Calculation of Gauss quadrature rules", doi:10.1090/S0025-5718-69-99647-1.
// Differs: the roots of P_n are found by bisection between those of P_(n-1), which interlace with them, then by Newton
//   steps, the last ones in full precision, so that no trigonometric function is needed. They are symmetric about 0.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

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
Legendre<W> legendre(std::size_t n, const W& x) {
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
W legendre_slope(std::size_t n, const W& x) {
  const auto [value, before] = legendre(n, x);
  return W(static_cast<double>(n)) * (x * value - before) / (x * x - W(1));
}

/// The only root of P_n in (low, high), to most of a double's digits.
inline double legendre_root(std::size_t n, double low, double high) {
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
W polished_root(std::size_t n, W root) {
  for (int right = 48; right < std::numeric_limits<W>::digits; right *= 2) {
    root = root - legendre(n, root).value / legendre_slope(n, root);
  }
  return root - legendre(n, root).value / legendre_slope(n, root);
}

/// The rule, computed.
template <class S, std::size_t N>
GaussRule<S, N> make_gauss_rule() {
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

/// The rules of make_gauss_rule<double, N>, in a table, as to compute them takes seconds of the compiler.
template <std::size_t N>
inline constexpr GaussRule<double, N> double_rule;
template <>
inline constexpr GaussRule<double, 8> double_rule<8>{
    {0.019855071751231884, 0.10166676129318664, 0.2372337950418355, 0.40828267875217511, 0.59171732124782495,
     0.7627662049581645, 0.89833323870681336, 0.98014492824876809},
    {0.050614268145188129, 0.11119051722668724, 0.15685332293894363, 0.181341891689181, 0.181341891689181,
     0.15685332293894363, 0.11119051722668724, 0.050614268145188129}};
template <>
inline constexpr GaussRule<double, 12> double_rule<12>{
    {0.0092196828766403748, 0.047941371814762573, 0.11504866290284765, 0.20634102285669129, 0.31608425050090988,
     0.43738329574426554, 0.56261670425573451, 0.68391574949909006, 0.79365897714330869, 0.88495133709715235,
     0.95205862818523745, 0.99078031712335968},
    {0.023587668193255914, 0.053469662997659213, 0.080039164271673111, 0.10158371336153296, 0.1167462682691774,
     0.12457352290670139, 0.12457352290670139, 0.1167462682691774, 0.10158371336153296, 0.080039164271673111,
     0.053469662997659213, 0.023587668193255914}};
template <>
inline constexpr GaussRule<double, 16> double_rule<16>{
    {0.0052995325041750333, 0.02771248846338371, 0.067184398806084122, 0.12229779582249849, 0.19106187779867811,
     0.27099161117138632, 0.35919822461037054, 0.45249374508118129, 0.54750625491881877, 0.64080177538962946,
     0.72900838882861374, 0.80893812220132189, 0.87770220417750155, 0.93281560119391582, 0.9722875115366163,
     0.99470046749582497},
    {0.013576229705877048, 0.031126761969323947, 0.047579255841246393, 0.062314485627766938, 0.074797994408288368,
     0.084578259697501268, 0.091301707522461792, 0.094725305227534251, 0.094725305227534251, 0.091301707522461792,
     0.084578259697501268, 0.074797994408288368, 0.062314485627766938, 0.047579255841246393, 0.031126761969323947,
     0.013576229705877048}};

/// The rule, with each number rounded to S.
template <class S, std::size_t N>
constexpr GaussRule<S, N> rounded(const GaussRule<double, N>& rule) {
  GaussRule<S, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result.node[i] = static_cast<S>(rule.node[i]);
    result.weight[i] = static_cast<S>(rule.weight[i]);
  }
  return result;
}

/// The rule, from the table or computed once.
template <class S, std::size_t N>
const GaussRule<S, N>& gauss_rule() {
  if constexpr ((std::is_same_v<S, double> || std::is_same_v<S, float>)&&(N == 8 || N == 12 || N == 16)) {
    static constexpr GaussRule<S, N> rule = rounded<S>(double_rule<N>);
    return rule;
  } else {
    static const GaussRule<S, N> rule = make_gauss_rule<S, N>();
    return rule;
  }
}

}  // namespace tcb::spline
