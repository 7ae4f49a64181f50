// End rules: the outer tangents of an open curve, where a key has one neighbour only.
//
// With D the chord of the end segment and m the other tangent of that segment, every rule has the form
//   tangent = chord D + other m
// and so is a pure function of (h, T, C, B) that gives two weights, the same for all channels.
// Units: tangents are local, per u of the end segment.
// To add a rule: a function and a row of end_rules.
#pragma once

#include <array>
#include <string_view>

#include "spline/tangent.hpp"

namespace tcb::spline {

/// What an end rule sees. The two factors are those of the tangent wanted, named as for the last key:
/// at the last key near = c, far = d; at the first key near = b, far = a.
template <class W>
struct EndKey {
  W near, far;
  W h;  ///< duration of the end segment
};

template <class W>
struct EndWeights {
  W chord, other;
};

template <class S>
struct EndRule {
  using W = working_t<S>;
  std::string_view name;
  std::string_view formula;
  std::string_view used_by;
  EndWeights<W> (*weights)(const EndKey<W>&);
};

/// out = ½ b D, in = ½ c D: as if the curve stood still at its end key before and after.
/// Source: GeometricTools since 2022-08 (the end position repeated, a step away in time).
template <class W>
EndWeights<W> half_weights(const EndKey<W>& key) {
  return {W(0.5) * key.near, W(0)};
}

/// Every end rule by name; the first is the default.
template <class S>
inline constexpr std::array end_rules{
    EndRule<S>{"half", "out = b D/2, in = c D/2", "GTE since 2022-08, OGRE, WorldEdit", half_weights<working_t<S>>},
};

}  // namespace tcb::spline
