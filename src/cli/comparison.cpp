// Comparisons: the options that ask for one, and which of them have a meaning together.
#include "cli/comparison.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "error.hpp"
#include "text/number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// "1e-9", "x=1e-6", or several apart by commas.
std::vector<Tolerance> tolerances(std::string_view option, const std::string& text) {
  std::vector<Tolerance> list;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.rfind('=');
    const bool named = equals != std::string_view::npos;
    const auto most = parse_number(named ? part.substr(equals + 1) : part);
    if (!most || *most < 0 || (named && equals == 0)) {
      refuse_value(option, part, "a distance from 0 up, for all columns or as COLUMN=DISTANCE, such as 1e-9 or x=1e-6");
    }
    list.push_back({std::string(named ? part.substr(0, equals) : ""), *most});
  }
  return list;
}

/// An option that has no effect in a comparison.
struct Idle {
  std::string_view name;
  bool given;
};

void require_effects(const TypedOptions& typed, std::string_view option) {
  const std::array idle{Idle{"--step", !typed.step.empty()},
                        Idle{"--rate", !typed.rate.empty()},
                        Idle{"--count", !typed.count.empty()},
                        Idle{"--segments", !typed.segments.empty()},
                        Idle{"--per-segment", !typed.per_segment.empty()},
                        Idle{"--at", !typed.at.empty()},
                        Idle{"--arc-step", !typed.arc_step.empty()},
                        Idle{"--arc-count", !typed.arc_count.empty()},
                        Idle{"--arc-at", !typed.arc_at.empty()},
                        Idle{"--tolerance", !typed.tolerance.empty()},
                        Idle{"--from", !typed.from.empty()},
                        Idle{"--to", !typed.to.empty()},
                        Idle{"--end", !typed.end.empty()},
                        Idle{"--keys", typed.keys},
                        Idle{"--max-rows", !typed.max_rows.empty()},
                        Idle{"--explain", typed.explain},
                        Idle{"--progress", typed.progress},
                        Idle{"--output-dir", !typed.output_dir.empty()},
                        Idle{"--files", !typed.list.empty()},
                        Idle{"--recursive", typed.recursive},
                        Idle{"--suffix", !typed.suffix.empty()},
                        Idle{"--update", typed.update},
                        Idle{"--fail-fast", typed.fail_fast},
                        Idle{"--digits", !typed.digits.empty()},
                        Idle{"--fixed", !typed.fixed.empty()},
                        Idle{"--hex", typed.hex},
                        Idle{"--golden", typed.golden},
                        Idle{"--exact-input", typed.exact_input},
                        Idle{"--meta", typed.meta},
                        Idle{"--no-output-header", typed.no_output_header}};
  for (const Idle& other : idle) {
    if (!other.given) continue;
    throw Error(Exit::usage, fmt::format("{} has no effect with {}, which takes the samples of its file and prints a "
                                         "report; take it out",
                                         other.name, option));
  }
}

/// Options that have a meaning with one of the two alone.
void require_kind(const TypedOptions& typed) {
  const bool any_tolerance = !typed.abs.empty() || !typed.rel.empty() || !typed.ulp.empty();
  if (any_tolerance && typed.check.empty()) {
    throw Error(Exit::usage, "--abs, --rel and --ulp have no effect without --check; take them out, or add it");
  }
  if (!typed.check.empty() && !typed.identify.empty()) {
    throw Error(Exit::usage, "--check and --identify are two questions; expected one of them; take one out");
  }
  const CurveSettings& curve = typed.curve;
  const bool any_rule = curve.preset || curve.tangents || curve.ends || curve.equal_speed;
  if (!typed.identify.empty() && (any_rule || !typed.side.empty())) {
    throw Error(
        Exit::usage,
        "--preset, --tangents, --ends, --equal-speed and --side have no effect with --identify, which tries all "
        "rules on positions; take them out");
  }
}

void require_files(const TypedOptions& typed, const std::string& file, std::string_view option) {
  if (typed.files.size() > 1) {
    throw Error(Exit::usage, fmt::format("{} compares with the curves of one file of keys; {} are given; take the "
                                         "others out",
                                         option, typed.files.size()));
  }
  if (file == "-" && (typed.files.empty() || typed.files[0] == "-")) {
    throw Error(Exit::usage, fmt::format("standard input cannot hold both the keys and the file of {}; give one by its "
                                         "name",
                                         option));
  }
}

}  // namespace

std::optional<Comparison> make_comparison(const TypedOptions& typed) {
  require_kind(typed);
  const bool identify = !typed.identify.empty();
  if (!identify && typed.check.empty()) return std::nullopt;
  const std::string_view option = identify ? "--identify" : "--check";
  require_effects(typed, option);
  Comparison comparison{identify ? typed.identify : typed.check, identify, {}, {}, {}};
  require_files(typed, comparison.file, option);
  if (!typed.output_format.empty() && typed.output_format != "json") {
    refuse_value("--output-format", typed.output_format, "json, for a report; without it the report is text");
  }
  if (!typed.abs.empty()) comparison.abs = tolerances("--abs", typed.abs);
  if (!typed.rel.empty()) comparison.rel = tolerances("--rel", typed.rel);
  if (!typed.ulp.empty()) comparison.ulp = tolerances("--ulp", typed.ulp);
  return comparison;
}

}  // namespace tcb
