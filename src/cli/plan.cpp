// What the typed options mean: text to values, and the checks that no option stands in another's way.
#include "cli/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "cli/batch.hpp"
#include "cli/comparison.hpp"
#include "cli/input.hpp"
#include "cli/notation.hpp"
#include "cli/sampling.hpp"
#include "curve/settings.hpp"
#include "curve/fields.hpp"
#include "error.hpp"
#include "text/number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

std::vector<std::size_t> make_fields(const std::string& text) {
  std::vector<std::string_view> known;
  std::ranges::transform(fields(), std::back_inserter(known), &Field::name);
  std::vector<std::size_t> chosen;
  for (const std::string_view name : split(text, ',')) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      throw Error(Exit::usage, fmt::format("--fields: no field \"{}\"; expected some of {}{}", name,
                                           fmt::join(known, ", "), did_you_mean(name, known)));
    }
    const auto field = static_cast<std::size_t>(found - known.begin());
    if (std::ranges::count(chosen, field) > 0) {
      throw Error(Exit::usage, fmt::format("--fields: {} twice; expected each once; take one out", name));
    }
    chosen.push_back(field);
  }
  return chosen;
}

/// Whether lengths or speeds are asked for anywhere.
bool needs_metric(const Job& plan, const CurveSpec& curve) {
  const auto over_metric = [](std::size_t field) {
    return fields()[field].needs_lengths || fields()[field].over_metric;
  };
  return by_length(plan.sampling.mode) || plan.sampling.mode == Mode::tolerance || curve.rules.equal_speed ||
         curve.parameter.value_or(0) != 0 || std::ranges::any_of(plan.fields, over_metric);
}

/// The names are known, and no option about the curve is without effect.
void check_curve(Job& plan) {
  const CurveSpec curve = make_spec(plan.curve);
  plan.input.timeless = plan.curve.parameter.has_value();
  if (plan.curve.metric && !plan.comparison && !needs_metric(plan, curve)) {
    throw Error(Exit::usage, "--metric has no effect where no length or speed is asked for; take it out");
  }
  if (plan.input.missing == Missing::skip_cell && (curve.rules.equal_speed || curve.parameter.value_or(0) != 0)) {
    throw Error(Exit::usage,
                "--missing skip-cell leaves channels apart, and --equal-speed and --parameter need all of them at each "
                "key; expected one of the two; take one out");
  }
}

/// At a key, the side is the right one unless said otherwise; where no field can tell, the earlier segment will do.
/// No field chosen may be any of them.
bool from_left(const std::string& side, const std::vector<std::size_t>& chosen) {
  const bool matters =
      chosen.empty() || std::ranges::any_of(chosen, [](std::size_t field) { return fields()[field].has_side; });
  if (side.empty()) return !matters;
  if (side != "left" && side != "right") refuse_value("--side", side, "left or right");
  if (!matters)
    throw Error(Exit::usage, "--side has no effect on these fields, which are the same on both sides; take it out");
  return side == "left";
}

unsigned make_jobs(const std::string& text) {
  constexpr unsigned most = 1024;
  const auto jobs = parse_rational(text);
  if (!jobs || *jobs < 1 || denominator(*jobs) != 1 || *jobs > most)
    refuse_value("--jobs", text, fmt::format("a whole number from 1 to {}", most));
  return static_cast<unsigned>(whole_number(*jobs));
}

}  // namespace

Job make_plan(const TypedOptions& typed) {
  Job plan;
  plan.comparison = make_comparison(typed);
  if (!plan.comparison) plan.sampling = make_sampling(typed);
  plan.input = make_input(typed);
  plan.curves = make_curves(typed);
  plan.curve = typed.curve;
  if (typed.closed) plan.curve.closed = true;
  plan.batch = make_batch(typed);
  plan.files = typed.files;
  if (plan.files.empty() && plan.batch.list.empty()) plan.files = {"-"};
  if (!typed.fields.empty() || !plan.comparison)
    plan.fields = make_fields(typed.fields.empty() ? "time,position" : typed.fields);
  plan.sampling.from_left = from_left(typed.side, plan.fields);
  check_curve(plan);
  plan.explain = typed.explain;
  if (!typed.jobs.empty()) plan.jobs = make_jobs(typed.jobs);
  plan.verbosity = make_talk(typed);
  if (!typed.output_format.empty())
    plan.output_format = named_format("--output-format", typed.output_format, &Format::can_write);
  plan.notation = make_notation(typed, plan.output_format);
  set_golden(plan, typed);
  if (typed.no_output_header) {
    if (!format_of(plan.output_format).has_header) {
      throw Error(Exit::usage,
                  "--no-output-header has no effect on this output format, which has no line of names; take "
                  "it out");
    }
    plan.output_header = false;
  }
  if (!typed.output.empty() && !typed.output_dir.empty()) {
    throw Error(Exit::usage,
                "--output and --output-dir both say where the rows go; expected one of them; take one out");
  }
  if (!typed.output.empty()) plan.output = typed.output;
  if (!typed.output_dir.empty()) plan.output_folder = typed.output_dir;
  return plan;
}

}  // namespace tcb
