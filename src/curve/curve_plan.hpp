// What the settings of a curve mean: names looked up in the tables of rules, texts turned into numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curve/settings.hpp"
#include "sampling/extrapolation.hpp"
#include "tcb/spline/window.hpp"
#include "text/rational.hpp"

namespace tcb {

/// Which curve the keys make.
struct CurvePlan {
  spline::CurveRules<double> rules;
  bool closed = false;
  std::optional<Rational> period;   ///< of a closed curve, where it is given
  std::optional<double> parameter;  ///< exponent of the distances that make times
  Extrapolation extrapolation = Extrapolation::error;
  bool ease = true;  ///< ease columns count, where there are any
};

/// Throws: Error (usage) for an unknown name, with the nearest known one, or for settings that contradict.
CurvePlan make_curve(const CurveSettings& settings);

/// The plan for keys with these channels: the metric by index. Throws: Error (usage) for a metric channel that
/// is not there, or a velocity with another number of channels.
CurvePlan fitted(CurvePlan plan, const CurveSettings& settings, const std::vector<std::string>& channels);

}  // namespace tcb
