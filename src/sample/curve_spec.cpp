// Curve specification: which curve the keys make, from the settings of the command line and of the input.
#include "sample/curve_spec.hpp"

#include <algorithm>
#include <array>

#include "error.hpp"
#include "keys/prepare.hpp"
#include "sample/table.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

bool is_linear(const CurveSettings& settings) { return settings.tangents == spline::TangentRule::linear; }

namespace {

/// Sets the rules of rotations: those of the preset, unless rules are given for all channels or for rotations alone.
/// Straight lines are arcs of rotations.
void set_rotation_rules(spline::CurveRules<double>& rules, const spline::PresetRow& preset,
                        const CurveSettings& settings) {
  spline::RotationRules& own = rules.rotation_rules;
  own = preset.rotations;
  if (settings.tangents) own.tangents.reset();
  if (settings.ends) own.ends.reset();
  if (is_linear(settings)) own = {spline::RotationCurve::slerp, {}, {}};
  if (settings.rotation_preset) own = spline::row_of(*settings.rotation_preset).rotations;
  if (settings.rotation_curve) own.curve = *settings.rotation_curve;
}

/// Times made from distances belong to another curve of three.js than its preset.
/// Source: CatmullRomCurve3 of three.js, whose tangents with curveType centripetal and chordal are those of the
/// parabola
///   through three points, and at the ends the chords.
void require_tracks_of_three_js(const CurveSettings& settings) {
  const bool has_preset = settings.preset == spline::Preset::threejs && !settings.tangents;
  if (!has_preset || !settings.parameter || settings.parameter->exponent == 0) return;
  throw usage_error(
      "the preset threejs is that of keyframe tracks, whose keys have times; CatmullRomCurve3 of three.js with "
      "--parameter {} has other tangents; give --tangents finite-difference --ends chord instead of --preset threejs",
      settings.parameter->name)
      .about("--parameter");
}

/// Straight lines have no further rules.
void require_no_rules_beside_lines(const CurveSettings& settings) {
  if (settings.ends) {
    throw settings.ends->origin.error(data_error(
        "the tangents are linear, whose ends are chords; expected no other ends; remove them, or give other tangents"));
  }
  if (settings.equal_speed) {
    throw usage_error(
        "the tangents of the file are linear, which have one speed on each line; remove it, or give "
        "other tangents with --tangents")
        .about("--equal-speed");
  }
}

/// Multiplies times, also those of velocities.
void retime(CurveSpec& spec, const Rational& factor) {
  if (spec.period) *spec.period *= factor;
  for (auto* end : {&spec.rules.start, &spec.rules.end}) {
    for (double& velocity : end->velocity) velocity /= nearest_double(factor);
  }
}

}  // namespace

std::optional<std::size_t> find_channel(const std::string& name, const std::vector<std::string>& channels) {
  const auto found = std::ranges::find(channels, name);
  if (found != channels.end()) return static_cast<std::size_t>(found - channels.begin());
  const std::size_t number = in_digits<std::size_t>(name).value_or(0);
  return number >= 1 && number <= channels.size() ? std::optional(number - 1) : std::nullopt;
}

CurveSettings merged(CurveSettings settings, const CurveSettings& of_input) {
  const auto fill = [](auto& wanted, const auto& other) {
    if (!wanted) wanted = other;
  };
  const bool closed_given = settings.closed.has_value() || settings.period.has_value();
  if (!settings.preset) {
    settings.preset = of_input.preset;
    if (!is_linear(settings)) fill(settings.ends, of_input.ends);  // of other tangents, which a note tells
    fill(settings.tangents, of_input.tangents);
  }
  fill(settings.extrapolate, of_input.extrapolate);
  fill(settings.metric, of_input.metric);
  if (!closed_given) {
    settings.closed = of_input.closed;
    settings.period = of_input.period;
  } else if (!settings.closed || settings.closed->value) {
    fill(settings.period, of_input.period);
  }
  return settings;
}

CurveSpec make_spec(const CurveSettings& settings) {
  CurveSpec spec;
  spec.preset = settings.preset.value_or(spline::Preset{});
  require_tracks_of_three_js(settings);
  const spline::PresetRow& preset = spline::row_of(spec.preset);
  spec.rules.tangents = settings.tangents.value_or(preset.tangents);
  set_rotation_rules(spec.rules, preset, settings);
  const bool is_open = settings.closed && !settings.closed->value;
  if (settings.period && is_open)
    throw settings.closed->origin.error(
        data_error("the curve is open, but has a period; expected a closed curve; close it, or remove the period"));
  spec.closed = settings.period || (settings.closed && settings.closed->value);
  spec.rules.timing = settings.timing.value_or(preset.timing);
  spline::EndRule usual_ends = preset.ends;
  if (is_linear(settings)) {
    require_no_rules_beside_lines(settings);
    spec.rules.timing = spline::Timing::even;
    usual_ends = spline::EndRule::chord;
  }
  if (settings.ends && spec.closed) {
    const SettingOrigin& closed = settings.closed ? settings.closed->origin : settings.period->origin;
    const SettingOrigin& ends = settings.ends->origin;
    const bool is_in_file = ends.exit() == Exit::data && closed.exit() == Exit::data;
    throw Error(is_in_file ? Exit::data : Exit::usage,
                fmt::format("a closed curve has no ends; remove {} or {}", ends.subject, closed.subject))
        .about(ends.subject)
        .at(ends.position);
  }
  const EndsSetting ends = settings.ends ? settings.ends->value : EndsSetting{{usual_ends}, {usual_ends}};
  spec.rules.start = {ends.first.rule, ends.first.velocity};
  spec.rules.end = {ends.last.rule, ends.last.velocity};
  spec.rules.equal_speed = settings.equal_speed;
  spec.rules.no_overshoot = settings.no_overshoot;
  if (settings.period) {
    spec.period = settings.period->value.value;
    spec.is_period_in_seconds = settings.period->value.in_seconds;
  }
  spec.parameter = settings.parameter;
  spec.extrapolations = settings.extrapolate.value_or(Extrapolations{});
  spec.ease = !settings.no_ease;
  spec.retiming = settings.retiming;
  if (spec.retiming) retime(spec, spec.retiming->factor);
  return spec;
}

namespace {

/// Sets the metric: the named channels, or all that are no angles and no numbers of a rotation, also as "all".
void set_metric(CurveSpec& spec, const CurveSettings& settings, const std::vector<std::string>& channels) {
  const std::vector<RotationColumns>& rotations = spec.rotations;
  const std::vector<AngleColumn>& angles = spec.angles;
  const std::vector<bool> are_plain = spline::plain_channels(rotations, angles, channels.size());
  const std::vector<bool> are_in_rotations = spline::in_rotations(rotations, channels.size());
  std::vector<std::size_t>& metric = spec.rules.metric;
  const bool is_all =
      settings.metric && settings.metric->value == std::vector<std::string>{"all"} && !find_channel("all", channels);
  if (!settings.metric || is_all) {
    if (rotations.empty() && angles.empty()) return;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (are_plain[i]) metric.push_back(i);
    }
    spec.lacks_metric = metric.empty();
    return;
  }
  const auto& [names, origin] = *settings.metric;
  for (const std::string& name : names) {
    const auto channel = find_channel(name, channels);
    if (!channel && name == "rotation")
      throw origin.error(usage_error("rotation is gone in this version; give --fields angular_speed"));
    if (!channel)
      throw origin.error(data_error("there is no channel {}; expected some of {}, by name or by number from 1{}",
                                    in_quotes(name), listed(channels), did_you_mean(name, channels)));
    if (are_in_rotations[*channel])
      throw origin.error(
          data_error("channel \"{}\" belongs to a rotation, which has no length; expected positions; give --rotation "
                     "none to take it as a position",
                     channels[*channel]));
    if (!are_plain[*channel])
      throw origin.error(
          data_error("channel \"{}\" is an angle, which has no length; expected positions; leave it out, or take it as "
                     "a position by leaving it out of --angle",
                     channels[*channel]));
    if (std::ranges::count(metric, *channel) > 0)
      throw origin.error(data_error("channel {} is repeated; expected each channel once; remove one", in_quotes(name)));
    metric.push_back(*channel);
  }
}

}  // namespace

CurveSpec make_spec(const CurveSettings& settings, const std::vector<std::string>& channels,
                    const std::vector<RotationColumns>& rotations, const std::vector<AngleColumn>& angles) {
  CurveSpec spec = make_spec(settings);
  spec.rotations = rotations;
  spec.rules.rotations.assign(rotations.begin(), rotations.end());
  spec.angles = angles;
  spec.rules.angles.assign(angles.begin(), angles.end());
  set_metric(spec, settings, channels);
  if (settings.no_overshoot && !rotations.empty()) {
    throw data_error(
        "--no-overshoot keeps channels between their keys, which a rotation has no order for; expected no rotations; "
        "remove it, or give --rotation none to take their numbers as plain channels");
  }
  for (const auto* end : {&spec.rules.start, &spec.rules.end}) {
    if (end->velocity.empty()) continue;
    if (spec.rules.timing == spline::Timing::monotone)
      throw settings.ends->origin.error(
          data_error("the rule velocity gives a velocity, which a preset with monotone timing would change; expected a "
                     "different end rule; change it, or give another --preset"));
    if (!rotations.empty())
      throw settings.ends->origin.error(
          data_error("the rule velocity does not apply to rotations; expected a different end rule; change it, or give "
                     "--rotation none to take rotations as plain channels"));
    if (end->velocity.size() == channels.size()) continue;
    throw settings.ends->origin.error(data_error("the velocity has {} numbers; expected {}, one for each of {}",
                                                 end->velocity.size(), channels.size(), listed(channels)));
  }
  return spec;
}

std::optional<ShownTcbScale> shown_tcb_scale(spline::Preset preset) {
  using enum spline::Preset;
  constexpr std::array with_0_to_50{max3ds, nel, gamebryo, lib3ds1, lib3ds2};
  if (std::ranges::count(with_0_to_50, preset) > 0) return ShownTcbScale::from_0_to_50;
  return preset == lightwave ? std::optional(ShownTcbScale::percent) : std::nullopt;
}

void require_fitting_rotations(const CurveSpec& spec, const SamplingRequest& request,
                               const std::vector<std::size_t>& chosen, bool needs_metric) {
  const bool has_rotations = !spec.rules.rotations.empty();
  const auto of_rotations =
      std::ranges::find_if(chosen, [](std::size_t field) { return fields()[field].per_rotation; });
  if (!has_rotations && of_rotations != chosen.end()) {
    throw data_error("{} needs a rotation, and there is none; name its columns with --rotation, or remove the field",
                     fields()[*of_rotations].name)
        .about("--fields");
  }
  if (!has_rotations && request.tolerance.limits_angle()) {
    throw data_error(
        "the tolerance has an angle, but there is no rotation; give the distance alone, or name a rotation with "
        "--rotation")
        .about("--tolerance");
  }
  const bool is_near_path = request.mode == Mode::tolerance && request.tolerance.limits_distance();
  if (has_rotations && spec.lacks_metric && is_near_path) {
    throw data_error(
        "the tolerance has a distance, but there are only rotations or angles, which have none; give an angle alone, "
        "as in 0.5deg, or --rotation none to take the numbers as positions")
        .about("--tolerance");
  }
  const bool emits = request.mode == Mode::emit;
  if (spec.lacks_metric && needs_metric) {
    throw data_error(
        "there are only rotations or angles, which have no length; expected a position; give --rotation none to take "
        "the numbers as positions");
  }
  const spline::RotationCurve curve = spec.rules.rotation_rules.curve;
  const auto is_quaternion = [](const auto& one) { return one.shown.is_quaternion(); };
  if (emits && !spec.rules.angles.empty())
    throw data_error(
        "the pieces of an angle would lie in different turns; expected no angles; remove --angle or --emit");
  if (emits && curve == spline::RotationCurve::components && !std::ranges::all_of(spec.rotations, is_quaternion)) {
    throw data_error(
        "the pieces of a rotation are cubics of its quaternion; expected rotations as quaternions; give "
        "--rotation-output quaternion");
  }
  if (emits && !spec.rules.rotations.empty() && curve != spline::RotationCurve::components) {
    throw data_error(
        "the rotation curve {} has no cubics to print as pieces; expected components; give --rotation-curve "
        "components, --rotation none, or samples instead, as with --count",
        name_of(curve));
  }
}

}  // namespace tcb
