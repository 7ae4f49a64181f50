// Conflicts: options that exclude each other, need another, or have no effect, as one table.
#include "cli/options.hpp"

#include <algorithm>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "sample/table.hpp"
#include "schema/format.hpp"

namespace tcb {
namespace {

using Typed = TypedOptions;

using Options = std::initializer_list<std::string_view>;

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
bool writes_pieces(const Typed& typed) { return typed.output.format->has_pieces; }
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
  return typed.has(option::equal_speed) || times_of_distances;
}

bool extends_curve(const Typed& typed) {
  return typed.keys.rules.extrapolate && typed.keys.rules.extrapolate->extend_curve();
}

/// The curve is extended, but all samples are on it, as with steps and counts without a range in time.
bool stays_on_curve(const Typed& typed) {
  const bool has_range_of_times = !by_length(typed.sampling.mode) && (typed.has(option::from) || typed.has(option::to));
  return extends_curve(typed) && !typed.has(option::at) && !has_range_of_times;
}

bool has_one_mark_for_two(const Typed& typed) {
  const NumberMarks& marks = typed.keys.input.delimited.marks;
  return marks.decimal == marks.thousands;
}

constexpr std::string_view report_reason = ", which takes the samples of its file and prints a report";
constexpr std::string_view limits_reason = ", which prints a report on whole curves";
constexpr std::string_view picture_reason = ", which draws the curve and has no rows";

constexpr Options range_options{option::from, option::to, option::end, option::keys, option::max_rows};
constexpr Options place_options{option::from, option::to, option::end, option::keys};
constexpr Options options_of_rows{option::output_dir,
                                  option::files,
                                  option::meta,
                                  option::explain,
                                  option::progress,
                                  option::digits,
                                  option::fixed,
                                  option::golden,
                                  option::exact_input,
                                  option::hex,
                                  option::no_output_header,
                                  option::output_delimiter,
                                  option::output_decimal,
                                  option::like_input,
                                  option::file_column,
                                  option::time_format};
constexpr Options options_without_picture{option::rotation_output,
                                          option::emit,
                                          option::fields,
                                          option::side,
                                          option::digits,
                                          option::fixed,
                                          option::golden,
                                          option::exact_input,
                                          option::meta,
                                          option::hex,
                                          option::no_output_header,
                                          option::output_delimiter,
                                          option::output_decimal,
                                          option::like_input,
                                          option::time_zero};

/// The conflicts, in the order of the options. Where several apply, an error is about the first.
constexpr Conflict conflicts[] = {
    {{option::null}, needs, {option::files}},
    {{option::recursive, option::suffix, option::update, option::fail_fast},
     needs,
     {option::output_dir},
     ", an output for each file"},

    {{option::check}, excludes, {option::identify}},
    {{option::abs, option::rel, option::ulp}, needs, {option::check}},
    {{option::map}, needs, {option::check, option::identify}},
    {{option::check}, disables, {option::emit, option::fit}, report_reason},
    {{option::check}, disables, range_options, report_reason, has_no_samples},
    {{option::identify}, disables, sampling_options, report_reason},
    {{option::identify}, disables, range_options, report_reason},
    {{option::check, option::identify}, disables, options_of_rows, report_reason},
    {{option::check, option::identify},
     disables,
     {option::output_format, option::plot},
     ", whose report is text, json or svg",
     writes_no_report},
    {{option::identify},
     disables,
     {option::preset, option::tangents, option::ends, option::equal_speed, option::no_overshoot, option::side},
     ", which tries all rules on positions"},
    {{option::limits}, excludes, {option::check, option::identify}},
    {{option::limits},
     disables,
     {option::exact_input},
     ", which measures the curve through the doubles nearest to the numbers"},
    {{option::limits}, disables, sampling_options, limits_reason, prints_limits},
    {{option::limits},
     disables,
     {option::fields, option::side, option::end, option::keys, option::max_rows, option::extrapolate},
     limits_reason,
     prints_limits},
    {{option::limits}, disables, options_of_rows, limits_reason, prints_limits},
    {{option::limits},
     disables,
     {option::output_format, option::plot},
     ", whose report is text, json or svg",
     [](const Typed& typed) { return prints_limits(typed) && writes_no_report(typed); }},
    {{option::retime}, needs, {option::limits}},
    {{option::retime}, disables, {option::fit, option::explain}, ", which prints samples"},
    {{option::retime}, disables, {option::output_dir, option::files}, ", which computes the times of one file"},

    {{option::input_format},
     disables,
     {option::delimiter, option::header, option::no_header, option::comment, option::skip_lines, option::units,
      option::decimal, option::thousands},
     "",
     [](const Typed& typed) { return !typed.keys.input.format->has_marks; }},
    {{option::delimiter},
     excludes,
     {option::decimal},
     "",
     [](const Typed& typed) {
       const DelimitedOptions& text = typed.keys.input.delimited;
       return text.marks.decimal == ',' && text.delimiter == ',';
     }},
    {{option::header}, excludes, {option::no_header}},
    {{option::thousands}, needs, {option::decimal}, ", as the point is the decimal mark", has_one_mark_for_two},
    {{option::thousands}, excludes, {option::decimal}, ", as it would be both", has_one_mark_for_two},
    {{option::missing},
     excludes,
     {option::equal_speed, option::parameter},
     ", as all channels are needed at each key",
     [](const Typed& typed) {
       return typed.keys.input.keys.missing == Missing::skip_cell && needs_all_channels(typed);
     }},
    {{option::max_gap}, excludes, {option::closed, option::period}},
    {{option::max_gap}, excludes, {option::identify}, ", which tries rules on whole curves"},
    {{option::time_unit}, excludes, {option::input_fps}},
    {{option::angles}, needs, {option::rotation, option::rotation_output}, ", which tells where angles are"},

    {{option::metric}, has_no_effect, {}, ", as no length or speed is requested", needs_no_metric},

    {sampling_options, excludes, sampling_options},
    {{option::count, option::segments, option::arc_count}, disables, {option::end}},
    {{option::per_segment, option::at, option::arc_at}, disables, place_options},
    {{option::tolerance}, disables, {option::from, option::to, option::end}},
    {{option::emit}, disables, {option::end, option::keys}},
    {{option::emit}, disables, {option::extrapolate}, ", whose pieces lie between keys", extends_curve},
    {{option::fit},
     disables,
     {option::tcb,         option::tcb_scale,      option::rotation_output,
      option::preset,      option::tangents,       option::ends,
      option::closed,      option::period,         option::equal_speed,
      option::parameter,   option::rotation_curve, option::no_ease,
      option::extrapolate, option::from,           option::to,
      option::end,         option::keys,           option::max_rows,
      option::fields,      option::side,           option::golden,
      option::exact_input, option::rename,         option::no_overshoot},
     ", which prints keys with the default rules"},
    {{option::fit},
     disables,
     {option::digits, option::fixed},
     ", whose numbers have the digits that the tolerance needs"},
    {{option::fit}, excludes, {option::plot, option::explain}},
    {sampling_options, disables, {option::extrapolate}, " alone, whose samples are on the curve", stays_on_curve},
    {{option::fit_keys, option::keep_times, option::corner}, needs, {option::fit}},

    {{option::output}, excludes, {option::output_dir}},
    {{option::output_format}, excludes, {option::plot}},
    {{option::output_format}, disables, options_without_picture, picture_reason, writes_picture},
    {{option::output_format},
     disables,
     {option::digits, option::fixed, option::hex},
     ", which holds the doubles themselves",
     writes_array},
    {{option::output_format}, disables, {option::time_format}, ", which holds numbers only", writes_array},
    {{option::output_format}, disables, {option::hex}, ", which has no hexadecimal numbers", writes_no_text},
    {{option::output_format}, disables, {option::no_output_header}, ", which has no line of names", writes_no_text},
    {{option::output_format},
     disables,
     {option::meta},
     ", which has no comments",
     [](const Typed& typed) { return !typed.output.format->has_provenance; }},
    {{option::output_format},
     disables,
     {option::fields, option::emit, option::fit, option::rotation_output, option::time_format, option::file_column,
      option::output_delimiter, option::output_decimal, option::like_input},
     ", whose rows are poses",
     writes_poses},
    {{option::output_format},
     disables,
     {option::fields, option::fit, option::rotation_output, option::digits, option::fixed, option::time_format,
      option::file_column, option::output_delimiter, option::output_decimal, option::like_input},
     ", which is an animation",
     writes_scene},
    {{option::output_format},
     disables,
     {option::emit},
     ", whose pieces have the form hermite",
     [](const Typed& typed) { return writes_scene(typed) && typed.form && *typed.form != field_of("hermite"); }},
    {{option::output_format},
     disables,
     {option::fields, option::fit, option::rotation_output, option::hex, option::time_format, option::file_column,
      option::output_delimiter, option::output_decimal, option::like_input},
     ", whose rows are polynomials",
     writes_pieces},
    {{option::output_format},
     disables,
     sampling_options,
     ", whose rows have the form poly8",
     [](const Typed& typed) {
       const bool has_form = typed.sampling.mode == Mode::emit && *typed.form == field_of("poly8");
       return writes_pieces(typed) && !has_form;
     }},
    {{option::plot}, disables, options_without_picture, picture_reason, writes_picture},
    {{option::fields},
     excludes,
     {option::emit},
     ", as a piece has the fields s and length only",
     [](const Typed& typed) {
       return any_field(typed, [](const Field& field) { return !field.of_piece && field.name != "s"; });
     }},
    {{option::fields},
     needs,
     {option::emit},
     ", for the length of each piece",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return field.of_piece; }); }},
    {{option::side},
     has_no_effect,
     {},
     " on these fields, which are the same on both sides",
     [](const Typed& typed) {
       if (is_comparison(typed) && !typed.has(option::fields)) return false;  // it may have any field
       return !any_field(typed, [](const Field& field) { return field.has_side; });
     }},
    {{option::digits}, excludes, {option::fixed, option::hex}},
    {{option::digits},
     needs,
     {option::golden},
     ", as a double has 17 significant digits",
     [](const Typed& typed) { return typed.output.notation.count > digits_of_double; }},
    {{option::fixed}, excludes, {option::hex}},
    {{option::golden},
     excludes,
     {option::fields},
     ", as the exact s has no error",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return !field.is_exact; }); }},
    {{option::exact_input}, needs, {option::golden}},
    {{option::output_delimiter}, has_no_effect, {}, " on a format other than csv", writes_no_csv},
    {{option::output_delimiter}, excludes, {option::like_input}},
    {{option::output_decimal}, has_no_effect, {}, " on a format that is not delimited text", writes_no_text},
    {{option::output_decimal}, excludes, {option::like_input, option::hex}},
    {{option::output_decimal},
     needs,
     {option::output_delimiter},
     ", as the comma is the delimiter of csv",
     [](const Typed& typed) {
       const bool is_comma = typed.output.format->delimiter == ',';
       return typed.output.decimal == ',' && !typed.output.delimiter && is_comma;
     }},
    {{option::output_decimal},
     excludes,
     {option::output_delimiter},
     ", as the comma cannot be both",
     [](const Typed& typed) { return typed.output.decimal == ',' && typed.output.delimiter == ','; }},
    {{option::like_input}, has_no_effect, {}, " on a format other than csv", writes_no_csv},
    {{option::like_input}, excludes, {option::hex}},
    {{option::time_format},
     needs,
     {option::input_fps},
     ", the rate of the frames",
     [](const Typed& typed) { return typed.output.time_notation && counts_frames(*typed.output.time_notation); }},
    {{option::axes, option::title, option::size},
     has_no_effect,
     {},
     " on an output that is not a picture",
     writes_no_picture},

    {{option::explain}, disables, {option::meta}, ", which prints no rows"},
    {{option::progress}, excludes, {option::no_progress, option::quiet}},
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
      throw usage_error("{} needs {}{}; give both, or neither", option, *conflict.others.begin(), conflict.reason);
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

bool is_comparison(const TypedOptions& typed) { return typed.has(option::check) || typed.has(option::identify); }
bool prints_limits(const TypedOptions& typed) { return typed.has(option::limits) && !typed.has(option::retime); }

bool needs_no_metric(const TypedOptions& typed) {
  const bool by_metric = by_length(typed.sampling.mode) || typed.has(option::tolerance) || typed.has(option::fit) ||
                         needs_all_channels(typed);
  return !is_comparison(typed) && !typed.has(option::limits) && !writes_picture(typed) && !by_metric &&
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
