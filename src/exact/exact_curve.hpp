// The curve of exact keys at any scalar.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include "exact/ball.hpp"
#include "exact/exact_keys.hpp"
#include "exact/rounding.hpp"
#include "keys/prepare.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/curve_keys.hpp"

namespace tcb {

/// The power of a distance between exact positions: the square of the distance is exact.
template <class M>
struct DistancePower<BallOf<M>> {
  explicit DistancePower(const Rational&) {}
  void add_square(const Rational& a, const Rational& b) { sum_ += (b - a) * (b - a); }
  /// By the nested roots of spline::power_by_roots(). Requires: 0 <= exponent < 2^53.
  BallOf<M> power(double exponent) const {
    BallOf<M> x = sqrt(scalar_of<BallOf<M>>(sum_)), whole_part(1.0), root(1.0);
    double whole = std::floor(exponent), rest = exponent - whole;
    int bits = 0;
    for (; rest != std::floor(rest); rest *= 2) ++bits;
    const BallOf<M> root_of_x = sqrt(x);
    for (auto left = static_cast<std::uint64_t>(rest); bits > 0; --bits, left >>= 1) {
      root = (left & 1U) != 0 ? sqrt(root) * root_of_x : sqrt(root);
    }
    for (auto left = static_cast<std::uint64_t>(whole); left > 0; left >>= 1, x = x * x) {
      if ((left & 1U) != 0) whole_part = whole_part * x;
    }
    return whole_part * root;
  }

 private:
  Rational sum_ = 0;
};

/// The curve at a scalar. Requires: exact.is_rational(), or a scalar with roots.
template <class S>
std::unique_ptr<const spline::CurveKeys<S>> curve_at(const ExactCurve& exact);

extern template class spline::CurveKeys<Rational>;
extern template class spline::CurveKeys<Ball>;
extern template class spline::CurveKeys<RealBall>;

}  // namespace tcb
