// In words: the rules of a curve and the requested samples, for provenance, explanations and pictures.
#include "run/in_words.hpp"

#include <fmt/format.h>

#include <string_view>

#include "numbers/decimal_time.hpp"
#include "option_names.hpp"
#include "sample/curve_spec.hpp"

namespace tcb {

std::string number_in_words(const Rational& value) { return fmt::format("{}", nearest_time(value).hi); }

Facts rules_in_words(const CurveSpec& spec) {
  const spline::CurveRules<double>& rules = spec.rules;
  Facts words{{"tangents", std::string(name_of(rules.tangents))}};
  if (spec.closed) {
    words.emplace_back("closed", "yes");
  } else {
    words.emplace_back("ends", fmt::format("{}, {}", name_of(rules.start.rule), name_of(rules.end.rule)));
  }
  if (rules.timing != spline::Timing::even) words.emplace_back("timing", std::string(name_of(rules.timing)));
  if (rules.equal_speed) words.emplace_back("equal speed", "yes");
  if (rules.no_overshoot) words.emplace_back("overshoot", "none");
  if (spec.extrapolations.extend_curve()) {
    const auto& [before, after] = spec.extrapolations;
    words.emplace_back("extrapolation", before == after ? std::string(name_of(before))
                                                        : fmt::format("{}, {}", name_of(before), name_of(after)));
  }
  if (!rules.rotations.empty()) {
    const auto& [curve, tangents, ends] = rules.rotation_rules;
    words.emplace_back("rotation curve", std::string(name_of(curve)));
    if (tangents) words.emplace_back("rotation tangents", std::string(name_of(*tangents)));
    if (ends && !spec.closed) words.emplace_back("rotation ends", std::string(name_of(*ends)));
  }
  if (!spec.timed) {
    const std::string made = spec.parameter ? spec.parameter->name : "uniform";
    words.emplace_back("times", fmt::format("none; made with {} {}", option::parameter, made));
  }
  return words;
}

Facts preset_in_words(const CurveSpec& spec) {
  Facts words{{"preset", std::string(spline::name_of(spec.preset))}};
  const Facts rules = rules_in_words(spec);
  words.insert(words.end(), rules.begin(), rules.end());
  return words;
}

std::string samples_in_words(const SamplingRequest& request) {
  const std::string_view of = by_length(request.mode) ? "arc length" : "time";
  switch (request.mode) {
    case Mode::step:
      if (request.is_rate) return fmt::format("{} per unit of time", number_in_words(Rational(1) / request.step));
      [[fallthrough]];
    case Mode::arc_step: return fmt::format("every {} of {}", number_in_words(request.step), of);
    case Mode::arc_count:
    case Mode::count: return fmt::format("{}, equally spaced in {}", request.count, of);
    case Mode::segments: return fmt::format("{} equal intervals of time", request.count);
    case Mode::per_segment: return fmt::format("{} equal intervals in every segment", request.count);
    case Mode::at:
    case Mode::arc_at:
      return request.places.empty() ? fmt::format("at places in {} for each group", of)
                                    : fmt::format("at {} places in {}", request.places.size(), of);
    case Mode::emit: return "the cubic of each segment";
    case Mode::tolerance: {
      const auto& [distance, angle] = request.tolerance;
      if (!request.tolerance.limits_angle()) return fmt::format("within {} of the curve", distance);
      if (!request.tolerance.limits_distance()) return fmt::format("rotations within {} radians", angle);
      return fmt::format("within {} of the curve, rotations within {} radians", distance, angle);
    }
  }
  return "";
}

}  // namespace tcb
