// End rules: the outer tangents of an open curve, where a key has one neighbour only.
//
// With D the chord of the end segment, m the other tangent of that segment and V a given velocity, every
// rule has the form
//   tangent = chord D + other m + given V
// and so is a pure function of (h, T, C, B) that gives three weights, the same for all channels.
// Units: tangents are local, per u of the end segment.
// To add a rule: a function and a row of end_rules.
#pragma once

#include <array>
#include <string_view>

#include "tcb/spline/tangent.hpp"

namespace tcb::spline {

/// What an end rule sees of the end key. The factors are those of the tangent that is wanted, named after
/// the chord that they belong to: the segment's own, or the one that is not there.
template <class W>
struct EndKey {
  W own;      ///< b at the first key, c at the last
  W missing;  ///< a at the first key, d at the last
  W tension;
  W h;            ///< duration of the end segment
  bool two_keys;  ///< the curve has no other segment, so m is an end's tangent too
};

template <class W>
struct EndWeights {
  W chord, other, given;
};

template <class W>
EndWeights<W> half_weights(const EndKey<W>& key) {
  return {W(0.5) * key.own, W(0), W(0)};
}

template <class W>
EndWeights<W> one_sided_weights(const EndKey<W>& key) {
  return {key.own, W(0), W(0)};
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

/// An end rule, and what the manual says of it.
template <class S>
struct EndRule {
  using W = working_t<S>;
  std::string_view name;
  std::string_view outgoing, incoming;  ///< formulas for the first and the last key
  std::string_view used_by;
  std::string_view choose;  ///< when to
  bool takes_velocity;      ///< written name=V...
  EndWeights<W> (*weights)(const EndKey<W>&);
};

/// Every end rule by name; the first is the default.
/// Source: what the products named compute.
template <class S>
inline constexpr std::array end_rules{
    EndRule<S>{"half", "b D/2", "c D/2", "GTE since 2022-08, OGRE, WorldEdit",
               "the default: as if the end position came once more", false, half_weights<working_t<S>>},
    EndRule<S>{"one-sided", "b D", "c D", "Wild Magic, LightWave SDK, FBX",
               "as if the end position came once more at the same time", false, one_sided_weights<working_t<S>>},
    EndRule<S>{"mirror", "(a+b) D/2", "(c+d) D/2", "Gamebryo, id Tech 4, lib3ds 2",
               "as if the neighbour were reflected at the end: C and B cancel", false, mirror_weights<working_t<S>>},
    EndRule<S>{"chord", "D", "D", "lib3ds 1, Synfig", "straight for the neighbour, whatever T, C and B say", false,
               chord_weights<working_t<S>>},
    EndRule<S>{"zero", "0", "0", "VTK's default", "to start and stop at rest", false, zero_weights<working_t<S>>},
    EndRule<S>{"natural", "1.5 D - 0.5 m", "1.5 D - 0.5 m", "the Python package splines, VTK's constraint 2",
               "for smooth data: the second derivative is 0 at the end", false, natural_weights<working_t<S>>},
    EndRule<S>{"natural-tension", "(1-T)(3 D - m)/2", "(1-T)(3 D - m)/2", "3ds Max, NeL, CryMovie",
               "to match these: natural, slowed by the end key's tension", false,
               natural_tension_weights<working_t<S>>},
    EndRule<S>{"cry", "1.5 (1-T)(D - m)", "1.5 (1-T)(D - m)", "CryEngine", "to match CryEngine", false,
               cry_weights<working_t<S>>},
    EndRule<S>{"lightwave", "b D h/(h + 1/3600)", "c D h/(h + 1/3600)", "LightWave's own files, times in seconds",
               "to match LightWave", false, lightwave_weights<working_t<S>>},
    EndRule<S>{"velocity", "h V", "h V", "a velocity given per unit of time, one number a channel",
               "to join a motion that is known, as in --ends velocity=1:0,zero", true,
               given_velocity_weights<working_t<S>>},
};

}  // namespace tcb::spline
