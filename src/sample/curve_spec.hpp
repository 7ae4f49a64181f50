// Curve specification: which curve the keys make, from the settings of the command line and of the input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numbers/rational.hpp"
#include "sample/request.hpp"
#include "schema/curve_channels.hpp"
#include "schema/curve_settings.hpp"
#include "tcb/spline/curve_rules.hpp"

namespace tcb {

enum class ShownTcbScale;  // in keys/prepare.hpp

/// Which curve the keys make.
struct CurveSpec {
  spline::Preset preset = {};  ///< the first one of the presets, unless another is named
  spline::CurveRules<double> rules;
  bool closed = false;
  bool timed = true;               ///< the keys have times; otherwise the parameter makes them
  std::optional<Rational> period;  ///< of a closed curve, if given
  std::optional<ParameterSetting> parameter = {};
  std::vector<RotationColumns> rotations = {};  ///< the rotations of the rules, and how rows show them
  std::vector<AngleColumn> angles = {};         ///< the angle channels of the rules, and how rows show them
  std::optional<FrameTimes> frames = {};        ///< where the times of the keys are frames in seconds
  bool is_period_in_seconds = false;            ///< it is a duration, not in the unit of the times
  Extrapolations extrapolations;
  bool ease = true;                       ///< ease columns are used, if there are any
  std::optional<Retiming> retiming = {};  ///< of the keys; the period and the velocities at ends have it already

  /// There are rotations alone, which have no lengths.
  bool lacks_metric = false;

  /// Of the distances between keys that make their times, where these have none.
  double exponent() const { return parameter ? parameter->exponent : 0; }
  CurveChannels channels() const { return {rules.metric, rotations, angles, frames}; }
};

/// The settings of the command line, completed by those of the input. A preset of the command
/// line replaces all rules of the input.
CurveSettings merged(CurveSettings settings, const CurveSettings& of_input);

/// Whether the tangents are those of straight lines between keys.
bool is_linear(const CurveSettings& settings);

/// The index of a channel by its name, or by its number from 1.
std::optional<std::size_t> find_channel(const std::string& name, const std::vector<std::string>& channels);

/// Throws: Error about a setting for an unknown name, or for settings that contradict each other.
CurveSpec make_spec(const CurveSettings& settings);

/// The curve of keys with these channels, with the metric, to which rotations and angles do not belong. Throws: Error
/// about a setting, also for a metric channel that does not exist or belongs to a rotation, or a velocity with another
/// number of channels.
CurveSpec make_spec(const CurveSettings& settings, const std::vector<std::string>& channels,
                    const std::vector<RotationColumns>& rotations = {}, const std::vector<AngleColumn>& angles = {});

/// The scale on which the preset's product shows tension, continuity and bias, where it is another than the formulas'.
std::optional<ShownTcbScale> shown_tcb_scale(spline::Preset preset);

/// Throws: Error (data) where a field or a tolerance is of rotations, and there are none; where lengths, distances or
/// speeds are used, and there are rotations alone; and for cubics of rotations that have none. `chosen`: the fields.
void require_fitting_rotations(const CurveSpec& spec, const SamplingRequest& request,
                               const std::vector<std::size_t>& chosen, bool needs_metric);

}  // namespace tcb
