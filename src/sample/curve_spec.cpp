// The meaning of curve settings: rules by index, texts as numbers.
#include "sample/curve_spec.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "keys/prepare.hpp"
#include "numbers/parse_number.hpp"
#include "option_names.hpp"
#include "sample/table.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using spline::EndChoice;

/// An error about a setting of the command line or of the input.
template <class... Arguments>
Error setting_error(const SettingOrigin& setting, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  return Error(setting.exit(), fmt::format(message, std::forward<Arguments>(arguments)...))
      .about(setting.subject)
      .at(setting.position);
}

Error too_many_rules(const SettingOrigin& setting, std::size_t rules) {
  return setting_error(setting, "there are {} rules; expected one for both ends, or one for each end; remove some",
                       rules);
}

/// The row with the name that a setting gives.
template <class Table>
const typename Table::value_type& named(const SettingOrigin& origin, const Table& table, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.name == name; });
  if (found != table.end()) return *found;
  std::vector<std::string_view> known;
  std::ranges::transform(table, std::back_inserter(known), [](const auto& row) { return row.name; });
  throw setting_error(origin, "unknown name {}; expected one of {}{}", in_quotes(name), listed(known),
                      did_you_mean(name, known));
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
    throw takes_velocity
        ? setting_error(origin, "{} has no velocity; expected a number for each channel, as in velocity=1:0",
                        in_quotes(text))
        : setting_error(origin, "{} has a value; expected only a rule; remove it", in_quotes(text));
  }
  if (!takes_velocity) return choice;
  for (const std::string_view part : split(text.substr(equals + 1), ':')) {
    const auto value = parse_number(part);
    if (!value)
      throw setting_error(origin, "{} in {} is not a number; expected a number for each channel, as in velocity=1:0",
                          in_quotes(part), in_quotes(text));
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
  if (ends.size() > 2) throw too_many_rules(setting.origin, ends.size());
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
  if (is_number) throw setting_error(setting.origin, "the exponent is {}; expected 0 to 16", text);
  return row_of(setting, exponents).exponent;
}

/// RULE or RULE,RULE.
Extrapolations parse_extrapolations(const TextSetting& setting) {
  const std::vector<std::string_view> rules = split(setting.value, ',');
  if (rules.size() > 2) throw too_many_rules(setting.origin, rules.size());
  const auto kind = [&](std::string_view rule) { return named(setting.origin, extrapolations, rule).kind; };
  return {kind(rules.front()), kind(rules.back())};
}

Rational parse_period(const TextSetting& setting) {
  const auto& [text, origin] = setting;
  const std::optional<Rational> duration = read_duration(text), period = duration ? duration : parse_rational(text);
  if (!period || *period <= 0)
    throw setting_error(origin, "{} is not a period; expected a decimal or a ratio above 0, such as 7.5",
                        in_quotes(text));
  if (!within_doubles(*period))
    throw setting_error(origin, "{} is too large; expected at most 1.7976931348623157e308, the largest double",
                        in_quotes(text));
  return *period;
}

/// Multiplies times, also those of velocities. Throws: Error (usage) for a rule that depends on an absolute time.
void retime(CurveSpec& spec, const Rational& factor) {
  if (spec.period) *spec.period *= factor;
  for (auto* end : {&spec.rules.start, &spec.rules.end}) {
    if (end->rule == spline::EndRule::lightwave && !spec.closed && factor != 1) {
      throw usage_error(
          "the end rule lightwave depends on 1/3600 of a second, so that other times make another curve; name another "
          "end rule with {}",
          option::ends)
          .about(option::retime);
    }
    for (double& velocity : end->velocity) velocity /= nearest_double(factor);
  }
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
  if (settings.period && is_open)
    throw setting_error(settings.closed->origin,
                        "the curve is open, but has a period; expected a closed curve; close it, or remove the period");
  spec.closed = settings.period || (settings.closed && settings.closed->value);
  spec.rules.timing = settings.timing.value_or(preset.timing);
  if (settings.ends && spec.closed) {
    const SettingOrigin& closed = settings.closed ? settings.closed->origin : settings.period->origin;
    const SettingOrigin& ends = settings.ends->origin;
    const bool is_in_file = ends.exit() == Exit::data && closed.exit() == Exit::data;
    throw Error(is_in_file ? Exit::data : Exit::usage,
                fmt::format("a closed curve has no ends; remove {} or {}", ends.subject, closed.subject))
        .about(ends.subject)
        .at(ends.position);
  }
  if (settings.ends) {
    set_ends(spec.rules, *settings.ends);
  } else {
    spec.rules.start = spec.rules.end = {preset.ends, {}};
  }
  spec.rules.equal_speed = settings.equal_speed;
  spec.rules.no_overshoot = settings.no_overshoot;
  if (settings.period) spec.period = parse_period(*settings.period);
  if (settings.period) spec.is_period_in_seconds = read_duration(settings.period->value).has_value();
  if (settings.parameter) spec.parameter = parse_exponent(*settings.parameter);
  if (settings.parameter) spec.parameter_name = settings.parameter->value;
  if (settings.extrapolate) spec.extrapolations = parse_extrapolations(*settings.extrapolate);
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
  const auto is_angle = [&](std::size_t channel) {
    return std::ranges::count(angles, channel, &spline::AngleChannel::channel) > 0;
  };
  std::vector<std::size_t>& metric = spec.rules.metric;
  const bool is_all = settings.metric && settings.metric->value == "all" && !find_channel("all", channels);
  if (!settings.metric || is_all) {
    if (rotations.empty() && angles.empty()) return;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (!spline::is_in_rotation(rotations, i) && !is_angle(i)) metric.push_back(i);
    }
    spec.lacks_metric = metric.empty();
    return;
  }
  const auto& [text, origin] = *settings.metric;
  if (text == "rotation" && !find_channel("rotation", channels)) {
    if (rotations.empty())
      throw setting_error(origin, "there is no rotation to measure; name its columns with {}, or measure channels",
                          option::rotation);
    metric = {spline::turn_metric};
    return;
  }
  for (const std::string_view part : split(text, ',')) {
    const std::string name(part);
    const auto channel = find_channel(name, channels);
    if (!channel)
      throw setting_error(origin, "there is no channel {}; expected some of {}, by name or by number from 1{}",
                          in_quotes(name), listed(channels), did_you_mean(name, channels));
    if (spline::is_in_rotation(rotations, *channel))
      throw setting_error(origin,
                          "channel \"{}\" belongs to a rotation, which has no length; expected positions; give {} none "
                          "to take it as a position",
                          channels[*channel], option::rotation);
    if (is_angle(*channel))
      throw setting_error(origin,
                          "channel \"{}\" is an angle, which has no length; expected positions; leave it out, or take "
                          "it as a position by leaving it out of {}",
                          channels[*channel], option::angle);
    if (std::ranges::count(metric, *channel) > 0)
      throw setting_error(origin, "channel {} is repeated; expected each channel once; remove one", in_quotes(name));
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
        "{} keeps channels between their keys, which a rotation has no order for; expected no rotations; remove it, or "
        "give {} none to take their numbers as plain channels",
        option::no_overshoot, option::rotation);
  }
  for (const auto* end : {&spec.rules.start, &spec.rules.end}) {
    if (end->velocity.empty()) continue;
    if (spec.rules.timing == spline::Timing::monotone)
      throw setting_error(settings.ends->origin,
                          "the rule velocity gives a velocity, which a preset with monotone timing would change; "
                          "expected a different end rule; change it, or give another {}",
                          option::preset);
    if (!rotations.empty())
      throw setting_error(settings.ends->origin,
                          "the rule velocity does not apply to rotations; expected a different end rule; change it, or "
                          "give {} none to take rotations as plain channels",
                          option::rotation);
    if (end->velocity.size() == channels.size()) continue;
    throw setting_error(settings.ends->origin,
                        "the velocity has {} numbers; expected {}, one for each of {}; correct it",
                        end->velocity.size(), channels.size(), listed(channels));
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
  if (spec.lacks_metric && use != MetricUse::nothing) {
    throw data_error(
        "there are only rotations or angles, which have no length; expected a position; give {} rotation to measure "
        "angles, or {} none to take the numbers as positions",
        option::metric, option::rotation);
  }
  if (spline::is_turn(spec.rules.metric) && (use == MetricUse::path || spec.rules.equal_speed)) {
    throw usage_error(
        "{} rotation measures angles, so there are arc lengths, but no distances, speeds or shapes of a path; leave "
        "these out, or give the field angular_speed",
        option::metric);
  }
  const spline::RotationCurve curve = spec.rules.rotation_rules.curve;
  const auto is_quaternion = [](const auto& one) { return one.shown.is_quaternion(); };
  if (emits && !spec.rules.angles.empty())
    throw data_error("the pieces of an angle would lie in different turns; expected no angles; remove {} or {}",
                     option::angle, option::emit);
  if (emits && curve == spline::RotationCurve::components && !std::ranges::all_of(spec.rotations, is_quaternion)) {
    throw data_error(
        "the pieces of a rotation are cubics of its quaternion; expected rotations as quaternions; give {} quaternion",
        option::rotation_output);
  }
  if (emits && !spec.rules.rotations.empty() && curve != spline::RotationCurve::components) {
    throw data_error(
        "the rotation curve {} has no cubics to print as pieces; expected components; give {} components, {} none, or "
        "samples instead, as with {}",
        name_of(curve), option::rotation_curve, option::rotation, option::count);
  }
}

void require_rotations(const CurveSpec& spec, const std::vector<std::size_t>& chosen, const SamplingRequest& request) {
  const bool has_rotations = !spec.rules.rotations.empty();
  const auto of_rotations =
      std::ranges::find_if(chosen, [](std::size_t field) { return fields()[field].per_rotation; });
  if (!has_rotations && of_rotations != chosen.end()) {
    throw data_error("{} needs a rotation, and there is none; name its columns with {}, or remove the field",
                     fields()[*of_rotations].name, option::rotation)
        .about(option::fields);
  }
  if (!has_rotations && request.tolerance.limits_angle()) {
    throw data_error(
        "the tolerance has an angle, but there is no rotation; give the distance alone, or name a rotation with {}",
        option::rotation)
        .about(option::tolerance);
  }
  const bool is_near_path = request.mode == Mode::tolerance && request.tolerance.limits_distance();
  if (has_rotations && spec.lacks_metric && is_near_path) {
    throw data_error(
        "the tolerance has a distance, but there are only rotations or angles, which have none; give an angle alone, "
        "as in 0.5deg, or {} none to take the numbers as positions",
        option::rotation)
        .about(option::tolerance);
  }
}

}  // namespace tcb
