// Curve settings: their values in texts.
#include "schema/curve_settings.hpp"

#include <algorithm>
#include <iterator>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "tcb/spline/rules.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// A product or curve without a preset, in letters alone.
struct ExpectedPreset {
  std::string_view name, instead;
};

/// Source: the reader of curves in Maya's animation engine for games (animEngine.c), Unity's AnimationCurve (its method
///   SmoothTangents), and Catmull and Rom (1974), whose curve has the same times between all keys.
constexpr ExpectedPreset expected_presets[] = {
    {"maya",
     "its spline tangents are those of tension, continuity and bias 0 with the tangent rule interval; remove it, and "
     "give --tangents interval"},
    {"unity",
     "its smooth tangents are those of tension, continuity and bias 0 with the preset tcb, the default; remove it"},
    {"blender",
     "its keys have handles and no rule; where these are a third of a segment long, their slopes are velocities; "
     "remove it, and give them in columns such as x_vin and x_vout"},
    {"catmullrom",
     "tension, continuity and bias 0 are this curve, with the tangent rule uniform, or finite-difference where times "
     "are uneven; remove it, and give --tangents uniform or finite-difference"},
};

/// The row of a table with this name.
template <class Table>
const auto& named(const Table& table, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.name == name; });
  if (found != table.end()) return *found;
  std::vector<std::string_view> known;
  std::ranges::transform(table, std::back_inserter(known), [](const auto& row) { return row.name; });
  throw usage_error("unknown name {}; expected one of {}{}", in_quotes(name), listed(known), did_you_mean(name, known));
}

/// One rule: a name, or name=V:V:… for one that takes a velocity.
EndSetting end_in(std::string_view text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const auto& row = named(spline::end_rules<double>, text.substr(0, equals));
  EndSetting end{row.id};
  const bool has_value = equals < text.size();
  if (row.takes_velocity && !has_value)
    throw usage_error("{} has no velocity; expected a number for each channel, as in velocity=1:0", in_quotes(text));
  if (!row.takes_velocity && has_value)
    throw usage_error("{} has a value; expected only a rule; remove it", in_quotes(text));
  if (!has_value) return end;
  for (const std::string_view part : split(text.substr(equals + 1), ':')) {
    const auto value = parse_number(part);
    if (!value)
      throw usage_error("{} in {} is not a number; expected a number for each channel, as in velocity=1:0",
                        in_quotes(part), in_quotes(text));
    end.velocity.push_back(*value);
  }
  return end;
}

}  // namespace

std::string_view in_place_of_preset(std::string_view name) {
  std::string letters;
  for (const char c : in_lower_case(name)) letters += c >= 'a' && c <= 'z' ? std::string(1, c) : "";
  const auto* const found = std::ranges::find(expected_presets, letters, &ExpectedPreset::name);
  return found == std::end(expected_presets) ? "" : found->instead;
}

spline::Preset preset_in(std::string_view text) {
  if (const std::string_view instead = in_place_of_preset(text); !instead.empty())
    throw usage_error("unknown name {}; {}", in_quotes(text), instead);
  return named(spline::presets, text).id;
}

spline::TangentRule tangents_in(std::string_view text) { return named(spline::tangent_rules<double>, text).id; }

EndsSetting ends_in(std::string_view text) {
  std::vector<std::string> ends;
  for (const std::string_view part : split(text, ',')) {
    if (!ends.empty() && parse_number(part)) {  // a comma before a number separates channels, like a colon
      ends.back() += ':';
      ends.back() += part;
    } else {
      ends.emplace_back(part);
    }
  }
  if (ends.size() > 2) throw too_many_rules(ends.size());
  return {end_in(ends.front()), end_in(ends.back())};
}

PeriodSetting period_in(std::string_view text) {
  const std::optional<Rational> duration = read_duration(text), period = duration ? duration : parse_rational(text);
  if (!period || *period <= 0)
    throw usage_error("{} is not a period; expected a decimal or a ratio above 0, such as 7.5", in_quotes(text));
  if (!within_doubles(*period))
    throw usage_error("{} is too large; expected at most 1.7976931348623157e308, the largest double", in_quotes(text));
  return {*period, duration.has_value()};
}

ParameterSetting parameter_in(const std::string& text) {
  if (const auto value = parse_number(text); value && *value >= 0 && *value <= 16) return {*value, text};
  const bool is_number = !text.empty() && (text[0] == '-' || is_digit(text[0]));
  if (is_number) throw usage_error("the exponent is {}; expected 0 to 16", text);
  return {named(parameter_names, text).value, text};
}

Error too_many_rules(std::size_t rules) {
  return usage_error("there are {} rules; expected one for both ends, or one for each end; remove some", rules);
}

}  // namespace tcb
