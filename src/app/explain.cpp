// What was found in a file and would be done with it, a line each.
#include "app/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "curve/fields.hpp"
#include "input/reader.hpp"
#include "input/texts.hpp"
#include "io/file.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_curves = 100;  ///< that are listed one by one

std::string shown(const Rational& value) { return fmt::format("{}", nearest_time(value).hi); }

/// The name of a value in a table of names.
template <class Row, std::size_t size, class Value>
std::string_view name_of(const std::array<Row, size>& names, Value Row::*member, Value value) {
  return std::ranges::find(names, value, member)->name;
}

/// How many keys a curve has, and its times where they come with the keys.
struct Span {
  std::size_t keys = 0;
  std::vector<spline::Time<double>> ends;

  void add(const KeyBlock& block) {
    keys += block.lines.size();
    if (block.keys.times.empty()) return;
    if (ends.empty()) ends.assign(2, block.keys.times.front());
    ends[1] = block.keys.times.back();
  }
};

/// Which samples are asked for.
std::string samples(const SamplingRequest& request) {
  const std::string_view of = by_length(request.mode) ? "arc length" : "time";
  switch (request.mode) {
    case Mode::step:
    case Mode::arc_step: return fmt::format("every {} of {}", shown(request.step), of);
    case Mode::count:
    case Mode::arc_count: return fmt::format("{}, equally spaced in {}", request.count, of);
    case Mode::segments: return fmt::format("{} equal intervals of time", request.count);
    case Mode::per_segment: return fmt::format("{} equal intervals in every segment", request.count);
    case Mode::at:
    case Mode::arc_at: return fmt::format("at {} places in {}", request.places.size(), of);
    case Mode::tolerance: return fmt::format("within {} of the curve", request.tolerance);
  }
  return "";
}

/// What was found at the beginning of an input.
Facts input_facts(const Input& input) {
  constexpr std::array shapes{"an array of keys", "an object with keys", "an object with curves", "a key a line"};
  const Format& format = format_of(input.facts.format);
  Facts facts{{"format", std::string(format.name)}};
  const auto add = [&](std::string_view name, std::string value) { facts.emplace_back(name, std::move(value)); };
  const auto list = [&](std::string_view name, const std::vector<std::string>& values) {
    if (!values.empty()) add(name, fmt::format("{}", fmt::join(values, ", ")));
  };
  if (format.has_header) {
    const char delimiter = input.facts.delimiter;
    add("delimiter", delimiter == '\t' ? "tab" : delimiter == ' ' ? "blanks" : std::string(1, delimiter));
    add("comment", input.facts.comment.empty() ? "none" : input.facts.comment);
    add("decimal", std::string(1, input.facts.decimal));
    add("header", input.named ? "yes" : "no");
  } else {
    add("shape", shapes.at(static_cast<std::size_t>(input.facts.shape)));
  }
  if (!input.own_curves) list("group", input.groups);
  if (input.timed) add("time", input.time);
  list("position", input.channels);
  for (const Role role : input.facts.roles) add(role_name(role), "in a column");
  list("carry", input.carried);
  list("left out", input.ignored);
  return facts;
}

/// What is to be done with every curve of an input.
Facts intentions(const Job& plan, const Input& input) {
  Facts facts;
  const auto add = [&](const char* name, std::string value) { facts.emplace_back(name, std::move(value)); };
  add("missing", std::string(name_of(missing_names, &MissingName::way, plan.input.missing)));
  if (input.timed) add("duplicates", std::string(name_of(duplicates_names, &DuplicatesName::value, plan.curves.duplicates)));
  if (plan.curves.sort) add("sort", "by time");
  const spline::Tcb<double>& tcb = plan.input.tcb;
  add("tcb", fmt::format("{},{},{} where keys carry none", tcb.tension, tcb.continuity, tcb.bias));
  add("metric", plan.curve.metric.value_or("all channels"));
  add("samples", samples(plan.sampling));
  if (plan.sampling.from) add("from", shown(*plan.sampling.from));
  if (plan.sampling.to) add("to", shown(*plan.sampling.to));
  std::vector<std::string_view> names;
  for (const std::size_t field : plan.fields) names.push_back(fields()[field].name);
  add("fields", fmt::format("{}", fmt::join(names, ", ")));
  const Format& output = format_of(plan.output_format);
  const bool header = output.has_header && plan.output_header.value_or(input.named);
  add("output", fmt::format("{}{}", output.name,
                            !output.has_header ? ""
                            : header           ? " with a header"
                                               : " without a header"));
  return facts;
}

/// What tells a curve apart, as in "id=a".
std::string title(const Input& input, const CurveKeys& curve, std::size_t number) {
  if (input.groups.empty()) return fmt::format("curve {}", number);
  std::string text = "curve";
  for (std::size_t i = 0; i < input.groups.size() && i < curve.group.size(); ++i) {
    text += fmt::format(" {}={}", input.groups[i], content(curve.group[i]));
  }
  return text;
}

/// What one curve comes to.
struct Outcome {
  Facts facts;
  std::size_t keys = 0;
  std::uint64_t rows = 0;
};

Outcome outcome(const CurvePipeline& pipeline, const CurveKeys& curve) {
  const auto span = std::make_shared<Span>();
  const Source<KeyBlock> counted = [span, keys = curve.keys] {
    std::optional<KeyBlock> block = keys();
    if (block) span->add(*block);
    return block;
  };
  const PlacedCurve placed = pipeline.place(counted);
  Outcome result{in_words(placed.facts), 0, 0};
  while (const auto batch = placed.batches()) {
    for (const auto& part : batch->parts) result.rows += part.last - part.first;
  }
  while (counted()) {
  }
  result.keys = span->keys;
  if (!placed.facts.first && !span->ends.empty()) {
    result.facts.emplace_back("curve",
                              fmt::format("from {} to {}", time_text(span->ends[0]), time_text(span->ends[1])));
  }
  if (const std::string text = remainder_in_words(placed); !text.empty()) result.facts.emplace_back("note", text);
  return result;
}

/// One curve in many lines.
Facts in_full(const Outcome& outcome) {
  Facts facts{{"keys", fmt::format("{}", outcome.keys)}};
  facts.insert(facts.end(), outcome.facts.begin(), outcome.facts.end());
  const auto note = std::ranges::find(facts, "note", &Facts::value_type::first);
  facts.emplace(note, "rows", fmt::format("{}", outcome.rows));
  return facts;
}

std::string counted(std::uint64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// One of several curves in a line.
std::string in_short(const Outcome& outcome) {
  std::string text = counted(outcome.keys, "key");
  for (const auto& [name, value] : outcome.facts) {
    if (name != "note") text += fmt::format(", {}{}", name == "curve" ? "" : name + " ", value);
  }
  return text + ", " + counted(outcome.rows, "row");
}

}  // namespace

Facts in_words(const RuleFacts& facts) {
  const spline::CurveRules<double>& rules = facts.spec.rules;
  const auto end = [](const spline::EndChoice<double>& choice) { return name_of(choice.rule); };
  Facts words{{"tangents", std::string(name_of(rules.tangents))}};
  if (facts.spec.closed) {
    words.emplace_back("closed", "yes");
  } else {
    words.emplace_back("ends", fmt::format("{}, {}", end(rules.start), end(rules.end)));
  }
  if (rules.equal_speed) words.emplace_back("equal speed", "yes");
  if (!facts.timed) {
    words.emplace_back("times",
                       fmt::format("none; made with --parameter {}", facts.spec.parameter_name.value_or("uniform")));
  }
  return words;
}

Facts in_words(const PlacementFacts& facts) {
  Facts words;
  if (facts.first && facts.last) {
    words.emplace_back("curve", fmt::format("from {} to {}", time_text(*facts.first), time_text(*facts.last)));
  }
  if (facts.length) words.emplace_back("length", fmt::format("{}", *facts.length));
  if (facts.step) words.emplace_back("step", time_text(*facts.step));
  return words;
}

std::string remainder_in_words(const PlacedCurve& placed) {
  const auto remainder = placed.remainder();
  if (!remainder) return "";
  return fmt::format("the end lies {} behind the last row and is left out; --end keep or --end fit includes it",
                     shown(*remainder));
}

std::string explanation(const std::string& path, const Job& plan) {
  const Input input = open_input(path, read_file(path), plan.input);
  Facts facts{{"file", shown_name(path)}}, curve_facts;
  const auto add = [&](const Facts& more) { facts.insert(facts.end(), more.begin(), more.end()); };
  add(input_facts(input));
  Curves curves(input, plan.curves, is_live(path));
  std::size_t count = 0;
  Outcome all, last;
  for (std::optional<CurveKeys> curve; (curve = curves.next()); ++count) {
    const CurvePipeline pipeline(plan.sampling, plan.curve, plan.fields, plan.golden, input, *curve->curve_info);
    if (count == 0) add(in_words(pipeline.facts()));
    if (count == 0) add(intentions(plan, input));
    last = outcome(pipeline, *curve);
    all.keys += last.keys;
    all.rows += last.rows;
    if (count < most_curves) curve_facts.emplace_back(title(input, *curve, count), in_short(last));
  }
  if (count == 1 && input.groups.empty()) {
    add(in_full(last));
  } else {
    facts.emplace_back("curves", fmt::format("{}", count));
    add(curve_facts);
    if (count > most_curves) facts.emplace_back("curves not shown", fmt::format("{}", count - most_curves));
    facts.emplace_back("keys", fmt::format("{}", all.keys));
    facts.emplace_back("rows", fmt::format("{}", all.rows));
  }
  if (curves.skipped() > 0) facts.emplace_back("rows left out", fmt::format("{}", curves.skipped()));
  std::string out;
  for (const auto& [name, value] : facts) out += fmt::format("{}: {}\n", name, value);
  return out;
}

}  // namespace tcb
