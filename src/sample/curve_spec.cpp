// The meaning of curve settings: rules by index, texts as numbers.
#include "sample/curve_spec.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "numbers/parse_number.hpp"
#include "option_names.hpp"
#include "sample/errors.hpp"
#include "sample/fields.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using spline::EndChoice;

/// The row with the name that a setting gives.
template <class Table>
const typename Table::value_type& named(const SettingOrigin& origin, const Table& table, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.name == name; });
  if (found != table.end()) return *found;
  std::vector<std::string_view> known;
  std::ranges::transform(table, std::back_inserter(known), [](const auto& row) { return row.name; });
  throw unknown_rule(origin, name, known);
}

/// The row with the name that is a setting.
template <class Table>
const typename Table::value_type& row_of(const TextSetting& setting, const Table& table) {
  return named(setting.origin, table, setting.value);
}

/// One rule: a name, or name=V:V:… for one that takes a velocity.
EndChoice<double> end_choice(std::string_view text, const SettingOrigin& origin) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const auto& row = named(origin, spline::end_rules<double>, text.substr(0, equals));
  EndChoice<double> choice{row.id, {}};
  const bool takes_velocity = row.takes_velocity;
  if (takes_velocity != (equals < text.size())) {
    throw takes_velocity ? end_velocity_missing(origin, text) : end_velocity_unexpected(origin, text);
  }
  if (!takes_velocity) return choice;
  for (const std::string_view part : split(text.substr(equals + 1), ':')) {
    const auto value = parse_number(part);
    if (!value) throw end_velocity_not_a_number(origin, text, part);
    choice.velocity.push_back(*value);
  }
  return choice;
}

/// RULE or RULE,RULE. A comma before a number separates channels, like a colon.
void set_ends(spline::CurveRules<double>& rules, const TextSetting& setting) {
  std::vector<std::string> ends;
  for (const std::string_view part : split(setting.value, ',')) {
    if (!ends.empty() && parse_number(part)) {
      ends.back() += ':';
      ends.back() += part;
    } else {
      ends.emplace_back(part);
    }
  }
  if (ends.size() > 2) throw too_many_end_rules(setting.origin, ends.size());
  rules.start = end_choice(ends.front(), setting.origin);
  rules.end = end_choice(ends.back(), setting.origin);
}

/// Sets the rules of rotations: those of the preset, unless rules are given for all channels or for rotations alone.
void set_rotation_rules(spline::CurveRules<double>& rules, const spline::PresetRow& preset,
                        const CurveSettings& settings) {
  spline::RotationRules& own = rules.rotation_rules;
  own = preset.rotations;
  if (settings.tangents) own.tangents.reset();
  if (settings.ends) own.ends.reset();
  if (settings.rotation_preset) own = spline::row_of(*settings.rotation_preset).rotations;
  if (settings.rotation_curve) {
    own.curve = row_of(*settings.rotation_curve, spline::rotation_curves).id;
  }
}

double parse_exponent(const TextSetting& setting) {
  const std::string& text = setting.value;
  struct Named {
    std::string_view name;
    double exponent;
  };
  constexpr std::array exponents{Named{"uniform", 0}, Named{"chordal", 1}, Named{"centripetal", 0.5}};
  if (const auto value = parse_number(text); value && *value >= 0 && *value <= 16) return *value;
  const bool is_number = !text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
  if (is_number) throw exponent_out_of_range(setting.origin, text);
  return row_of(setting, exponents).exponent;
}

/// RULE or RULE,RULE.
Extrapolations parse_extrapolations(const TextSetting& setting) {
  const std::vector<std::string_view> rules = split(setting.value, ',');
  if (rules.size() > 2) throw too_many_end_rules(setting.origin, rules.size());
  const auto kind = [&](std::string_view rule) { return named(setting.origin, extrapolations, rule).kind; };
  return {kind(rules.front()), kind(rules.back())};
}

Rational parse_period(const TextSetting& setting) {
  const auto& [text, origin] = setting;
  const std::optional<Rational> duration = read_duration(text), period = duration ? duration : parse_rational(text);
  if (!period || *period <= 0) throw period_not_positive(origin, text);
  if (!within_doubles(*period)) throw period_beyond_doubles(origin, text);
  return *period;
}

}  // namespace

std::optional<std::size_t> find_channel(const std::string& name, const std::vector<std::string>& channels) {
  const auto found = std::ranges::find(channels, name);
  if (found != channels.end()) return static_cast<std::size_t>(found - channels.begin());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = error == std::errc() && end == name.data() + name.size();
  return is_number && number >= 1 && number <= channels.size() ? std::optional(number - 1) : std::nullopt;
}

CurveSettings merged(CurveSettings settings, const CurveSettings& of_input) {
  const auto fill = [](auto& wanted, const auto& other) {
    if (!wanted) wanted = other;
  };
  const bool closed_given = settings.closed.has_value() || settings.period.has_value();
  if (!settings.preset) {
    settings.preset = of_input.preset;
    fill(settings.tangents, of_input.tangents);
    fill(settings.ends, of_input.ends);
    fill(settings.rotation_curve, of_input.rotation_curve);
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
  const auto& preset =
      settings.preset ? row_of(*settings.preset, spline::presets) : spline::row_of(spline::Preset::gte);
  spec.preset = preset.id;
  spec.rules.tangents = preset.tangents;
  if (settings.tangents) {
    spec.rules.tangents = row_of(*settings.tangents, spline::tangent_rules<double>).id;
  }
  set_rotation_rules(spec.rules, preset, settings);
  const bool is_open = settings.closed && !settings.closed->value;
  if (settings.period && is_open) throw period_of_open_curve(settings.closed->origin);
  spec.closed = settings.period || (settings.closed && settings.closed->value);
  spec.rules.timing = settings.timing.value_or(preset.timing);
  if (settings.ends && spec.closed) {
    const SettingOrigin& closed = settings.closed ? settings.closed->origin : settings.period->origin;
    throw ends_of_closed_curve(settings.ends->origin, closed);
  }
  if (settings.ends) {
    set_ends(spec.rules, *settings.ends);
  } else {
    spec.rules.start = spec.rules.end = {preset.ends, {}};
  }
  spec.rules.equal_speed = settings.equal_speed;
  if (settings.period) spec.period = parse_period(*settings.period);
  if (settings.period) spec.is_period_in_seconds = read_duration(settings.period->value).has_value();
  if (settings.parameter) spec.parameter = parse_exponent(*settings.parameter);
  if (settings.parameter) spec.parameter_name = settings.parameter->value;
  if (settings.extrapolate) spec.extrapolations = parse_extrapolations(*settings.extrapolate);
  spec.ease = !settings.no_ease;
  return spec;
}

namespace {

/// Sets the metric: the named channels, or all that are no angles and no numbers of a rotation.
void set_metric(CurveSpec& spec, const CurveSettings& settings, const std::vector<std::string>& channels) {
  const std::vector<RotationColumns>& rotations = spec.rotations;
  const std::vector<AngleColumn>& angles = spec.angles;
  const auto is_angle = [&](std::size_t channel) {
    return std::ranges::count(angles, channel, &spline::AngleChannel::channel) > 0;
  };
  std::vector<std::size_t>& metric = spec.rules.metric;
  if (!settings.metric) {
    if (rotations.empty() && angles.empty()) return;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (!spline::is_in_rotation(rotations, i) && !is_angle(i)) metric.push_back(i);
    }
    spec.lacks_metric = metric.empty();
    return;
  }
  const auto& [text, origin] = *settings.metric;
  if (text == "rotation" && !find_channel("rotation", channels)) {
    if (rotations.empty()) throw metric_without_rotations(origin);
    metric = {spline::turn_metric};
    return;
  }
  for (const std::string_view part : split(text, ',')) {
    const std::string name(part);
    const auto channel = find_channel(name, channels);
    if (!channel) throw no_channel_of_metric(origin, name, channels);
    if (spline::is_in_rotation(rotations, *channel)) throw rotation_in_metric(origin, channels[*channel]);
    if (is_angle(*channel)) throw angle_in_metric(origin, channels[*channel]);
    if (std::ranges::count(metric, *channel) > 0) throw repeated_metric_channel(origin, name);
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
  for (const auto* end : {&spec.rules.start, &spec.rules.end}) {
    if (end->velocity.empty()) continue;
    if (spec.rules.timing == spline::Timing::monotone) throw end_velocity_with_timing(settings.ends->origin);
    if (!rotations.empty()) throw end_velocity_of_rotation(settings.ends->origin);
    if (end->velocity.size() == channels.size()) continue;
    throw end_velocity_of_other_size(settings.ends->origin, end->velocity.size(), channels);
  }
  return spec;
}

std::optional<ShownTcbScale> shown_tcb_scale(spline::Preset preset) {
  using enum spline::Preset;
  constexpr std::array with_0_to_50{max3ds, nel, gamebryo, lib3ds1, lib3ds2};
  if (std::ranges::count(with_0_to_50, preset) > 0) return ShownTcbScale::from_0_to_50;
  return preset == lightwave ? std::optional(ShownTcbScale::percent) : std::nullopt;
}

void require_fitting_rotations(const CurveSpec& spec, MetricUse use, bool emits) {
  if (spec.lacks_metric && use != MetricUse::nothing) throw only_rotations();
  if (spline::is_turn(spec.rules.metric) && (use == MetricUse::path || spec.rules.equal_speed)) {
    throw path_of_rotations();
  }
  const spline::RotationCurve curve = spec.rules.rotation_rules.curve;
  const auto is_quaternion = [](const auto& one) { return one.shown.is_quaternion(); };
  if (emits && !spec.rules.angles.empty()) throw pieces_of_angles();
  if (emits && curve == spline::RotationCurve::components && !std::ranges::all_of(spec.rotations, is_quaternion)) {
    throw pieces_of_other_form();
  }
  if (emits && !spec.rules.rotations.empty() && curve != spline::RotationCurve::components) {
    throw pieces_of_rotations(name_of(curve));
  }
}

void require_rotations(const CurveSpec& spec, const std::vector<std::size_t>& chosen, const SamplingRequest& request) {
  const bool has_rotations = !spec.rules.rotations.empty();
  const auto of_rotations =
      std::ranges::find_if(chosen, [](std::size_t field) { return fields()[field].per_rotation; });
  if (!has_rotations && of_rotations != chosen.end()) {
    throw field_without_rotations(fields()[*of_rotations].name).about(option::fields);
  }
  if (!has_rotations && request.tolerance.limits_angle()) {
    throw tolerance_without_rotation().about(option::tolerance);
  }
  const bool is_near_path = request.mode == Mode::tolerance && request.tolerance.limits_distance();
  if (has_rotations && spec.lacks_metric && is_near_path) {
    throw tolerance_of_rotations().about(option::tolerance);
  }
}

}  // namespace tcb
