// Conflicts: options that exclude each other, need another, or have no effect, and conditions on their values.
#include "cli/conflicts.hpp"

#include <algorithm>
#include <string>

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "numbers/print_number.hpp"
#include "sample/curve_spec.hpp"
#include "sample/fields.hpp"
#include "schema/format.hpp"

namespace tcb {

std::string_view Conflicts::first_given(Options options) const {
  const auto is_given = [this](std::string_view option) { return option != option_ && typed_.has(option); };
  const auto* const found = std::ranges::find_if(options, is_given);
  return found == options.end() ? std::string_view() : *found;
}

/// A name, with the value if the conflict depends on values.
std::string Conflicts::shown(std::string_view option, Condition condition) const {
  const bool with_value = condition != nullptr && row_of(option).kind != ValueKind::flag && typed_.has(option);
  return std::string(option) + (with_value ? " " + typed_.text(option) : "");
}

void Conflicts::exclude(Options others, std::string_view reason, Condition condition) const {
  const std::string_view other = first_given(others);
  if (other.empty() || !is_met(condition)) return;
  throw options_exclude_each_other(shown(option_, condition), shown(other, condition), reason);
}

void Conflicts::need(Options others, std::string_view reason, Condition condition) const {
  if (!first_given(others).empty() || !is_met(condition)) return;
  throw option_needs_another(shown(option_, condition), *others.begin(), reason);
}

void Conflicts::disable(Options others, std::string_view reason, Condition condition) const {
  const std::string_view other = first_given(others);
  if (other.empty() || !is_met(condition)) return;
  throw option_without_effect_with(shown(other, condition), shown(option_, condition), reason);
}

void Conflicts::require_effect(std::string_view reason, Condition has_none) const {
  if (has_none(typed_)) throw option_without_effect(shown(option_, has_none), reason);
}

void require_no_conflict(const TypedOptions& typed) {
  for (const OptionRow& row : option_table()) {
    if (row.check != nullptr && typed.has(row.name)) row.check(Conflicts(row.name, typed));
  }
}

namespace {

const Format& output_of(const TypedOptions& typed) { return *typed.output.format; }

bool is_comparison(const TypedOptions& typed) { return typed.has(option::check) || typed.has(option::identify); }

template <class Predicate>
bool any_field(const TypedOptions& typed, Predicate predicate) {
  return std::ranges::any_of(typed.output.fields, [&](std::size_t field) { return predicate(fields()[field]); });
}

bool needs_all_channels(const TypedOptions& typed) {
  const bool times_of_distances =
      typed.has(option::parameter) && make_spec(typed.keys.rules).parameter.value_or(0) != 0;
  return typed.has(option::equal_speed) || times_of_distances;
}

}  // namespace

bool has_other_input_than_delimited(const TypedOptions& typed) {
  return typed.keys.input.format != nullptr && !typed.keys.input.format->has_marks;
}

bool has_one_comma_for_two(const TypedOptions& typed) {
  return typed.keys.input.delimited.marks.decimal == ',' && typed.keys.input.delimited.delimiter == ',';
}

bool has_one_mark_for_two(const TypedOptions& typed) {
  const NumberMarks& marks = typed.keys.input.delimited.marks;
  return marks.decimal == marks.thousands;
}

bool needs_output_delimiter(const TypedOptions& typed) {
  return typed.output.decimal == ',' && !typed.output.delimiter && output_of(typed).delimiter == ',';
}

bool has_one_output_comma_for_two(const TypedOptions& typed) {
  return typed.output.decimal == ',' && typed.output.delimiter == ',';
}

bool has_sparse_channels(const TypedOptions& typed) {
  return typed.keys.input.keys.missing == Missing::skip_cell && needs_all_channels(typed);
}

bool needs_no_metric(const TypedOptions& typed) {
  const bool by_metric = by_length(typed.sampling.mode) || typed.has(option::tolerance) || typed.has(option::fit) ||
                         needs_all_channels(typed);
  return !is_comparison(typed) && !has_picture(typed) && !by_metric &&
         !any_field(typed, [](const Field& field) { return field.needs_lengths || field.over_metric; });
}

bool extends_curve(const TypedOptions& typed) { return typed.text(option::extrapolate) != "error"; }

bool stays_on_curve(const TypedOptions& typed) {
  const bool has_range_of_times = !by_length(typed.sampling.mode) && (typed.has(option::from) || typed.has(option::to));
  return extends_curve(typed) && !typed.has(option::at) && !has_range_of_times;
}

bool has_field_of_samples(const TypedOptions& typed) {
  return any_field(typed, [](const Field& field) { return !field.of_piece && field.name != "s"; });
}

bool has_field_of_pieces(const TypedOptions& typed) {
  return any_field(typed, [](const Field& field) { return field.of_piece; });
}

bool has_rounded_field(const TypedOptions& typed) {
  return any_field(typed, [](const Field& field) { return !field.is_exact; });
}

bool has_no_side(const TypedOptions& typed) {
  if (is_comparison(typed) && !typed.has(option::fields)) return false;
  return !any_field(typed, [](const Field& field) { return field.has_side; });
}

bool has_more_digits_than_doubles(const TypedOptions& typed) { return typed.output.notation.count > digits_of_double; }

bool has_frames_of_time(const TypedOptions& typed) {
  return typed.output.time_notation && counts_frames(*typed.output.time_notation);
}

bool has_no_sampling_option(const TypedOptions& typed) {
  return std::ranges::none_of(sampling_options, [&](std::string_view option) { return typed.has(option); });
}

bool has_no_format_of_reports(const TypedOptions& typed) {
  return !output_of(typed).has_reports && !has_picture(typed);
}

bool has_picture(const TypedOptions& typed) { return output_of(typed).is_picture; }
bool has_no_picture(const TypedOptions& typed) { return !has_picture(typed); }
bool has_poses(const TypedOptions& typed) { return output_of(typed).poses != nullptr; }
bool has_scene(const TypedOptions& typed) { return output_of(typed).has_nodes; }
bool has_scene_of_other_form(const TypedOptions& typed) {
  return has_scene(typed) && typed.form && *typed.form != field_of("hermite");
}
bool has_pieces(const TypedOptions& typed) { return output_of(typed).has_pieces; }
bool has_samples_in_pieces(const TypedOptions& typed) {
  return has_pieces(typed) && (typed.sampling.mode != Mode::emit || *typed.form != field_of("poly8"));
}
bool has_binary_output(const TypedOptions& typed) { return output_of(typed).is_binary; }
bool has_no_header(const TypedOptions& typed) { return !output_of(typed).has_marks; }
bool has_fixed_delimiter(const TypedOptions& typed) { return !output_of(typed).has_any_delimiter; }
bool has_no_provenance(const TypedOptions& typed) { return !output_of(typed).has_provenance; }

}  // namespace tcb
