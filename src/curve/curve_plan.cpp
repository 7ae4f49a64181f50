// What the settings of a curve mean: names looked up in the tables of rules, texts turned into numbers.
#include "curve/curve_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>

#include "error.hpp"
#include "tcb/spline/rules.hpp"
#include "text/number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using spline::EndChoice;

/// One rule: a name, or name=V:V:… for one that takes a velocity.
EndChoice<double> end_choice(std::string_view text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const auto& row = spline::end_rules<double>[find_named("--ends", spline::end_rules<double>, text.substr(0, equals))];
  EndChoice<double> choice{row.id, {}};
  const bool takes_velocity = row.takes_velocity;
  if (takes_velocity != (equals < text.size())) {
    throw Error(Exit::usage, fmt::format("--ends {}: expected {}", text,
                                         takes_velocity ? "a number for each channel, as in velocity=1:0"
                                                        : "no value for this rule; take it out"));
  }
  if (!takes_velocity) return choice;
  for (const std::string_view part : split(text.substr(equals + 1), ':')) {
    const auto value = parse_number(part);
    if (!value)
      throw Error(Exit::usage, fmt::format("--ends {}: \"{}\" is not a number; expected velocity=V:V…", text, part));
    choice.velocity.push_back(*value);
  }
  return choice;
}

/// RULE or RULE,RULE. A comma before a number separates channels, like a colon.
void set_ends(spline::CurveRules<double>& rules, std::string_view text) {
  std::vector<std::string> ends;
  for (const std::string_view part : split(text, ',')) {
    if (!ends.empty() && parse_number(part)) {
      ends.back() += fmt::format(":{}", part);
    } else {
      ends.emplace_back(part);
    }
  }
  if (ends.size() > 2) {
    throw Error(Exit::usage, fmt::format("--ends {}: {} rules; expected one, or one for the start and one for the end",
                                         text, ends.size()));
  }
  rules.start = end_choice(ends.front());
  rules.end = end_choice(ends.back());
}

double parse_exponent(std::string_view text) {
  struct Named {
    std::string_view name;
    double exponent;
  };
  constexpr std::array named{Named{"uniform", 0}, Named{"chordal", 1}, Named{"centripetal", 0.5}};
  if (const auto value = parse_number(text); value && *value >= 0 && *value <= 16) return *value;
  if (!text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'))) {
    throw Error(Exit::usage, fmt::format("--parameter {}: expected an exponent from 0 to 16", text));
  }
  return named[find_named("--parameter", named, text)].exponent;
}

Rational parse_period(const std::string& text) {
  const auto period = parse_rational(text);
  if (!period || *period <= 0) {
    throw Error(Exit::usage, fmt::format("--period \"{}\": expected a decimal or a ratio above 0, such as 7.5", text));
  }
  if (!within_doubles(*period)) {
    throw Error(Exit::usage, fmt::format("--period \"{}\": expected {}", text, double_range));
  }
  return *period;
}

std::size_t find_channel(const std::string& name, const std::vector<std::string>& channels) {
  const auto found = std::ranges::find(channels, name);
  if (found != channels.end()) return static_cast<std::size_t>(found - channels.begin());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error == std::errc() && end == name.data() + name.size() && number >= 1 && number <= channels.size()) {
    return number - 1;
  }
  const std::vector<std::string_view> known(channels.begin(), channels.end());
  throw Error(Exit::usage, fmt::format("--metric: no channel \"{}\"; expected some of {}, or numbers from 1{}", name,
                                       fmt::join(known, ", "), did_you_mean(name, known)));
}

}  // namespace

CurvePlan make_curve(const CurveSettings& settings) {
  CurvePlan plan;
  const auto& preset = spline::presets[find_named("--preset", spline::presets, settings.preset.value_or("gte"))];
  plan.rules.tangents = preset.tangents;
  if (settings.tangents) {
    const auto& table = spline::tangent_rules<double>;
    plan.rules.tangents = table[find_named("--tangents", table, *settings.tangents)].id;
  }
  if (settings.period && !settings.closed.value_or(true)) {
    throw Error(Exit::usage, "closed: false, but a period makes the curve closed; take one of them out");
  }
  plan.closed = settings.period || settings.closed.value_or(false);
  if (settings.ends && plan.closed) {
    throw Error(Exit::usage, "--ends has no effect on a closed curve, which has no ends; take one of them out");
  }
  set_ends(plan.rules, settings.ends.value_or(std::string(name_of(preset.ends))));
  plan.rules.equal_speed = settings.equal_speed;
  if (settings.period) plan.period = parse_period(*settings.period);
  if (settings.parameter) plan.parameter = parse_exponent(*settings.parameter);
  if (settings.extrapolate) {
    plan.extrapolation = extrapolations[find_named("--extrapolate", extrapolations, *settings.extrapolate)].kind;
  }
  plan.ease = !settings.no_ease;
  return plan;
}

CurvePlan fitted(CurvePlan plan, const CurveSettings& settings, const std::vector<std::string>& channels) {
  const auto metric = settings.metric ? split(*settings.metric, ',') : std::vector<std::string_view>{};
  for (const std::string_view part : metric) {
    const std::string name(part);
    const std::size_t channel = find_channel(name, channels);
    if (std::ranges::count(plan.rules.metric, channel) > 0) {
      throw Error(Exit::usage, fmt::format("--metric: channel \"{}\" twice; expected each once; take one out", name));
    }
    plan.rules.metric.push_back(channel);
  }
  for (const auto* end : {&plan.rules.start, &plan.rules.end}) {
    if (end->velocity.empty() || end->velocity.size() == channels.size()) continue;
    throw Error(Exit::usage,
                fmt::format("--ends: a velocity of {} numbers; expected {}, one for each of {}; correct it",
                            end->velocity.size(), channels.size(), fmt::join(channels, ", ")));
  }
  return plan;
}

}  // namespace tcb
