// Conflicts: options that exclude each other, need another, or have no effect, as one table.
#include "cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "sample/curve_spec.hpp"
#include "sample/table.hpp"
#include "schema/format.hpp"

namespace tcb {
namespace {

using Typed = TypedOptions;

using Options = std::initializer_list<const char*>;

using When = bool (*)(const Typed& typed);

/// What each of some options has to do with others, if it is given.
struct Conflict {
  enum class Kind {
    excludes,       ///< at most one of the option and each of the others can be given
    needs,          ///< one of the others has to be given as well
    disables,       ///< the others have no effect with the option
    has_no_effect,  ///< the option itself has none
  };
  Options options;
  Kind kind;
  Options others = {};
  std::string_view reason = {};  ///< goes on after the last option in the message
  When when = nullptr;           ///< nothing: always
};
using enum Conflict::Kind;

bool writes_picture(const Typed& typed) { return typed.output.format->is_picture; }
bool writes_no_picture(const Typed& typed) { return !writes_picture(typed); }
bool writes_array(const Typed& typed) { return typed.output.format->is_binary; }
bool writes_scene(const Typed& typed) { return typed.output.format->has_nodes; }
bool writes_poses(const Typed& typed) { return typed.output.format->poses != nullptr; }
bool writes_no_text(const Typed& typed) { return !typed.output.format->has_marks; }
bool writes_no_csv(const Typed& typed) { return !typed.output.format->has_any_delimiter; }

bool writes_no_report(const Typed& typed) { return !typed.output.format->has_reports && !writes_picture(typed); }
bool has_no_samples(const Typed& typed) { return !has_sampling_option(typed); }

template <class Predicate>
bool any_field(const Typed& typed, Predicate predicate) {
  return std::ranges::any_of(typed.output.fields, [&](std::size_t field) { return predicate(fields()[field]); });
}

bool needs_all_channels(const Typed& typed) {
  const bool times_of_distances = typed.keys.rules.parameter && typed.keys.rules.parameter->exponent != 0;
  return typed.has("--equal-speed") || times_of_distances;
}

bool closes_curve(const Typed& typed) {
  const CurveSettings& rules = typed.keys.rules;
  return rules.period || (rules.closed && rules.closed->value);
}

bool paces_by_profile(const Typed& typed) { return typed.pace_profile.has_value(); }

bool extends_curve(const Typed& typed) {
  return typed.keys.rules.extrapolate && typed.keys.rules.extrapolate->extend_curve();
}

/// The curve is extended, but all samples are on it, as with steps and counts without a range in time.
bool stays_on_curve(const Typed& typed) {
  const bool has_range_of_times = !by_length(typed.sampling.mode) && (typed.has("--from") || typed.has("--to"));
  return extends_curve(typed) && !typed.has("--at") && !has_range_of_times;
}

bool has_one_mark_for_two(const Typed& typed) {
  const NumberMarks& marks = typed.keys.input.delimited.marks;
  return marks.decimal == marks.thousands;
}

constexpr std::string_view report_reason = ", which takes the samples of its file and prints a report";
constexpr std::string_view limits_reason = ", which prints a report on whole curves";
constexpr std::string_view picture_reason = ", which draws the curve and has no rows";

constexpr Options range_options{"--from", "--to", "--end", "--keys", "--max-rows"};
constexpr Options place_options{"--from", "--to", "--end", "--keys"};
constexpr Options options_of_rows{
    "--output-dir",  "--files",       "--meta", "--explain",          "--digits",           "--fixed",
    "--golden",      "--exact-input", "--hex",  "--no-output-header", "--output-delimiter", "--output-decimal",
    "--file-column", "--time-format"};
constexpr Options options_without_picture{
    "--rotation-output", "--emit",        "--fields",      "--side",       "--digits",           "--fixed",
    "--golden",          "--exact-input", "--meta",        "--hex",        "--no-output-header", "--output-delimiter",
    "--output-decimal",  "--time-zero",   "--time-format", "--file-column"};

/// The conflicts, in the order of the options. Where several apply, an error is about the first.
constexpr Conflict conflicts[] = {
    {{"--null"}, needs, {"--files"}},
    {{"--recursive", "--suffix", "--update"}, needs, {"--output-dir"}, ", an output for each file"},

    {{"--check"}, excludes, {"--identify"}},
    {{"--abs", "--rel", "--ulp"}, needs, {"--check"}},
    {{"--map"}, needs, {"--check", "--identify"}},
    {{"--check"}, disables, {"--emit", "--fit"}, report_reason},
    {{"--check"}, disables, range_options, report_reason, has_no_samples},
    {{"--identify"}, disables, sampling_options, report_reason},
    {{"--identify"}, disables, range_options, report_reason},
    {{"--check", "--identify"}, disables, options_of_rows, report_reason},
    {{"--check", "--identify"},
     disables,
     {"--output-format", "--plot"},
     ", whose report is text, json or svg",
     writes_no_report},
    {{"--identify"},
     disables,
     {"--preset", "--tangents", "--ends", "--equal-speed", "--no-overshoot", "--side"},
     ", which tries all rules on positions"},
    {{"--limits"}, excludes, {"--check", "--identify"}},
    {{"--limits"},
     disables,
     {"--exact-input"},
     ", which measures the curve through the doubles nearest to the numbers"},
    {{"--limits"}, disables, sampling_options, limits_reason, prints_limits},
    {{"--limits"},
     disables,
     {"--fields", "--side", "--end", "--keys", "--max-rows", "--extrapolate"},
     limits_reason,
     prints_limits},
    {{"--limits"}, disables, options_of_rows, limits_reason, prints_limits},
    {{"--limits"}, disables, {"--time-zero", "--rotation-output"}, limits_reason, prints_limits},
    {{"--limits"},
     disables,
     {"--output-format", "--plot"},
     ", whose report is text, json or svg",
     [](const Typed& typed) { return prints_limits(typed) && writes_no_report(typed); }},
    {{"--retime"}, needs, {"--limits"}},
    {{"--retime"}, disables, {"--fit", "--explain"}, ", which prints samples"},
    {{"--retime"}, disables, {"--output-dir", "--files"}, ", which computes the times of one file"},

    {{"--input-format"},
     disables,
     {"--delimiter", "--header", "--no-header", "--comment", "--skip-lines", "--decimal", "--thousands"},
     "",
     [](const Typed& typed) { return !typed.keys.input.format->has_marks; }},
    {{"--delimiter"},
     excludes,
     {"--decimal"},
     "",
     [](const Typed& typed) {
       const DelimitedOptions& text = typed.keys.input.delimited;
       return text.marks.decimal == ',' && text.delimiter == ',';
     }},
    {{"--header"}, excludes, {"--no-header"}},
    {{"--thousands"}, needs, {"--decimal"}, ", as the point is the decimal mark", has_one_mark_for_two},
    {{"--thousands"}, excludes, {"--decimal"}, ", as it would be both", has_one_mark_for_two},
    {{"--missing"},
     excludes,
     {"--equal-speed", "--parameter"},
     ", as all channels are needed at each key",
     [](const Typed& typed) {
       return typed.keys.input.keys.missing == Missing::skip_cell && needs_all_channels(typed);
     }},
    {{"--max-gap"}, excludes, {"--closed", "--period"}, "", closes_curve},
    {{"--max-gap"}, excludes, {"--identify"}, ", which tries rules on whole curves"},
    {{"--time-unit"}, excludes, {"--input-fps"}},
    {{"--time-start"}, needs, {"--input-fps"}, ", the rate of the rows"},
    {{"--input-fps"},
     excludes,
     {"--parameter"},
     ", as both give rows their times",
     [](const Typed& typed) { return typed.keys.rules.parameter && typed.keys.rules.parameter->exponent != 0; }},
    {{"--angles"}, needs, {"--rotation", "--rotation-output"}, ", which tells where angles are"},

    {{"--tangents"},
     disables,
     {"--tcb", "--tcb-scale", "--ends", "--equal-speed", "--no-overshoot"},
     ", which draws straight lines between keys",
     [](const Typed& typed) { return is_linear(typed.keys.rules); }},

    {{"--metric"}, has_no_effect, {}, ", as no length or speed is requested", needs_no_metric},

    {{"--count"}, excludes, {"--arc-step"}, "; --arc-count takes N samples by arc length"},
    {sampling_options, excludes, sampling_options},
    {{"--count", "--arc-count"}, disables, {"--end"}},
    {{"--per-segment", "--at", "--arc-at"}, disables, place_options},
    {{"--tolerance"}, disables, {"--from", "--to", "--end"}},
    {{"--pace"},
     excludes,
     {"--arc-step", "--arc-count", "--arc-at", "--tolerance", "--emit", "--fit"},
     ", as the pace places rows at times along the curve"},
    {{"--pace"}, excludes, {"--keys"}, ", as a pace replaces the times of the keys"},
    {{"--pace"}, excludes, {"--extrapolate"}, ", as a pace stays on the curve"},
    {{"--pace"}, excludes, {"--limits", "--retime"}, ", as limits are those of the motion by the times of the keys"},
    {{"--pace"}, excludes, {"--check", "--identify"}, ", as rows are compared with those by the times of the keys"},
    {{"--pace"},
     excludes,
     {"--fields"},
     ", as jerk is that of the times of the keys",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return field.name == "jerk"; }); }},
    {{"--pace"}, excludes, {"--golden"}, ", as the distances of a profile are doubles", paces_by_profile},
    {{"--pace"}, excludes, {"--time-zero"}, ", as rows have the times of the profile", paces_by_profile},
    {{"--pace"}, needs, {"--step", "--rate", "--fps", "--count", "--per-segment", "--at"}, ", rows at times"},
    {{"--emit"}, disables, {"--end", "--keys"}},
    {{"--emit"}, disables, {"--extrapolate"}, ", whose pieces lie between keys", extends_curve},
    {{"--fit"},
     disables,
     {"--tcb",         "--tcb-scale",      "--rotation-output",
      "--preset",      "--tangents",       "--ends",
      "--closed",      "--period",         "--equal-speed",
      "--parameter",   "--rotation-curve", "--no-ease",
      "--extrapolate", "--from",           "--to",
      "--end",         "--keys",           "--max-rows",
      "--fields",      "--side",           "--golden",
      "--exact-input", "--rename",         "--no-overshoot"},
     ", which prints keys with the default rules"},
    {{"--fit"}, disables, {"--digits", "--fixed"}, ", whose numbers have the digits that the tolerance needs"},
    {{"--fit"}, excludes, {"--plot", "--explain"}},
    {sampling_options, disables, {"--extrapolate"}, " alone, whose samples are on the curve", stays_on_curve},
    {{"--fit-keys", "--keep-times", "--corner"}, needs, {"--fit"}},

    {{"--output"}, excludes, {"--output-dir"}},
    {{"--output-format"}, excludes, {"--plot"}},
    {{"--output-format"}, disables, options_without_picture, picture_reason, writes_picture},
    {{"--output-format"},
     disables,
     {"--digits", "--fixed", "--hex"},
     ", which holds the doubles themselves",
     writes_array},
    {{"--output-format"}, disables, {"--time-format"}, ", which holds numbers only", writes_array},
    {{"--output-format"}, disables, {"--hex"}, ", which has no hexadecimal numbers", writes_no_text},
    {{"--output-format"}, disables, {"--no-output-header"}, ", which has no line of names", writes_no_text},
    {{"--output-format"},
     disables,
     {"--meta"},
     ", which has no comments",
     [](const Typed& typed) { return !typed.output.format->has_provenance; }},
    {{"--output-format"},
     disables,
     {"--fields", "--emit", "--fit", "--rotation-output", "--time-format", "--file-column", "--output-delimiter",
      "--output-decimal"},
     ", whose rows are poses",
     writes_poses},
    {{"--output-format"},
     disables,
     {"--fields", "--fit", "--rotation-output", "--digits", "--fixed", "--time-format", "--file-column",
      "--output-delimiter", "--output-decimal"},
     ", which is an animation",
     writes_scene},
    {{"--output-format"},
     disables,
     {"--emit"},
     ", whose pieces have the form hermite",
     [](const Typed& typed) { return writes_scene(typed) && typed.form && *typed.form != field_of("hermite"); }},
    {{"--plot"}, disables, options_without_picture, picture_reason, writes_picture},
    {{"--plot"}, disables, {"--end", "--keys", "--max-rows"}, ", as no samples are requested", has_no_samples},
    {{"--fields"},
     excludes,
     {"--emit"},
     ", as a piece has the fields s and length only",
     [](const Typed& typed) {
       return any_field(typed, [](const Field& field) { return !field.of_piece && field.name != "s"; });
     }},
    {{"--fields"},
     needs,
     {"--emit"},
     ", for the length of each piece",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return field.of_piece; }); }},
    {{"--side"},
     has_no_effect,
     {},
     " on these fields, which are the same on both sides",
     [](const Typed& typed) {
       if (is_comparison(typed) && !typed.has("--fields")) return false;  // it may have any field
       return !any_field(typed, [](const Field& field) { return field.has_side; });
     }},
    {{"--digits"}, excludes, {"--fixed", "--hex"}},
    {{"--digits"},
     needs,
     {"--golden"},
     ", as a double has 17 significant digits",
     [](const Typed& typed) { return typed.output.notation.count > digits_of_double; }},
    {{"--fixed"}, excludes, {"--hex"}},
    {{"--golden"},
     excludes,
     {"--fields"},
     ", as the exact s has no error",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return !field.is_exact; }); }},
    {{"--exact-input"}, needs, {"--golden"}},
    {{"--output-delimiter"}, has_no_effect, {}, " on a format other than csv", writes_no_csv},
    {{"--output-decimal"}, has_no_effect, {}, " on a format that is not delimited text", writes_no_text},
    {{"--output-decimal"}, excludes, {"--hex"}},
    {{"--output-decimal"},
     needs,
     {"--output-delimiter"},
     ", as the comma is the delimiter of csv",
     [](const Typed& typed) {
       const bool is_comma = typed.output.format->delimiter == ',';
       return typed.output.decimal == ',' && !typed.output.delimiter && is_comma;
     }},
    {{"--output-decimal"},
     excludes,
     {"--output-delimiter"},
     ", as the comma cannot be both",
     [](const Typed& typed) { return typed.output.decimal == ',' && typed.output.delimiter == ','; }},
    {{"--time-format"},
     needs,
     {"--input-fps"},
     ", the rate of the frames",
     [](const Typed& typed) { return typed.output.time_notation && counts_frames(*typed.output.time_notation); }},
    {{"--axes", "--title", "--size"}, has_no_effect, {}, " on an output that is not a picture", writes_no_picture},

    {{"--explain"},
     disables,
     {"--meta", "--digits", "--fixed", "--hex", "--no-output-header", "--output-delimiter", "--output-decimal",
      "--time-format", "--time-zero", "--file-column"},
     ", which prints no rows"},
};

/// A name, with the value if the conflict depends on values.
std::string shown(const Typed& typed, std::string_view option, When when) {
  const ValueKind kind = row_of(option).kind;
  const bool with_value = when != nullptr && kind != ValueKind::flag && typed.has(option);
  return std::string(option) + (with_value ? (kind == ValueKind::attached ? "=" : " ") + typed.value(option) : "");
}

/// Throws: Error (usage) if an option that is given is in this conflict.
void require_none(const Conflict& conflict, std::string_view name, const Typed& typed) {
  const auto is_given = [&](std::string_view other) { return other != name && typed.has(other); };
  const auto* const other = std::ranges::find_if(conflict.others, is_given);
  const bool has_other = other != conflict.others.end();
  const bool needs_other = conflict.kind == needs || conflict.kind == has_no_effect;
  if (has_other == needs_other || (conflict.when != nullptr && !conflict.when(typed))) return;
  const std::string option = shown(typed, name, conflict.when);
  switch (conflict.kind) {
    case excludes:
      throw usage_error("{} and {} cannot be combined{}; expected only one; remove the other", option,
                        shown(typed, *other, conflict.when), conflict.reason);
    case needs:
      throw usage_error("{} needs {}{}; give {}, or neither", option, fmt::join(conflict.others, " or "),
                        conflict.reason, conflict.others.size() > 1 ? "one of them as well" : "both");
    case disables:
      throw usage_error("{0} has no effect with {1}{2}; remove {0}", shown(typed, *other, conflict.when), option,
                        conflict.reason);
    case has_no_effect: throw usage_error("{} has no effect{}; remove it", option, conflict.reason);
  }
}

}  // namespace

bool has_sampling_option(const TypedOptions& typed) {
  return std::ranges::any_of(sampling_options, [&](std::string_view option) { return typed.has(option); });
}

bool is_comparison(const TypedOptions& typed) { return typed.has("--check") || typed.has("--identify"); }
bool prints_limits(const TypedOptions& typed) { return typed.has("--limits") && !typed.has("--retime"); }

bool needs_no_metric(const TypedOptions& typed) {
  const bool by_metric =
      by_length(typed.sampling) || typed.has("--tolerance") || typed.has("--fit") || needs_all_channels(typed);
  return !is_comparison(typed) && !typed.has("--limits") && !writes_picture(typed) && !by_metric &&
         !any_field(typed, [](const Field& field) { return field.needs_lengths || field.over_metric; });
}

void require_no_conflict(const TypedOptions& typed) {
  for (const Conflict& conflict : conflicts) {
    for (const std::string_view option : conflict.options) {
      if (typed.has(option)) require_none(conflict, option, typed);
    }
  }
}

}  // namespace tcb
