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

#include "tcb/spline/key.hpp"

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

/// What a tangent rule sees of a key with two neighbours.
template <class W>
struct InnerKey {
  Factors<W> f;
  W continuity;
  W h0, h1;  ///< durations of the segments before and after
};

/// Weights of the chords D0 and D1 in the two tangents of a key.
template <class W>
struct Weights {
  W in0, in1;
  W out0, out1;
};

/// The plain tangents in = (c D0 + d D1)/2, out = (a D0 + b D1)/2, each times a factor.
template <class W>
Weights<W> scaled_weights(const Factors<W>& f, const W& in, const W& out) {
  const W half_in = halved(in);
  const W half_out = halved(out);
  return {half_in * f.c, half_in * f.d, half_out * f.a, half_out * f.b};
}

template <class W>
Weights<W> velocity_weights(const InnerKey<W>& key) {
  return {halved(key.f.c), halved(key.f.d) * (key.h0 / key.h1), halved(key.f.a) * (key.h1 / key.h0), halved(key.f.b)};
}

template <class W>
Weights<W> uniform_weights(const InnerKey<W>& key) {
  return scaled_weights(key.f, W(1), W(1));
}

template <class W>
Weights<W> interval_weights(const InnerKey<W>& key) {
  const W mean = halved(W(key.h0 + key.h1));
  return scaled_weights(key.f, key.h0 / mean, key.h1 / mean);
}

template <class W>
Weights<W> interval_c_weights(const InnerKey<W>& key) {
  const W mean = halved(W(key.h0 + key.h1));
  const W c = key.continuity < W(0) ? -key.continuity : key.continuity;
  const auto blended = [&](const W& ratio) { return ratio + c * (W(1) - ratio); };
  return scaled_weights(key.f, blended(key.h0 / mean), blended(key.h1 / mean));
}

template <class W>
Weights<W> finite_difference_weights(const InnerKey<W>& key) {
  const W& h0 = key.h0;
  const W& h1 = key.h1;
  const W both = h0 + h1;
  return {key.f.c * (h1 / both), key.f.d * (h0 * h0 / (h1 * both)), key.f.a * (h1 * h1 / (h0 * both)),
          key.f.b * (h0 / both)};
}

template <class W>
Weights<W> kb1984_weights(const InnerKey<W>& key) {
  const W mean = halved(W(key.h0 + key.h1));
  return scaled_weights(key.f, key.h1 / mean, key.h0 / mean);
}

template <class W>
Weights<W> synfig_weights(const InnerKey<W>& key) {
  const W scale(1.5);
  return scaled_weights(key.f, scale * key.h0 / (halved(key.h0) + key.h1), scale * key.h1 / (halved(key.h1) + key.h0));
}

/// A tangent rule, and what the manual says of it. Uin = (c D0 + d D1)/2, Uout = (a D0 + b D1)/2.
template <class S>
struct TangentRule {
  using W = working_t<S>;
  std::string_view name;
  std::string_view incoming, outgoing;  ///< formulas
  std::string_view used_by;
  std::string_view choose;  ///< when to
  Weights<W> (*weights)(const InnerKey<W>&);
};

/// Every tangent rule by name; the first is the default.
/// Source: D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", equations 10 and 11, for velocity, and
///   its older version, equations 3 and 4, for kb1984; for the others, what the products named compute.
template <class S>
inline constexpr std::array tangent_rules{
    TangentRule<S>{"velocity", "h0/2 (c D0/h0 + d D1/h1)", "h1/2 (a D0/h0 + b D1/h1)",
                   "GTE since 2022-08, FBX, MotionBuilder",
                   "for new work: velocities of both sides are averaged, so uneven times do not jerk",
                   velocity_weights<working_t<S>>},
    TangentRule<S>{"uniform", "Uin", "Uout", "the encyclopaedia article, Noskowicz, OGRE, WorldEdit, s&box",
                   "for shapes without times, or to match code that ignores them; the speed jumps where steps differ",
                   uniform_weights<working_t<S>>},
    TangentRule<S>{"interval", "Uin 2 h0/(h0+h1)", "Uout 2 h1/(h0+h1)",
                   "VTK, LightWave, Wild Magic and GTE until 2022-01, Gamebryo, id Tech 4",
                   "to match these; the direction ignores the times, the speed does not",
                   interval_weights<working_t<S>>},
    TangentRule<S>{"interval-c", "Uin (f + |C|(1-f)), f = 2 h0/(h0+h1)", "Uout (g + |C|(1-g)), g = 2 h1/(h0+h1)",
                   "3D Studio, 3ds Max, lib3ds, NeL, CryEngine",
                   "to match these: interval where C = 0, uniform where |C| = 1", interval_c_weights<working_t<S>>},
    TangentRule<S>{"finite-difference", "h0 (c h1 D0/h0 + d h0 D1/h1)/(h0+h1)", "h1 (a h1 D0/h0 + b h0 D1/h1)/(h0+h1)",
                   "the Python package splines",
                   "for measured data at uneven times: at T = C = B = 0 the non-uniform Catmull-Rom spline",
                   finite_difference_weights<working_t<S>>},
    TangentRule<S>{"kb1984", "Uin 2 h1/(h0+h1)", "Uout 2 h0/(h0+h1)",
                   "the paper of 1984, and the older note on it, as printed",
                   "to reproduce the paper; its multipliers stand the other way round from interval",
                   kb1984_weights<working_t<S>>},
    TangentRule<S>{"synfig", "Uin 1.5 h0/(h0/2+h1)", "Uout 1.5 h1/(h1/2+h0)", "Synfig", "to match Synfig",
                   synfig_weights<working_t<S>>},
};

}  // namespace tcb::spline
