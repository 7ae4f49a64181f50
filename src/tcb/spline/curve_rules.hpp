// Curve rules: which rules give the tangents of a curve, and what its channels are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation_curve.hpp"

namespace tcb::spline {

// Their rows, of which the first is the default, are in rules.hpp.
enum class EndRule : std::uint8_t;
enum class TangentRule : std::uint8_t;
enum class Timing : std::uint8_t;

/// The rule at one end of an open curve.
template <class S>
struct EndChoice {
  EndRule rule = {};
  std::vector<S> velocity;  ///< per unit of time, one number per channel, where the rule takes one
};

/// The rules of rotations: their curve, and the tangents and ends that differ from those of positions.
struct RotationRules {
  RotationCurve curve = RotationCurve::squad;
  std::optional<TangentRule> tangents = {};
  std::optional<EndRule> ends = {};  ///< at both ends

  bool operator==(const RotationRules&) const = default;
};

/// The rules that give the tangents of keys.
template <class S>
struct CurveRules {
  TangentRule tangents = {};
  EndChoice<S> start, end;
  /// Both tangents of a key get the same speed over the metric, or if the metric has no channels, over all channels; a
  /// rotation has its own speed.
  bool equal_speed = false;
  /// The channels whose speeds and lengths count. Empty: all channels that are neither angles nor numbers of a
  /// rotation; if there are none, all channels.
  std::vector<std::size_t> metric;
  std::vector<KeyRotation> rotations = {};
  RotationRules rotation_rules = {};
  std::vector<AngleChannel> angles = {};
  Timing timing = {};  ///< of all channels
  /// Each channel, but the numbers of rotations, stays between the positions of two neighbouring keys. See
  /// tangents.hpp.
  bool no_overshoot = false;
};

/// The channels whose speeds and lengths count:
///   those of the rules' metric;
///   else, if it is empty, all that are neither angles nor numbers of rotations;
///   else, if there are none of these, an empty metric, which stands for all channels.
template <class S>
std::vector<std::size_t> metric_of(const CurveRules<S>& rules, std::size_t channels) {
  std::vector<std::size_t> metric = rules.metric;
  if (!metric.empty()) return metric;
  const std::vector<bool> are_plain = plain_channels(rules.rotations, rules.angles, channels);
  for (std::size_t i = 0; i < channels; ++i) {
    if (are_plain[i]) metric.push_back(i);
  }
  return metric;
}

/// The rules at another scalar; `number` converts each of their numbers.
template <class To, class From, class Number>
CurveRules<To> converted(const CurveRules<From>& rules, Number number) {
  const auto end = [&](const EndChoice<From>& choice) {
    EndChoice<To> result{choice.rule, {}};
    std::ranges::transform(choice.velocity, std::back_inserter(result.velocity), number);
    return result;
  };
  return {rules.tangents,  end(rules.start),     end(rules.end), rules.equal_speed, rules.metric,
          rules.rotations, rules.rotation_rules, rules.angles,   rules.timing,      rules.no_overshoot};
}

/// The rules that give the tangents of one rotation, whose numbers are then all channels.
template <class S>
CurveRules<S> rules_of_rotations(CurveRules<S> rules) {
  const RotationRules& own = rules.rotation_rules;
  rules.metric.clear();
  rules.rotations.clear();
  rules.angles.clear();
  rules.no_overshoot = false;
  if (own.tangents) rules.tangents = *own.tangents;
  if (own.ends) rules.start = rules.end = {*own.ends, {}};
  return rules;
}

}  // namespace tcb::spline
