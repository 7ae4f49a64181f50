// Segments: the cubic of one channel between two keys, its positions, parts and derivatives.
//
//   X(u) = P0 + u (out + u (c + u d))          c = 3 D - 2 out - in,   D = P1 - P0
//        = P1 + w (in  + w (e + w d))          e = out + 2 in - 3 D,   w = u - 1
//   d = out + in - 2 D
// This is the same cubic, expanded about each end; the expansion about the nearer end is used, so that |u| or |w| is at
// most 1/2 and the positions of both keys are exact.
// Source: the Hermite form of D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", section 2.
#pragma once

#include <cmath>
#include <type_traits>

#include "tcb/spline/double_pair.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// A length, and a bound on its error.
template <class S>
struct Length {
  S value{};
  S error{};
};

/// The local parameter: u from the start of a segment, and w = u - 1 from its end, each rounded once.
template <class S>
struct LocalParameter {
  S u{};
  S w{-1};

  bool near_start() const { return u <= S(0.5); }
};

/// The local parameter u, or 1 - left.
template <class S>
LocalParameter<S> from_start(const working_t<S>& u) {
  return {high_part<S>(u), high_part<S>(u + S(-1))};
}
template <class S>
LocalParameter<S> from_end(const working_t<S>& left) {
  return {high_part<S>(-left + S(1)), high_part<S>(-left)};
}

/// One channel of a segment.
template <class S>
struct Cubic {
  S p0, out, c, c_low;  ///< about the start; c_low is the low part of c
  S p1, in, e, e_low;   ///< about the end
  S d;
};

/// The cubic from p0 to p1 with the given local tangents. For doubles a coefficient is set to 0 if it is within the
/// rounding error of its terms, so that a natural end has no acceleration and a straight segment no curvature.
/// If the chord differs from p1 - p0 by whole turns, the expansions about the two ends differ by these turns too.
template <class S>
Cubic<S> cubic(const S& p0, const S& p1, const working_t<S>& chord, const working_t<S>& out, const working_t<S>& in) {
  using W = working_t<S>;
  [[maybe_unused]] double residue = 0;
  if constexpr (std::is_same_v<S, double>) {
    residue = 0x1p-96 * std::abs(chord.hi) + 0x1p-96 * std::abs(out.hi) + 0x1p-96 * std::abs(in.hi);
  }
  const auto cleared = [&](const W& value) {
    if constexpr (std::is_same_v<S, double>) {
      if (value.hi < residue && -value.hi < residue) return W(0);
    }
    return value;
  };
  const W out_excess = out - chord;
  const W in_excess = in - chord;
  const W d = cleared(out_excess + in_excess);
  const W c = cleared(-(out_excess + d));
  const W e = cleared(in_excess + d);
  return {p0,
          high_part<S>(out),
          high_part<S>(c),
          low_part<S>(c),
          p1,
          high_part<S>(in),
          high_part<S>(e),
          low_part<S>(e),
          high_part<S>(d)};
}

template <class S>
Cubic<S> cubic(const S& p0, const S& p1, const working_t<S>& out, const working_t<S>& in) {
  return cubic<S>(p0, p1, exact_difference(p1, p0), out, in);
}

/// base + x (a + x (b + x d)): Horner's rule that also carries the rounding errors of its two inner sums.
template <class S>
S compensated_cubic(const S& base, const S& a, const S& b, const S& b_rest, const S& d, const S& x) {
  const auto inner = two_sum<S>(b, x * d);
  const auto slope = two_sum<S>(a, x * inner.value);
  return base + (x * slope.value + x * (x * (inner.error + b_rest) + slope.error));
}

/// X. Promises: within 3 ulp of the largest of |P0|, |P1|, |out|, |in|; exact at both ends.
template <class S>
S position(const Cubic<S>& x, const LocalParameter<S>& at) {
  if (at.u == S(0)) return x.p0;
  if (at.w == S(0)) return x.p1;
  return at.near_start() ? compensated_cubic(x.p0, x.out, x.c, x.c_low, x.d, at.u)
                         : compensated_cubic(x.p1, x.in, x.e, x.e_low, x.d, at.w);
}

/// Whether two places can be evaluated as a pair: both are nearer to the same end, and neither is an end.
inline bool can_pair(const LocalParameter<double>& a, const LocalParameter<double>& b) {
  return a.near_start() == b.near_start() && a.u != 0 && b.u != 0 && a.w != 0 && b.w != 0;
}

/// X at two places. Requires: can_pair().
inline DoublePair positions(const Cubic<double>& x, const LocalParameter<double>& a, const LocalParameter<double>& b) {
  const bool start = a.near_start();
  return compensated_cubic<DoublePair>(start ? x.p0 : x.p1, start ? x.out : x.in, start ? x.c : x.e,
                                       start ? x.c_low : x.e_low, x.d,
                                       start ? DoublePair(a.u, b.u) : DoublePair(a.w, b.w));
}

/// The part of a segment from one time to another, as a segment of its own.
template <class S>
Cubic<S> part(const Cubic<S>& whole, const Time<S>& start, const Time<S>& end, const Time<S>& from, const Time<S>& to) {
  using W = working_t<S>;
  if (from == start && to == end) return whole;
  const W out(whole.out), c = W(whole.c) + W(whole.c_low), d(whole.d);
  const W first = (from - start) / (end - start), last = (to - start) / (end - start);
  const auto value = [&](const W& u) { return W(whole.p0) + u * (out + u * (c + u * d)); };
  const auto slope = [&](const W& u) { return (out + u * (W(2) * c + u * (W(3) * d))) * (last - first); };
  return cubic<S>(high_part<S>(value(first)), to == end ? whole.p1 : high_part<S>(value(last)), slope(first),
                  slope(last));
}

/// The part of a segment, as part() has it, with the derivatives of the whole at its ends: its coefficients have few
/// rounding errors, also where it is short, but it meets its end, or its middle from both sides, only within a few
/// units in the last place.
template <class S>
Cubic<S> expanded_part(const Cubic<S>& whole, const Time<S>& start, const Time<S>& end, const Time<S>& from,
                       const Time<S>& to) {
  if (from == start && to == end) return whole;
  using W = working_t<S>;
  struct Derivatives {
    W slope, half_bend;
  };
  const W h = elapsed<S>(start, end), size = elapsed<S>(from, to) / h;
  const auto at = [&](const Time<S>& t) -> Derivatives {
    const W passed = elapsed<S>(start, t), left = elapsed<S>(t, end);
    const bool near_start = passed < left;
    const W u = (near_start ? passed : -left) / h, cubic = W(3) * u * W(whole.d);
    const W first = near_start ? whole.out : whole.in;
    const W second = near_start ? W(whole.c) + W(whole.c_low) : W(whole.e) + W(whole.e_low);
    return {(first + u * (second + second + cubic)) * size, (second + cubic) * size * size};
  };
  Cubic<S> result = part(whole, start, end, from, to);
  const Derivatives first = at(from), last = at(to);
  result.out = high_part<S>(first.slope);
  result.c = high_part<S>(first.half_bend);
  result.c_low = low_part<S>(first.half_bend);
  result.in = high_part<S>(last.slope);
  result.e = high_part<S>(last.half_bend);
  result.e_low = low_part<S>(last.half_bend);
  result.d = high_part<S>(W(whole.d) * size * size * size);
  return result;
}

/// dX/du.
template <class S>
S first_derivative(const Cubic<S>& x, const LocalParameter<S>& at) {
  return at.near_start() ? x.out + at.u * (S(2) * x.c + at.u * (S(3) * x.d))
                         : x.in + at.w * (S(2) * x.e + at.w * (S(3) * x.d));
}

}  // namespace tcb::spline
