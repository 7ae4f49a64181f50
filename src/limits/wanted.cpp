// Wanted: what can be measured of a curve by name, and which of these measures are asked for.
#include "limits/wanted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb::limits {
namespace {

/// Measures of a channel, such as velocity_x, and those over the metric channels.
struct Quantity {
  std::string_view name;
  int derivative;
};
constexpr std::array of_channels{Quantity{"position", 0}, Quantity{"velocity", 1}, Quantity{"acceleration", 2},
                                 Quantity{"jerk", 3}};
constexpr std::array norms{Quantity{"speed", 1}, Quantity{"acceleration", 2}, Quantity{"jerk", 3}};

/// All measures of a curve with channels of these names, as sizes.
std::vector<Measure> known_measures(const CurveSpec& spec, const std::vector<std::string>& names) {
  const auto& [rotations, angles] = std::tie(spec.rules.rotations, spec.rules.angles);
  std::vector<std::size_t> metric = spline::metric_of(spec.rules, names.size());
  if (spline::is_turn(metric)) metric.clear();
  if (metric.empty() && rotations.empty() && angles.empty()) {
    for (std::size_t i = 0; i < names.size(); ++i) metric.push_back(i);
  }
  std::vector<Measure> known;
  for (const Quantity& norm : norms) {
    if (!metric.empty()) known.push_back({std::string(norm.name), Measure::Kind::size, norm.derivative, metric});
  }
  if (metric.size() > 1) known.push_back({"curvature", Measure::Kind::curvature, 0, metric});
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    Measure one{rotations.size() == 1 ? "angular_speed" : fmt::format("angular_speed{}", i + 1),
                Measure::Kind::size,
                1,
                {names.size() + i}};
    one.is_of_rotation = true;
    const spline::RotationCurve curve = spec.rules.rotation_rules.curve;
    if (curve == spline::RotationCurve::components) {
      one.kind = Measure::Kind::angular_speed;
      one.channels.assign(rotations[i].channels.begin(), rotations[i].channels.end());
    } else if (curve != spline::RotationCurve::slerp) {
      continue;  // no bound is proved
    }
    known.push_back(std::move(one));
  }
  for (const auto& [name, derivative] : of_channels) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool has_it = derivative > 0 ? !spline::is_in_rotation(rotations, i)
                                         : spline::is_plain(spec.rules, i);  // angles have no range
      if (has_it) known.push_back({fmt::format("{}_{}", name, names[i]), Measure::Kind::size, derivative, {i}, true});
    }
  }
  return known;
}

}  // namespace

std::vector<LimitResult> wanted_of(const LimitOptions& options, const CurveSpec& spec,
                                   const std::vector<std::string>& channels, const std::vector<std::string>& title) {
  const std::vector<Measure> known = known_measures(spec, channels);
  std::vector<std::string> names;
  for (const Measure& one : known) names.push_back(one.name);
  std::vector<Limit> limits = options.limits;
  if (limits.empty()) {
    for (const std::string& name : names) limits.push_back({name, {}, {}});
  }
  std::vector<LimitResult> wanted;
  for (const Limit& limit : limits) {
    const auto known_one = std::ranges::find(known, limit.name, &Measure::name);
    if (known_one == known.end()) {
      const bool is_unproved = limit.name.starts_with("angular_speed") && !spec.rules.rotations.empty();
      const std::string reason =
          is_unproved ? "it has a proved maximum with --rotation-curve slerp or components; " : "";
      throw usage_error("nothing is measured as {}; {}expected one of {}{}", in_quotes(limit.name), reason,
                        listed(names), did_you_mean(limit.name, names))
          .about("--limits");
    }
    Measure measure = *known_one;
    if (limit.least && !measure.is_signed) {
      throw usage_error("{} is never below 0; expected {}=LIMIT; give its largest value", limit.name, limit.name)
          .about("--limits");
    }
    const bool is_position = measure.derivative == 0 && measure.is_signed;
    if (!limit.least && (limit.most || !is_position)) {
      wanted.push_back({title, std::move(measure), {}, limit.most});
      continue;
    }
    measure.kind = Measure::Kind::smallest;
    wanted.push_back({title, measure, {}, limit.least});
    measure.kind = Measure::Kind::largest;
    wanted.push_back({title, std::move(measure), {}, limit.most});
  }
  return wanted;
}

}  // namespace tcb::limits
