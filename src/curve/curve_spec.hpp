// The meaning of curve settings: rules by index, texts as numbers, and the facts that describe them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/curve_settings.hpp"
#include "sampling/extrapolation.hpp"
#include "tcb/spline/window.hpp"
#include "text/rational.hpp"

namespace tcb {

/// Which curve the keys make.
struct CurveSpec {
  spline::Preset preset = spline::Preset::gte;
  spline::CurveRules<double> rules;
  bool closed = false;
  std::optional<Rational> period;                  ///< of a closed curve, where it is given
  std::optional<double> parameter;                 ///< exponent of the distances that make times
  std::optional<std::string> parameter_name = {};  ///< as it was given
  Extrapolation extrapolation = Extrapolation::error;
  bool ease = true;  ///< ease columns are used, where there are any
};

/// The settings of the command line with those of the input where the command line has none. A preset of the command
/// line replaces all rules of the input.
CurveSettings merged(CurveSettings settings, const CurveSettings& of_input);

/// Throws: Error (usage), about its option, for an unknown name, or for settings that contradict each other.
CurveSpec make_spec(const CurveSettings& settings);

/// The same for keys with these channels: with the metric. Throws: Error (usage), about its option, also for a metric
/// channel that is not there, or a velocity with another number of channels.
CurveSpec make_spec(const CurveSettings& settings, const std::vector<std::string>& channels);

}  // namespace tcb
