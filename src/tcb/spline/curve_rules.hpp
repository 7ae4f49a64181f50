// Curve rules: which rules give the tangents of a curve, and what its channels are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb::spline {

/// The rule at one end of an open curve.
template <class S>
struct EndChoice {
  EndRule rule = EndRule::half;
  std::vector<S> velocity;  ///< per unit of time, one number per channel, where the rule takes one
};

/// The rules that give the tangents of keys.
template <class S>
struct CurveRules {
  TangentRule tangents = TangentRule::velocity;
  EndChoice<S> start, end;
  bool equal_speed = false;                 ///< both tangents of a key get the same speed
  std::vector<std::size_t> metric;          ///< the channels of speeds and lengths; empty: all; or turn_metric
  std::vector<KeyRotation> rotations = {};  ///< not in the metric
  RotationRules rotation_rules = {};
  std::vector<AngleChannel> angles = {};
};

/// Whether a channel is neither an angle nor a number of a rotation.
template <class S>
bool is_plain(const CurveRules<S>& rules, std::size_t channel) {
  return !is_in_rotation(rules.rotations, channel) &&
         std::ranges::count(rules.angles, channel, &AngleChannel::channel) == 0;
}

/// The difference between the positions of a key and the next one in a channel; that of angles is less than half a
/// turn.
template <class S>
struct PositionChord {
  const Keys<S>& keys;
  const std::vector<AngleChannel>& angles;

  working_t<S> operator()(std::size_t key, std::size_t channel) const {
    const auto chord = exact_difference(keys.position(key + 1)[channel], keys.position(key)[channel]);
    for (const AngleChannel& angle : angles) {
      if (angle.channel == channel) return chord - nearest_turns<S>(chord, angle.degrees);
    }
    return chord;
  }
};

/// The rules of a product, the same end rule for both ends.
template <class S>
CurveRules<S> rules_of(Preset preset) {
  const PresetRow& row = row_of(preset);
  return {row.tangents, {row.ends, {}}, {row.ends, {}}, false, {}, {}, row.rotations};
}

/// The rules that give the tangents of rotations, over all their numbers.
template <class S>
CurveRules<S> rules_of_rotations(CurveRules<S> rules) {
  const RotationRules& own = rules.rotation_rules;
  rules.metric.clear();
  if (own.tangents) rules.tangents = *own.tangents;
  if (own.ends) rules.start = rules.end = {*own.ends, {}};
  return rules;
}

}  // namespace tcb::spline
