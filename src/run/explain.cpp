// Explanation: what was detected in a file and will be done with it, one fact per line.
#include "run/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "formats/formats.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "numbers/time_notation.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "sample/build.hpp"
#include "sample/rows.hpp"
#include "sample/table.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/curve.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_curves = 100;  ///< with a line of their own

template <class T, std::size_t size>
std::string_view name_in(const std::array<Named<T>, size>& names, T value) {
  return std::ranges::find(names, value, &Named<T>::value)->name;
}

std::string in_words(const spline::RotationNotation& notation) {
  std::string words(name_in(rotation_forms, notation.form));
  if (notation.form == spline::RotationForm::euler) {
    words += ' ';
    for (const std::size_t axis : notation.axes) words += (notation.intrinsic ? "XYZ" : "xyz")[axis];
  }
  return notation.has_angles() ? words + (notation.degrees ? " in degrees" : " in radians") : words;
}

std::string unit_in_words(const TimeSchema& time) {
  if (is_date(time.notation)) return "dates";
  return time.unit ? std::string(row_of(*time.unit).name) : "unknown";
}

Facts input_facts(const Input& input) {
  constexpr std::array shapes{"an array of keys",
                              "an object with keys",
                              "an object with curves",
                              "one key per line",
                              "a table",
                              "a table whose index is the time",
                              "a list in another one"};
  const Format& format = *input.facts.format;
  Facts facts{{"format", std::string(format.name)}};
  const auto add = [&](std::string_view name, std::string value) { facts.emplace_back(name, std::move(value)); };
  const auto list = [&](std::string_view name, std::vector<std::string> values) {
    std::ranges::replace(values, "", "(nameless)");
    if (!values.empty()) add(name, fmt::format("{}", fmt::join(values, ", ")));
  };
  if (!input.facts.encoding.empty()) add("encoding", input.facts.encoding);
  if (const std::optional<TextMarks>& marks = input.schema.marks) {
    const char delimiter = marks->delimiter;
    add("delimiter", delimiter == '\t' ? "tab" : delimiter == ' ' ? "blanks" : std::string(1, delimiter));
    add("comment", input.facts.comment.empty() ? "none" : input.facts.comment);
    add("decimal", std::string(1, marks->decimal));
    add("header", input.schema.named && format.poses == nullptr ? "yes" : "no");
  } else if (format.is_json) {
    add("shape", shapes.at(static_cast<std::size_t>(input.facts.shape)));
  }
  if (!input.keys.traits.own_curves) list("group", input.schema.groups);
  if (const TimeSchema& time = input.schema.time; time.counts_rows) {
    add("time",
        fmt::format("row i of a curve at {} + i / ({}) s", ratio_text(time.start), ratio_text(*time.frame_rate)));
  } else if (input.schema.time.is_given) {
    add("time", input.schema.time.name.empty() ? "(nameless)" : input.schema.time.name);
    add("unit of time", unit_in_words(input.schema.time));
  }
  std::vector<std::string> positions;
  for (const OutputColumn& column : output_columns(std::array{field_of("position")}, input.schema)) {
    positions.push_back(column.name);
  }
  list("position", positions);
  for (const std::string& role : input.facts.roles) add(role, "in a column");
  list("carry", input.schema.labels);
  list("tracks with other channels", input.facts.other_tracks);
  list("tracks with one key", input.facts.constant_tracks);
  list("ignored", input.facts.ignored);
  for (const std::string& doubt : input.facts.doubts) add("note", doubt);
  return facts;
}

/// What will be done with every curve of an input. `metric`: the channels that the input chooses, if it does.
Facts intentions(const ExplainJob& job, const Schema& schema, const std::optional<spline::Tcb<double>>& of_file,
                 const std::vector<std::size_t>& metric) {
  const SamplingRequest& sampling = job.samples.request;
  Facts facts;
  const auto add = [&](std::string_view name, std::string value) { facts.emplace_back(name, std::move(value)); };
  add("missing", std::string(name_in(missing_names, job.keys.input.keys.missing)));
  const auto duplicates = name_in(duplicates_names, job.keys.curves.duplicates);
  if (schema.time.is_given) add("duplicates", std::string(duplicates));
  if (job.keys.curves.sort) add("sort", "by time");
  if (job.keys.rules.no_ease) add("ease", "none");
  const spline::Tcb<double> tcb = job.keys.input.keys.tcb.value_or(of_file.value_or(spline::Tcb<double>{}));
  add("tcb", fmt::format("{},{},{} where keys carry none", tcb.tension, tcb.continuity, tcb.bias));
  for (const AngleColumn& angle : schema.angles) {
    add("angle", schema.channels[angle.channel] + (angle.degrees ? " in degrees" : " in radians"));
  }
  for (std::size_t i = 0; i < schema.rotations.size(); ++i) {
    const GivenRotation& given = schema.rotations[i].given;
    const auto& shown = schema.rotations[i].columns.shown;
    const std::string rows = shown == given.notation ? "" : ", in rows " + in_words(shown);
    add(i == 0 ? "rotation" : fmt::format("rotation {}", i + 1),
        fmt::format("{}{} {}{}", given.relative ? "relative " : "", in_words(given.notation),
                    fmt::join(given.columns, " "), rows));
  }
  const std::string_view others = schema.rotations.empty() && schema.angles.empty() ? "" : "other ";
  std::vector<std::string> of_input(metric.size());
  std::ranges::transform(metric, of_input.begin(), [&](std::size_t channel) { return schema.channels[channel]; });
  add("metric", job.keys.rules.metric ? fmt::format("{}", fmt::join(job.keys.rules.metric->value, ","))
                : of_input.empty()    ? fmt::format("all {}channels", others)
                                      : fmt::format("{}", fmt::join(of_input, ", ")));
  if (!job.has_samples) return facts;
  add("samples", samples_in_words(sampling));
  if (job.golden) add("golden", "each number is rounded once; one that 400 digits do not distinguish from 0 is 0");
  if (sampling.from) add("from", number_in_words(*sampling.from));
  if (sampling.to) add("to", number_in_words(*sampling.to));
  std::vector<std::string_view> names;
  for (const std::size_t field : job.fields) names.push_back(fields()[field].name);
  add("fields", fmt::format("{}", fmt::join(names, ", ")));
  const Format& output = *job.format;
  const std::string_view header = job.header.value_or(schema.named) ? " with a header" : " without a header";
  add("output", fmt::format("{}{}", output.name, output.offers(offer::marks) ? header : ""));
  return facts;
}

/// The group of a curve, as in "curve id=a", or its number.
std::string title(const Schema& schema, const InputCurve& curve, std::size_t number) {
  if (schema.groups.empty()) return fmt::format("curve {}", number);
  return fmt::format("curve {}", fmt::join(group_title(schema.groups, curve.group), " "));
}

struct Gap {
  Time from, to;

  Time size() const { return to - from; }
};

/// How far a channel leaves the range of two neighbouring keys.
struct Overshoot {
  std::size_t channel = 0, segment = 0;
  double size = 0, part = 0;  ///< part: of the range of the channel's keys
};

/// The largest overshoot as a part of the range of its channel; angles and rotations have none.
Overshoot largest_overshoot(const spline::Curve<double>& curve, const spline::CurveRules<double>& rules) {
  Overshoot largest;
  const std::vector<bool> are_plain = spline::plain_channels(rules.rotations, rules.angles, curve.channels());
  for (std::size_t channel = 0; channel < curve.channels(); ++channel) {
    if (!are_plain[channel]) continue;
    Overshoot own{channel};
    double low = curve.segment(0).cubics[channel].p0, high = low;
    for (std::size_t i = 0; i < curve.segment_count(); ++i) {
      const auto segment = curve.segment(i);
      const spline::Cubic<double>& cubic = segment.cubics[channel];
      low = std::min(low, cubic.p1);
      high = std::max(high, cubic.p1);
      const auto [least, most] = std::minmax(cubic.p0, cubic.p1);
      const double root = std::sqrt(std::max(0.0, cubic.c * cubic.c - 3 * cubic.d * cubic.out));
      for (const double u : {(-cubic.c + root) / (3 * cubic.d), (-cubic.c - root) / (3 * cubic.d),
                             -cubic.out / (2 * cubic.c)}) {  // where the slope may be 0
        if (!(u > 0 && u < 1)) continue;
        const double value = spline::position(cubic, {u, u - 1});
        const double size = std::max(least - value, value - most);
        if (size > own.size) own = {channel, i, size};
      }
    }
    own.part = own.size / (high - low);
    if (own.part > largest.part) largest = own;
  }
  return largest;
}

/// Counts and facts of one curve.
struct CurveOutcome {
  TimeSchema schema;
  std::size_t keys = 0;
  std::optional<std::uint64_t> rows;  ///< nothing if no samples are requested
  std::optional<Time> first, last;    ///< times of the keys, where they are known
  SampleFacts facts;
  std::optional<Rational> remainder;
  bool ends_at_key = true;                  ///< the end of the range is the last key
  std::optional<std::size_t> limited = {};  ///< tangents, so that the curve does not overshoot
  std::optional<Gap> least_gap, largest_gap;
  std::string overshoot;     ///< in words
  std::string overshoots;    ///< the name of its channel
  bool has_missing = false;  ///< numbers, so that the cubics of a channel are cut where others have keys

  std::string shown(const Time& value) const { return shown_time(schema, value); }
  std::string shown(const Gap& gap) const { return fmt::format("from {} to {}", shown(gap.from), shown(gap.to)); }

  void add(const KeyBlock& block) {
    keys += block.size();
    has_missing |= !block.keys.missing.empty();
    if (block.keys.times.empty()) return;
    for (const Time& time : block.keys.times) {
      if (last) {
        const Gap gap{*last, time};
        if (!largest_gap || largest_gap->size() < gap.size()) largest_gap = gap;
        if (!least_gap || gap.size() < least_gap->size()) least_gap = gap;
      }
      last = time;
    }
    if (!first) first = block.keys.times.front();
    last = block.keys.times.back();
  }
};

/// Places the samples of a curve if they are requested, and reads its keys to the end.
CurveOutcome outcome_of(CurvePipeline& pipeline, const Source<KeyBlock>& keys, bool has_samples, const Schema& schema) {
  CurveOutcome outcome;
  outcome.schema = schema.time;
  const bool no_overshoot = pipeline.spec().rules.no_overshoot;
  const Source<KeyBlock> seen = observed(keys, [&outcome](const KeyBlock& block) { outcome.add(block); });
  if (!has_samples) {
    const auto kept = pipeline.kept(seen);
    outcome.first = kept->extent().first;
    outcome.last = kept->extent().last;
    if (no_overshoot) outcome.limited = kept->curve().limited_tangents();
    const Overshoot largest = largest_overshoot(kept->curve(), pipeline.spec().rules);
    if (!no_overshoot && !outcome.has_missing && largest.part > 0.01) {
      const auto times = kept->curve().times();
      outcome.overshoots = schema.channels[largest.channel];
      outcome.overshoot = fmt::format("{:.6g} in {} {}", largest.size, schema.channels[largest.channel],
                                      outcome.shown({Time(times[largest.segment]), Time(times[largest.segment + 1])}));
    }
    return outcome;
  }
  const CurveSamples samples = pipeline.samples(seen);
  outcome.rows = 0;
  while (const auto block = samples.blocks()) *outcome.rows += block->rows();
  while (seen()) {
  }
  if (no_overshoot) outcome.limited = samples.limited_tangents();
  outcome.facts = samples.facts;
  outcome.remainder = samples.remainder();
  if (samples.facts.first) outcome.first = samples.facts.first;
  if (samples.facts.last) outcome.last = samples.facts.last;
  return outcome;
}

/// The largest gap between two keys, where it is more than twice the least.
std::string gap_text(const CurveOutcome& outcome) {
  if (!outcome.largest_gap || !(outcome.least_gap->size() + outcome.least_gap->size() < outcome.largest_gap->size()))
    return "";
  return outcome.shown(*outcome.largest_gap);
}

/// A single curve, in several lines.
Facts lines_of(const CurveOutcome& outcome) {
  Facts lines{{"keys", fmt::format("{}", outcome.keys)}};
  if (outcome.first) lines.emplace_back("curve", outcome.shown({*outcome.first, *outcome.last}));
  if (const std::string gap = gap_text(outcome); !gap.empty()) {
    lines.emplace_back("largest gap", fmt::format("{}; --max-gap begins a new curve at gaps", gap));
  }
  if (!outcome.overshoot.empty()) {
    lines.emplace_back("largest overshoot", fmt::format("{}; --no-overshoot removes it", outcome.overshoot));
  }
  if (outcome.facts.length) lines.emplace_back("length", fmt::format("{}", *outcome.facts.length));
  if (const auto& pace = outcome.facts.pace) {
    lines.emplace_back("duration", fmt::format("{}", pace->duration));
    lines.emplace_back("mean speed", fmt::format("{}", pace->mean_speed));
    lines.emplace_back("largest speed", fmt::format("{}", pace->largest_speed));
  }
  if (outcome.facts.step) lines.emplace_back("step", time_text(*outcome.facts.step));
  if (outcome.limited) lines.emplace_back("limited tangents", fmt::format("{}", *outcome.limited));
  if (outcome.rows) lines.emplace_back("rows", fmt::format("{}", *outcome.rows));
  if (outcome.remainder)
    lines.emplace_back("note", remainder_note(nearest_time(*outcome.remainder).hi, outcome.ends_at_key).text);
  return lines;
}

std::string number_of(std::uint64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// One of several curves, in one line.
std::string line_of(const CurveOutcome& outcome) {
  std::string text = number_of(outcome.keys, "key");
  if (outcome.first) text += ", " + outcome.shown({*outcome.first, *outcome.last});
  if (const std::string gap = gap_text(outcome); !gap.empty()) text += ", largest gap " + gap;
  if (!outcome.overshoot.empty()) text += ", largest overshoot " + outcome.overshoot;
  if (outcome.facts.length) text += fmt::format(", length {}", *outcome.facts.length);
  if (const auto& pace = outcome.facts.pace) {
    text += fmt::format(", duration {}, mean speed {}, largest speed {}", pace->duration, pace->mean_speed,
                        pace->largest_speed);
  }
  if (outcome.facts.step) text += ", step " + time_text(*outcome.facts.step);
  if (outcome.limited) text += ", " + number_of(*outcome.limited, "limited tangent");
  return outcome.rows ? text + ", " + number_of(*outcome.rows, "row") : text;
}

void append(Facts& to, const Facts& from) { to.insert(to.end(), from.begin(), from.end()); }

/// What will be done with the curves of an input, and counts: those of a single curve, or of the first ones in a line
/// each.
Facts facts_of_curves(const Input& input, const ExplainJob& job, const std::function<bool()>& arrive) {
  Facts facts, of_single, of_each;
  std::string needs;
  std::size_t count = 0, keys = 0;
  std::uint64_t rows = 0;
  std::vector<NamedAngle> angles;
  Curves curves(input.schema, input.keys, job.keys.curves, arrive);
  for (; const std::optional<InputCurve> curve = curves.next(); ++count) {
    CurveRequest request{job.samples.of(*curve, input.schema), job.keys.rules, job.fields, job.golden};
    request.leaves_gaps = true;
    const CurveSettings& of_input = curve->curve_info->settings;
    CurvePipeline pipeline(request, input.schema, input.keys.traits, *curve->curve_info, curve->part);
    if (count == 0) {
      if (job.has_samples) needs = in_words(pipeline.needs());
      facts = rules_in_words(pipeline.spec());
      const bool is_chosen = of_input.metric || !spatial_channels(input.schema.channels).empty();
      const bool has_metric = is_chosen && !job.keys.rules.metric;
      append(facts, intentions(job, input.schema, input.facts.tcb,
                               has_metric ? pipeline.spec().rules.metric : std::vector<std::size_t>{}));
    }
    CurveOutcome outcome = outcome_of(pipeline, curve->keys, job.has_samples, input.schema);
    outcome.ends_at_key = !job.samples.request.to && !pipeline.spec().closed;
    angles = curves.channels().likely_angles();
    if (std::ranges::count(angles, outcome.overshoots, &NamedAngle::channel) > 0) outcome.overshoot.clear();
    keys += outcome.keys;
    rows += outcome.rows.value_or(0);
    if (count == 0) of_single = lines_of(outcome);
    if (count >= most_curves) continue;
    std::string line = line_of(outcome);
    if (of_input.extrapolate && !job.keys.rules.extrapolate) {  // which the input alone decides
      const auto& [before, after] = *of_input.extrapolate;
      line += fmt::format(", extrapolation {}", name_of(before));
      if (after != before) line += fmt::format(",{}", name_of(after));
    }
    of_each.emplace_back(title(input.schema, *curve, count), line);
  }
  if (count == 1 && input.schema.groups.empty()) {
    append(facts, of_single);
  } else {
    facts.emplace_back("curves", fmt::format("{}", count));
    append(facts, of_each);
    if (count > most_curves) facts.emplace_back("curves not shown", fmt::format("{}", count - most_curves));
    facts.emplace_back("keys", fmt::format("{}", keys));
    if (job.has_samples) facts.emplace_back("rows", fmt::format("{}", rows));
  }
  if (curves.skipped() > 0) facts.emplace_back("rows skipped", fmt::format("{}", curves.skipped()));
  if (!needs.empty()) facts.emplace_back("needs", needs);
  for (const Note& note : notes_of_rules(curves, job.keys)) facts.emplace_back("note", note.text);
  if (!angles.empty()) facts.emplace_back("note", angles_note(angles).text);
  return facts;
}

/// The explanation as an object in a line, whose members are texts.
std::string as_object(const Facts& lines) {
  std::string out = "{";
  for (const auto& [name, value] : lines) {
    out += (out.size() > 1 ? "," : "") + json_text(name) + ":" + json_text(value);
  }
  return out + "}\n";
}

/// Calls print(facts) with the facts of a file; at an error with those that are known.
template <class Print>
void explain(const std::string& path, const ExplainJob& job, const Print& print) {
  in_file(shown_name(path), [&] {
    const InputBytes opened = open_file(path);
    const Input input = open_input(path, opened.bytes, job.keys.input);
    Facts lines{{"file", shown_name(path)}};
    append(lines, input_facts(input));
    try {
      append(lines, facts_of_curves(input, job, opened.arrive));
    } catch (const Error&) {
      print(lines);
      throw;
    }
    print(lines);
  });
}

}  // namespace

void require_explained(const ExplainJob& job) {
  for (const InputFile& file : find_inputs(job.files).files) explain(file.path, job, [](const Facts&) {});
}

Exit explain(const ExplainJob& job) {
  Output output("-");
  const auto print = [&](const Facts& lines) {
    if (job.format->is_json) return output.write(as_object(lines));
    for (const auto& [name, value] : lines) {
      output.write(fmt::format("{}: {}\n", printable(name), printable(value)));
    }
  };
  for (const InputFile& file : find_inputs(job.files).files) {
    try {
      explain(file.path, job, print);
    } catch (const Error&) {
      output.commit();  // what is known of the files so far helps to mend the error
      throw;
    }
  }
  output.commit();
  return Exit::done;
}

}  // namespace tcb
