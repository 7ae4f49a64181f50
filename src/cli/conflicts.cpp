// Conflicts: the one table of options that exclude each other, need another, or have no effect.
#include "cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "numbers/print_number.hpp"
#include "sample/curve_spec.hpp"
#include "sample/fields.hpp"
#include "schema/formats.hpp"

namespace tcb {
namespace {

using enum Relation;
using O = Option;
using Typed = TypedOptions;

// Conditions on values.

bool is_comparison(const Typed& typed) { return typed.has(O::check) || typed.has(O::identify); }

bool has_json_input(const Typed& typed) {
  return typed.job.input.format && !format_of(*typed.job.input.format).has_header;
}

const Format& output_of(const Typed& typed) { return format_of(typed.job.output_format); }
bool has_rows_as_report(const Typed& typed) {
  return typed.job.output_format != FormatId::json && !output_of(typed).is_picture;
}
bool has_frames_without_rate(const Typed& typed) {
  return typed.job.time_notation && counts_frames(*typed.job.time_notation);
}
bool has_binary_output(const Typed& typed) { return output_of(typed).is_binary; }
bool has_no_header(const Typed& typed) { return !output_of(typed).has_header; }
bool has_picture(const Typed& typed) { return output_of(typed).is_picture; }
bool has_no_picture(const Typed& typed) { return !has_picture(typed); }
bool has_no_provenance(const Typed& typed) { return !output_of(typed).has_provenance; }

bool has_one_comma_for_two(const Typed& typed) {
  return typed.job.input.decimal == ',' && typed.job.input.delimiter == ',';
}

bool has_more_digits_than_doubles(const Typed& typed) { return typed.notation.count > digits_of_double; }

template <class Predicate>
bool any_field(const Typed& typed, Predicate predicate) {
  return std::ranges::any_of(typed.job.fields, [&](std::size_t field) { return predicate(fields()[field]); });
}

/// Fields that rows of pieces do not have.
bool has_field_of_samples(const Typed& typed) {
  return any_field(typed, [](const Field& field) { return !field.of_piece && field.name != "s"; });
}
bool has_field_of_pieces(const Typed& typed) {
  return any_field(typed, [](const Field& field) { return field.of_piece; });
}

bool has_rounded_field(const Typed& typed) {
  return any_field(typed, [](const Field& field) { return !field.is_exact; });
}

bool needs_all_channels(const Typed& typed) {
  const bool times_of_distances = typed.has(O::parameter) && make_spec(typed.job.curve).parameter.value_or(0) != 0;
  return typed.has(O::equal_speed) || times_of_distances;
}

bool has_sparse_channels(const Typed& typed) {
  return typed.job.input.missing == Missing::skip_cell && needs_all_channels(typed);
}

/// No length, speed or distance is requested.
bool needs_no_metric(const Typed& typed) {
  const bool by_metric =
      by_length(typed.job.sampling.mode) || typed.has(O::tolerance) || typed.has(O::fit) || needs_all_channels(typed);
  return !is_comparison(typed) && !has_picture(typed) && !by_metric &&
         !any_field(typed, [](const Field& field) { return field.needs_lengths || field.over_metric; });
}

/// No field can differ between the two sides of a key. Without fields, a comparison may have any of them.
bool has_no_side(const Typed& typed) {
  if (is_comparison(typed) && !typed.has(O::fields)) return false;
  return !any_field(typed, [](const Field& field) { return field.has_side; });
}

bool extends_curve(const Typed& typed) { return typed.text(O::extrapolate) != "error"; }

/// All samples are on the curve, as those of steps and counts are unless their range is given in time.
bool stays_on_curve(const Typed& typed) {
  const bool given_range = !by_length(typed.job.sampling.mode) && (typed.has(O::from) || typed.has(O::to));
  return extends_curve(typed) && !typed.has(O::at) && !given_range;
}

constexpr OptionSet modes = sampling_options;
constexpr OptionSet modes_without_steps{O::count,     O::segments, O::per_segment, O::at,
                                        O::arc_count, O::arc_at,   O::tolerance,   O::emit};
constexpr OptionSet text_input{O::delimiter, O::header, O::no_header, O::comment, O::decimal};
constexpr OptionSet rule_options{O::preset, O::tangents, O::ends, O::equal_speed, O::side};
constexpr OptionSet notations{O::digits, O::fixed, O::hex};
constexpr OptionSet reports{O::check, O::identify};
constexpr std::string_view for_report = ", which takes the samples of its file and prints a report";

constexpr std::array conflict_rows{
    // files
    Conflict{{O::output, O::output_dir}, exclude},
    Conflict{{O::recursive, O::suffix, O::update, O::fail_fast}, need, {O::output_dir}, ", an output for each file"},
    Conflict{{O::null}, need, {O::files}},
    Conflict{{O::progress}, exclude, {O::no_progress, O::quiet}},
    // comparison
    Conflict{{O::check, O::identify}, exclude},
    Conflict{{O::abs, O::rel, O::ulp}, need, {O::check}},
    Conflict{{O::map}, need, {O::check, O::identify}},
    Conflict{modes | OptionSet{O::from, O::to, O::end, O::keys, O::max_rows}, idle, reports, for_report},
    Conflict{{O::output_dir, O::files, O::explain, O::progress, O::meta}, idle, reports, for_report},
    Conflict{notations | OptionSet{O::golden, O::exact_input, O::no_output_header, O::file_column, O::time_format},
             idle, reports, for_report},
    Conflict{{O::output_format, O::plot}, idle, reports, ", whose report is text, json or svg", has_rows_as_report},
    Conflict{rule_options, idle, {O::identify}, ", which tries all rules on positions"},
    // input
    Conflict{{O::header, O::no_header}, exclude},
    Conflict{{O::time_unit, O::input_fps}, exclude},
    Conflict{{O::angles}, need, {O::rotation, O::rotation_output}, ", which tells where angles are"},
    Conflict{text_input, idle, {O::input_format}, "", has_json_input},
    Conflict{{O::decimal, O::delimiter}, exclude, {}, "", has_one_comma_for_two},
    // curve
    Conflict{{O::missing},
             exclude,
             {O::equal_speed, O::parameter},
             ", as all channels are needed at each key",
             has_sparse_channels},
    Conflict{{O::metric}, idle, {}, ", as no length or speed is requested", needs_no_metric},
    // sampling
    Conflict{modes, exclude},
    Conflict{{O::from, O::to}, idle, {O::per_segment, O::at, O::arc_at, O::tolerance}},
    Conflict{{O::end}, idle, modes_without_steps},
    Conflict{{O::keys}, idle, {O::per_segment, O::at, O::arc_at, O::emit}},
    Conflict{{O::fields}, exclude, {O::emit}, ", as a piece has the fields s and length only", has_field_of_samples},
    Conflict{{O::fields}, need, {O::emit}, ", for the length of each piece", has_field_of_pieces},
    Conflict{{O::extrapolate}, idle, {O::emit}, ", whose pieces lie between keys", extends_curve},
    Conflict{{O::extrapolate}, idle, modes, " alone, whose samples are on the curve", stays_on_curve},
    // fit
    Conflict{{O::fit_keys, O::keep_times, O::corner}, need, {O::fit}},
    Conflict{rule_options | OptionSet{O::fields, O::golden, O::exact_input, O::keys, O::from, O::to, O::end,
                                      O::extrapolate, O::closed, O::period, O::parameter, O::tcb, O::tcb_scale,
                                      O::rotation_output, O::rotation_curve, O::rename, O::no_ease, O::max_rows},
             idle,
             {O::fit},
             ", which prints keys with the default rules"},
    Conflict{{O::digits, O::fixed}, idle, {O::fit}, ", whose numbers have the digits that the tolerance needs"},
    Conflict{{O::plot, O::explain}, exclude, {O::fit}},
    // pictures
    Conflict{{O::plot}, exclude, {O::output_format}},
    Conflict{{O::axes, O::title, O::size}, idle, {}, " on an output that is not a picture", has_no_picture},
    Conflict{notations | OptionSet{O::fields, O::side, O::golden, O::exact_input, O::meta, O::no_output_header, O::emit,
                                   O::rotation_output},
             idle,
             {O::output_format, O::plot},
             ", which draws the curve and has no rows",
             has_picture},
    // output
    Conflict{{O::side}, idle, {}, " on these fields, which are the same on both sides", has_no_side},
    Conflict{notations, exclude},
    Conflict{notations, idle, {O::output_format}, ", which holds the doubles themselves", has_binary_output},
    Conflict{{O::time_format}, idle, {O::output_format}, ", which holds numbers only", has_binary_output},
    Conflict{{O::time_format}, need, {O::input_fps}, ", the rate of the frames", has_frames_without_rate},
    Conflict{{O::hex}, idle, {O::output_format}, ", which has no hexadecimal numbers", has_no_header},
    Conflict{{O::no_output_header}, idle, {O::output_format}, ", which has no line of names", has_no_header},
    Conflict{{O::exact_input}, need, {O::golden}},
    Conflict{{O::digits}, need, {O::golden}, ", as a double has 17 significant digits", has_more_digits_than_doubles},
    Conflict{{O::golden}, exclude, {O::fields}, ", as the exact s has no error", has_rounded_field},
    Conflict{{O::meta}, idle, {O::explain}, ", which prints no rows"},
    Conflict{{O::meta}, idle, {O::output_format}, ", which has no comments", has_no_provenance},
};

/// The first option of a set that is given, after `previous`.
std::optional<Option> first_given(const Typed& typed, const OptionSet& options,
                                  std::optional<Option> previous = std::nullopt) {
  for (std::size_t i = previous ? index_of(*previous) + 1 : 0; i < option_count; ++i) {
    const Option option = option_table()[i].id;
    if (options.has(option) && typed.has(option)) return option;
  }
  return std::nullopt;
}

/// The option that conflicts with the first one given, if any; for Relation::need, one that is missing.
std::optional<Option> other_option(const Conflict& conflict, Option given, const Typed& typed) {
  if (conflict.relation == need) {
    if (first_given(typed, conflict.others)) return std::nullopt;
    return std::ranges::find_if(option_table(), [&](const OptionRow& row) { return conflict.others.has(row.id); })->id;
  }
  const bool among_themselves = conflict.relation == exclude && conflict.others.empty();
  return among_themselves ? first_given(typed, conflict.options, given) : first_given(typed, conflict.others);
}

/// Throws: Error (usage) about both options, with their values if the conflict depends on them.
[[noreturn]] void refuse(const Conflict& conflict, Option given, std::optional<Option> other, const Typed& typed) {
  const auto shown = [&](Option option) {
    const OptionRow& row = row_of(option);
    const bool with_value = conflict.applies != nullptr && row.kind != ValueKind::flag && typed.has(option);
    return std::string(row.long_name()) + (with_value ? " " + typed.text(option) : "");
  };
  std::vector<ErrorValue> values{shown(given)};
  if (other) values.emplace_back(shown(*other));
  values.emplace_back(std::string(conflict.reason));
  const ErrorCode code = conflict.relation == exclude ? ErrorCode::options_exclude
                         : conflict.relation == need  ? ErrorCode::option_needs
                         : other                      ? ErrorCode::option_idle_with
                                                      : ErrorCode::option_idle;
  throw Error(Exit::usage, code, std::move(values));
}

}  // namespace

std::span<const Conflict> conflict_table() { return conflict_rows; }

void require_no_conflict(const TypedOptions& typed) {
  for (const Conflict& conflict : conflict_rows) {
    const std::optional<Option> given = first_given(typed, conflict.options);
    if (!given) continue;
    const std::optional<Option> other = other_option(conflict, *given, typed);
    const bool needs_other = conflict.relation != idle || !conflict.others.empty();
    if (needs_other && !other) continue;
    if (conflict.applies != nullptr && !conflict.applies(typed)) continue;
    refuse(conflict, *given, other, typed);
  }
}

void set_output_format(TypedOptions& typed, bool earlier) {
  const std::string& path = typed.text(Option::output);
  const bool is_report = typed.has(Option::check) || typed.has(Option::identify);
  const std::optional<FormatId> named = format_by_ending(path);
  if (!named || (is_report && *named != FormatId::json)) return;
  const std::string name(format_of(*named).name), given(format_of(typed.job.output_format).name);
  if (typed.has(Option::output_format) || typed.has(Option::plot) || earlier) {
    if (name != given) throw Error(Exit::usage, ErrorCode::output_of_other_format, {path, name, given});
    return;
  }
  if (*named == formats[0].id) return;  // as without the ending
  typed.job.output_format = *named;
  typed.texts[index_of(Option::output_format)] = name;
}

}  // namespace tcb
