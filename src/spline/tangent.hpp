// Tangent rules: how tension, continuity, bias and the steps on both sides make a key's tangents.
//
// With D0, D1 the chords before and after the key and h0, h1 their durations, every rule has the form
//   incoming = in0 D0 + in1 D1,   outgoing = out0 D0 + out1 D1
// and so is a pure function from (h0, h1, T, C, B) to four weights, the same for all channels.
// Units: tangents are local, per u of the segment that they belong to.
// To add a rule: a function and a row of tangent_rules.
#pragma once

#include <array>
#include <string_view>

#include "spline/key.hpp"

namespace tcb::spline {

/// The four factors that tension, continuity and bias give the chords, in the letters of the papers.
template <class W>
struct Factors {
  W a, b;  ///< outgoing: a = (1-T)(1+C)(1+B) for D0, b = (1-T)(1-C)(1-B) for D1
  W c, d;  ///< incoming: c = (1-T)(1-C)(1+B) for D0, d = (1-T)(1+C)(1-B) for D1
};

template <class S>
Factors<working_t<S>> factors(const Tcb<S>& tcb) {
  using W = working_t<S>;
  const W one(1);
  const W loose = one - W(tcb.tension);
  const W plus = loose * (one + W(tcb.continuity));
  const W minus = loose * (one - W(tcb.continuity));
  const W after = one + W(tcb.bias);
  const W before = one - W(tcb.bias);
  return {plus * after, minus * before, minus * after, plus * before};
}

/// Weights of the chords D0 and D1 in the two tangents of a key.
template <class W>
struct Weights {
  W in0, in1;
  W out0, out1;
};

template <class S>
struct TangentRule {
  using W = working_t<S>;
  std::string_view name;
  std::string_view formula;
  std::string_view used_by;
  Weights<W> (*weights)(const Factors<W>&, const W& h0, const W& h1);
};

/// in = h0 ½(c D0/h0 + d D1/h1), out = h1 ½(a D0/h0 + b D1/h1): velocities of both sides averaged.
/// Source: D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", equations 10 and 11.
template <class W>
Weights<W> velocity_weights(const Factors<W>& f, const W& h0, const W& h1) {
  const W half(0.5);
  return {half * f.c, half * f.d * (h0 / h1), half * f.a * (h1 / h0), half * f.b};
}

/// Every tangent rule by name; the first is the default.
template <class S>
inline constexpr std::array tangent_rules{
    TangentRule<S>{"velocity", "in = h0/2 (c D0/h0 + d D1/h1), out = h1/2 (a D0/h0 + b D1/h1)",
                   "GTE since 2022-08, FBX, MotionBuilder", velocity_weights<working_t<S>>},
};

}  // namespace tcb::spline
