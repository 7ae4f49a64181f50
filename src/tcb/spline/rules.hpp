// Rules: the tables of tangent rules, end rules and presets.
//
// Tangent rules, at a key with two neighbours. With D0, D1 the chords before and after the key and h0, h1 their
// durations, every rule has the form
//   incoming = in0 D0 + in1 D1,   outgoing = out0 D0 + out1 D1
// and so is a pure function from (h0, h1, T, C, B) to four weights, the same for all channels.
// End rules, at the first and the last key of an open curve. With D the chord of the end segment, m the other tangent
// of that segment and V a given velocity, every rule has the form
//   tangent = chord D + other m + given V
// and so is a pure function from (h, T, C, B) to three weights, the same for all channels.
// Units: tangents are local, per u of the segment that they belong to.
// To add a rule: an enumerator, a function that gives the weights, and a row of the table at the same place.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tcb/spline/curve_rules.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation_curve.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// The tangent rules; tangent_rules has a row for each, in this order.
enum class TangentRule : std::uint8_t {
  velocity,
  uniform,
  interval,
  interval_c,
  finite_difference,
  kb1984,
  synfig,
  linear
};

/// The end rules; end_rules has a row for each, in this order.
enum class EndRule : std::uint8_t {
  one_sided,
  half,
  mirror,
  chord,
  zero,
  natural,
  natural_tension,
  cry,
  lightwave,
  velocity
};

/// The presets; presets has a row for each, in this order.
enum class Preset : std::uint8_t {
  tcb,
  gte,
  fbx,
  gte2021,
  wildmagic,
  lightwave,
  vtk,
  gamebryo,
  idtech4,
  max3ds,  ///< "3dsmax"
  nel,
  cryengine,
  lib3ds1,
  lib3ds2,
  splines,
  nerfstudio,
  synfig,
  kb1984,
  wikipedia,
  ogre,
  threejs,
  godot
};

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

/// The input of a tangent rule: a key with two neighbours.
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

/// Straight lines, whatever tension, continuity and bias are.
template <class W>
Weights<W> linear_weights(const InnerKey<W>&) {
  return {W(1), W(0), W(0), W(1)};
}

/// A tangent rule and its description. Uin = (c D0 + d D1)/2, Uout = (a D0 + b D1)/2.
template <class S>
struct TangentRuleRow {
  using W = working_t<S>;
  TangentRule id;
  std::string_view name;
  std::string_view incoming, outgoing;  ///< formulas
  std::string_view used_by;
  std::string_view choose;  ///< when to choose the rule: goes on after "Choose it"
  Weights<W> (*weights)(const InnerKey<W>&);
};

/// Every tangent rule; the first is the default.
/// Source: D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", equations 10 and 11, for velocity, and
///   its older version, equations 3 and 4, for kb1984; for the others, the behaviour of the products named.
template <class S>
inline constexpr std::array tangent_rules{
    TangentRuleRow<S>{TangentRule::velocity, "velocity", "h0/2 (c D0/h0 + d D1/h1)", "h1/2 (a D0/h0 + b D1/h1)",
                      "GTE since 2022-08, FBX, MotionBuilder",
                      "for new work: it averages the velocities on both sides, so that uneven times cause no jump",
                      velocity_weights<working_t<S>>},
    TangentRuleRow<S>{
        TangentRule::uniform, "uniform", "Uin", "Uout", "Wikipedia, Noskowicz, OGRE, WorldEdit, s&box",
        "for shapes without times, or to match code that ignores times; the speed jumps where durations differ",
        uniform_weights<working_t<S>>},
    TangentRuleRow<S>{TangentRule::interval, "interval", "Uin 2 h0/(h0+h1)", "Uout 2 h1/(h0+h1)",
                      "VTK, LightWave, Wild Magic and GTE until 2022-01, Gamebryo, id Tech 4",
                      "to match these products; the times affect the speed, but not the direction",
                      interval_weights<working_t<S>>},
    TangentRuleRow<S>{TangentRule::interval_c, "interval-c", "Uin (f + |C|(1-f)), f = 2 h0/(h0+h1)",
                      "Uout (g + |C|(1-g)), g = 2 h1/(h0+h1)", "3D Studio, 3ds Max, lib3ds, NeL, CryEngine",
                      "to match these products: it equals interval where C = 0, and uniform where |C| = 1",
                      interval_c_weights<working_t<S>>},
    TangentRuleRow<S>{TangentRule::finite_difference, "finite-difference", "h0 (c h1 D0/h0 + d h0 D1/h1)/(h0+h1)",
                      "h1 (a h1 D0/h0 + b h0 D1/h1)/(h0+h1)", "the Python package splines",
                      "for measured data at uneven times: at T = C = B = 0 it is the non-uniform Catmull-Rom spline",
                      finite_difference_weights<working_t<S>>},
    TangentRuleRow<S>{TangentRule::kb1984, "kb1984", "Uin 2 h1/(h0+h1)", "Uout 2 h0/(h0+h1)",
                      "the paper of 1984 as printed, and the older version of Eberly's note on it",
                      "to reproduce the paper; the multipliers are those of interval with h0 and h1 exchanged",
                      kb1984_weights<working_t<S>>},
    TangentRuleRow<S>{TangentRule::synfig, "synfig", "Uin 1.5 h0/(h0/2+h1)", "Uout 1.5 h1/(h1/2+h0)", "Synfig",
                      "to match Synfig", synfig_weights<working_t<S>>},
    TangentRuleRow<S>{TangentRule::linear, "linear", "D0", "D1", "LINEAR of glTF, polylines",
                      "for straight lines between keys, each at constant speed: T, C and B do not matter, the tangents "
                      "at the ends are chords, whatever the end rule is, and rotations turn by slerp",
                      linear_weights<working_t<S>>},
};

/// The input of an end rule: the end key. The factors are those of the outer tangent; each is named after the chord
/// that it multiplies: the segment's own, or the missing one beyond the end.
template <class W>
struct EndKey {
  W own;      ///< b at the first key, c at the last
  W missing;  ///< a at the first key, d at the last
  W tension;
  W h;            ///< duration of the end segment
  bool two_keys;  ///< the curve has no other segment, so m is also the tangent of an end
};

template <class W>
struct EndWeights {
  W chord, other, given;
};

template <class W>
EndWeights<W> one_sided_weights(const EndKey<W>& key) {
  return {key.own, W(0), W(0)};
}

template <class W>
EndWeights<W> half_weights(const EndKey<W>& key) {
  return {W(0.5) * key.own, W(0), W(0)};
}

template <class W>
EndWeights<W> mirror_weights(const EndKey<W>& key) {
  return {W(0.5) * (key.own + key.missing), W(0), W(0)};
}

template <class W>
EndWeights<W> chord_weights(const EndKey<W>&) {
  return {W(1), W(0), W(0)};
}

template <class W>
EndWeights<W> zero_weights(const EndKey<W>&) {
  return {W(0), W(0), W(0)};
}

template <class W>
EndWeights<W> natural_weights(const EndKey<W>& key) {
  if (key.two_keys) return {W(1), W(0), W(0)};
  return {W(1.5), W(-0.5), W(0)};
}

template <class W>
EndWeights<W> natural_tension_weights(const EndKey<W>& key) {
  const W loose = W(1) - key.tension;
  if (key.two_keys) return {loose, W(0), W(0)};
  return {W(1.5) * loose, W(-0.5) * loose, W(0)};
}

template <class W>
EndWeights<W> cry_weights(const EndKey<W>& key) {
  const W loose = W(1) - key.tension;
  if (key.two_keys) return {loose, W(0), W(0)};
  return {W(1.5) * loose, W(-1.5) * loose, W(0)};
}

template <class W>
EndWeights<W> lightwave_weights(const EndKey<W>& key) {
  return {key.own * key.h / (key.h + W(1) / W(3600)), W(0), W(0)};
}

template <class W>
EndWeights<W> given_velocity_weights(const EndKey<W>& key) {
  return {W(0), W(0), key.h};
}

/// An end rule and its description.
template <class S>
struct EndRuleRow {
  using W = working_t<S>;
  EndRule id;
  std::string_view name;
  std::string_view outgoing, incoming;  ///< formulas for the first and the last key
  std::string_view used_by;             ///< products, or for a rule of its own what it takes
  std::string_view choose;              ///< when to choose the rule: goes on after "Choose it"
  bool takes_velocity;                  ///< written name=V...
  EndWeights<W> (*weights)(const EndKey<W>&);
};

/// Every end rule; the first is the default.
/// Source: the behaviour of the products named.
template <class S>
inline constexpr std::array end_rules{
    EndRuleRow<S>{EndRule::one_sided, "one-sided", "b D", "c D", "FBX, Wild Magic, LightWave SDK",
                  "as the default: straight motion at constant speed stays straight; the curve behaves as if the end "
                  "position were repeated at the same time",
                  false, one_sided_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::half, "half", "b D/2", "c D/2", "GTE since 2022-08, OGRE, WorldEdit",
                  "to match these products: the curve behaves as if the end position were repeated, and bends straight "
                  "motion in its first and last segment",
                  false, half_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::mirror, "mirror", "(a+b) D/2", "(c+d) D/2", "Gamebryo, id Tech 4, lib3ds 2",
                  "to match these products: the curve behaves as if the neighbour were mirrored at the end, so that C "
                  "and B cancel",
                  false, mirror_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::chord, "chord", "D", "D", "lib3ds 1, Synfig",
                  "to point straight at the neighbour, whatever T, C and B are", false, chord_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::zero, "zero", "0", "0", "VTK by default", "to start and stop at rest", false,
                  zero_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::natural, "natural", "1.5 D - 0.5 m", "1.5 D - 0.5 m",
                  "the Python package splines, and VTK's constraint 2 with three keys or more",
                  "for smooth data: the second derivative is 0 at the end", false, natural_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::natural_tension, "natural-tension", "(1-T)(3 D - m)/2", "(1-T)(3 D - m)/2",
                  "3ds Max, NeL, CryMovie", "to match these products: natural, slowed by the tension of the end key",
                  false, natural_tension_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::cry, "cry", "1.5 (1-T)(D - m)", "1.5 (1-T)(D - m)", "CryEngine", "to match CryEngine", false,
                  cry_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::lightwave, "lightwave", "b D h/(h + 1/3600)", "c D h/(h + 1/3600)",
                  "LightWave's own files, with times in seconds", "to match LightWave", false,
                  lightwave_weights<working_t<S>>},
    EndRuleRow<S>{EndRule::velocity, "velocity", "h V", "h V",
                  "a velocity V per unit of time, with one number for each channel",
                  "to join a known motion, as in velocity=1:0,zero", true, given_velocity_weights<working_t<S>>},
};

/// How the local parameter of a segment follows from time, where keys have no ease: evenly, or by the monotone cubic
/// from the times of keys to their numbers, so that the speed of tangents without times has no jumps.
/// See detail/time_slopes.hpp.
enum class Timing : std::uint8_t { even, monotone };

/// A preset: the tangent rule, the end rule, the rules of rotations and the timing of a product, under one name.
struct PresetRow {
  Preset id;
  std::string_view name;
  TangentRule tangents;
  EndRule ends;
  std::string_view product;
  RotationRules rotations = {};
  Timing timing = Timing::even;
};

/// Every preset; the first is the default.
/// Source: of the rules of rotations, the sources of NeL (quaternion keys), CryEngine (TCBAngAxisKey), lib3ds, the
///   Python package splines, three.js (QuaternionKeyframeTrack) and VTK (vtkQuaternionInterpolator, which has no T, C,
///   B); of 3ds Max, those of NeL and CryEngine, which read its keys.
inline constexpr std::array presets{
    PresetRow{Preset::tcb, "tcb", TangentRule::velocity, EndRule::one_sided, "no product: the default"},
    PresetRow{Preset::gte, "gte", TangentRule::velocity, EndRule::half, "Geometric Tools (GTE) since 2022-08"},
    PresetRow{Preset::fbx, "fbx", TangentRule::velocity, EndRule::one_sided, "FBX, MotionBuilder"},
    PresetRow{Preset::gte2021, "gte2021", TangentRule::interval, EndRule::one_sided,
              "Geometric Tools (GTE) until 2022-01"},
    PresetRow{Preset::wildmagic, "wildmagic", TangentRule::interval, EndRule::one_sided, "Wild Magic"},
    PresetRow{Preset::lightwave, "lightwave", TangentRule::interval, EndRule::lightwave,
              "LightWave 3D; give times in seconds"},
    PresetRow{Preset::vtk,
              "vtk",
              TangentRule::interval,
              EndRule::zero,
              "VTK with its default ends",
              {.tangents = TangentRule::uniform, .ends = EndRule::chord}},
    PresetRow{Preset::gamebryo, "gamebryo", TangentRule::interval, EndRule::mirror, "Gamebryo, NetImmerse (NIF files)"},
    PresetRow{Preset::idtech4, "idtech4", TangentRule::interval, EndRule::mirror, "id Tech 4"},
    PresetRow{Preset::max3ds,
              "3dsmax",
              TangentRule::interval_c,
              EndRule::natural_tension,
              "3ds Max; give its ease in columns",
              {.ends = EndRule::mirror}},
    PresetRow{Preset::nel,
              "nel",
              TangentRule::interval_c,
              EndRule::natural_tension,
              "NeL; give its ease in columns",
              {.ends = EndRule::mirror}},
    PresetRow{Preset::cryengine,
              "cryengine",
              TangentRule::interval_c,
              EndRule::cry,
              "CryEngine; give its ease in columns",
              {.ends = EndRule::mirror}},
    PresetRow{Preset::lib3ds1, "lib3ds1", TangentRule::interval_c, EndRule::chord, "lib3ds 1"},
    PresetRow{Preset::lib3ds2, "lib3ds2", TangentRule::interval_c, EndRule::mirror, "lib3ds 2"},
    PresetRow{Preset::splines,
              "splines",
              TangentRule::finite_difference,
              EndRule::natural,
              "the Python package splines",
              {.curve = RotationCurve::casteljau}},
    PresetRow{Preset::nerfstudio,
              "nerfstudio",
              TangentRule::uniform,
              EndRule::natural,
              "the camera paths of nerfstudio",
              {.curve = RotationCurve::casteljau},
              Timing::monotone},
    PresetRow{Preset::synfig, "synfig", TangentRule::synfig, EndRule::chord, "Synfig"},
    PresetRow{Preset::kb1984, "kb1984", TangentRule::kb1984, EndRule::half, "the paper of 1984 as printed"},
    PresetRow{Preset::wikipedia, "wikipedia", TangentRule::uniform, EndRule::half, "Wikipedia"},
    PresetRow{Preset::ogre, "ogre", TangentRule::uniform, EndRule::half, "OGRE Procedural"},
    PresetRow{Preset::threejs,
              "threejs",
              TangentRule::velocity,
              EndRule::chord,
              "smooth tracks of three.js; its AnimationAction has the ends zero,half",
              {.curve = RotationCurve::slerp}},
    PresetRow{Preset::godot, "godot", TangentRule::finite_difference, EndRule::zero,
              "cubic tracks of Godot 4, except those of rotations"},
};

/// The rows of rules and presets.
template <class S>
constexpr const TangentRuleRow<S>& row_of(TangentRule rule) {
  return tangent_rules<S>[static_cast<std::size_t>(rule)];
}
template <class S>
constexpr const EndRuleRow<S>& row_of(EndRule rule) {
  return end_rules<S>[static_cast<std::size_t>(rule)];
}
constexpr const PresetRow& row_of(Preset preset) { return presets[static_cast<std::size_t>(preset)]; }

/// The rules of a product, the same end rule for both ends.
template <class S>
CurveRules<S> rules_of(Preset preset) {
  const PresetRow& row = row_of(preset);
  return {row.tangents, {row.ends, {}}, {row.ends, {}}, false, {}, {}, row.rotations, {}, row.timing};
}

/// The names of rules and presets.
constexpr std::string_view name_of(TangentRule rule) { return row_of<double>(rule).name; }
constexpr std::string_view name_of(EndRule rule) { return row_of<double>(rule).name; }
constexpr std::string_view name_of(Preset preset) { return row_of(preset).name; }
constexpr std::string_view name_of(Timing timing) { return timing == Timing::even ? "even" : "monotone"; }

/// The rows of a table are in the order of their enumeration.
template <class Table>
constexpr bool is_in_order(const Table& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table[i].id) != i) return false;
  }
  return true;
}
static_assert(is_in_order(tangent_rules<double>) && is_in_order(end_rules<double>) && is_in_order(rotation_curves) &&
              is_in_order(presets));

/// The rule or preset of a table with a name, as in id_named(end_rules<double>, "one-sided").
template <class Table>
constexpr auto id_named(const Table& table, std::string_view name) -> std::optional<decltype(table[0].id)> {
  for (const auto& row : table) {
    if (row.name == name) return row.id;
  }
  return std::nullopt;
}

}  // namespace tcb::spline
