// File notes: what is reported about an input, from its first bytes to its last curve, and about an earlier output.
#include "run/file_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/encoding.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "numbers/decimal_time.hpp"
#include "read/input.hpp"
#include "read/input_format.hpp"
#include "run/curve_pipeline.hpp"
#include "run/progress.hpp"
#include "sample/table.hpp"
#include "schema/doubts.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "write/provenance.hpp"

namespace tcb {
namespace {

Note broadcast_note(const std::string& decimal, const Rational& rate) {
  const auto ratio = [](const Rational& value) {
    return whole_text(numerator(value)) + "/" + whole_text(denominator(value));
  };
  return rate_of_broadcast(decimal, ratio(rate), ratio(parse_rational(decimal).value_or(rate)));
}

Note angles_note(const std::vector<NamedAngle>& angles) {
  std::string list;
  std::vector<std::string_view> names;
  for (const auto& [name, degrees] : angles) {
    list += fmt::format("{}{}={}", list.empty() ? "" : ",", name, degrees ? "degrees" : "radians");
    names.push_back(name);
  }
  const bool may_be_euler = std::ranges::all_of(
      std::array{"yaw", "pitch", "roll"}, [&](std::string_view name) { return std::ranges::count(names, name) > 0; });
  return angles_jump(in_shell(list), may_be_euler);
}

/// The columns of positions where they follow from their names, and these tell little; else nothing. A format that has
/// columns of its own needs no names.
std::vector<std::string> found_by_elimination(const Input& input) {
  const Schema& schema = input.schema;
  if (input.facts.format->input->has_own_columns || !schema.named) return {};
  std::vector<bool> is_of_rotation(schema.channels.size());
  for (const RotationSchema& rotation : schema.rotations) {
    for (const std::size_t channel : rotation.columns.channels) is_of_rotation[channel] = true;
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    if (!is_of_rotation[i]) names.push_back(schema.channels[i]);
  }
  return std::ranges::all_of(names, is_usual_channel) ? std::vector<std::string>{} : names;
}

/// What doubts look at in a request.
RequestNeeds needs_of(const Input& input, const KeyOptions& options, const SamplingRequest& request,
                      std::span<const std::size_t> chosen) {
  RequestNeeds needs;
  needs.by_length = by_length(request.mode);
  needs.lengths = needs.by_length || options.rules.equal_speed ||
                  std::ranges::any_of(chosen, [](std::size_t field) { return fields()[field].over_metric; });
  const bool is_of_format = !input.facts.format->has_marks && !input.facts.format->is_json;
  needs.chooses_metric = options.rules.metric || input.keys.curve_info.settings.metric || is_of_format;
  needs.chooses_columns = !options.input.columns.roles.empty() || options.input.columns.timeless || is_of_format;
  needs.time_gap = input.facts.time_gap;
  if (request.mode == Mode::step && request.in_seconds.step) needs.step = nearest_double(request.step);
  return needs;
}

}  // namespace

FileNotes::FileNotes(Report& report, const std::string& path) : report_(report), path_(path) {
  if (is_terminal(path)) add(reads_terminal());
}

void FileNotes::add_input(const Input& input, const KeyOptions& options, const SamplingRequest& request,
                          std::span<const std::size_t> fields) {
  for (const std::string& doubt : input.facts.doubts) add({doubt, true});
  for (const std::string& doubt : doubts_of_request(input.schema, needs_of(input, options, request, fields))) {
    add({doubt, true});
  }
  if (!input.facts.encoding.empty()) {
    const bool is_all = input.facts.encoding != name_of(Encoding::windows_1252);
    const std::string_view named = input.keys.traits.has_whole_curves ? "objects and tracks" : "columns";
    add(is_all ? text_converted(input.facts.encoding) : names_converted(named, input.facts.encoding));
  }
  if (input.facts.shape == JsonShape::table_by_index) add(index_is_time());
  if (options.input.records.empty() && !input.facts.records.empty()) add(keys_at(input.facts.records));
  if (input.facts.names_quaternion) add(names_of_quaternion());
  if (!input.schema.time.is_given && !options.rules.parameter) add(no_time_column());
  if (input.schema.time.notation == TimeNotation::date) add(dates_in_utc(input.schema.time.name));
  const UnitOptions& units = options.input.units;
  if (!units.rate_as_decimal.empty()) add(broadcast_note(units.rate_as_decimal, *units.frame_rate));
  if (!request.rate_as_decimal.empty() && request.rate_as_decimal != units.rate_as_decimal) {
    add(broadcast_note(request.rate_as_decimal, Rational(1) / request.step));
  }
  time_name_ = input.schema.time.name;
  const TimeSchema& time = input.schema.time;
  const auto& period = options.rules.period;
  const bool has_duration = request.in_seconds.has_duration || (period && read_duration(period->value));
  if (time.epoch_unit) {
    add(times_since_1970(time.name, row_of(*time.epoch_unit).name));
  } else if (has_duration && !time.unit) {
    add(times_as_seconds(time.name));
  }
  if (request.is_rate && input.schema.time.unit == TimeUnit::frames) add(rate_of_frames(input.schema.time.name));
  const bool chosen = std::ranges::count(options.input.columns.roles, Role::position, &RoleRequest::role) > 0;
  if (!chosen && options.input.renamings.empty()) {
    const std::vector<std::string> names = found_by_elimination(input);
    if (!names.empty()) add(positions_by_elimination(names));
  }
  if (!input.facts.other_objects.empty()) add(other_objects_left_out(input.facts.other_objects));
  if (!input.facts.other_tracks.empty()) add(other_tracks_left_out(input.facts.other_tracks));
  if (!input.facts.constant_tracks.empty()) add(constant_tracks_left_out(input.facts.constant_tracks));
  if (!input.facts.ignored.empty()) {
    add(chosen ? unchosen_columns(input.facts.ignored) : ignored_columns(input.facts.ignored));
  }
}

void FileNotes::add_samples(const CurveSamples& samples, const SamplingRequest& request, bool is_closed) {
  const auto distance = samples.remainder();
  const bool ends_at_key = !request.to && !is_closed;
  if (distance && remainders_++ == 0) add(remainder_note(nearest_time(*distance).hi, ends_at_key));
  if (samples.facts.rows) {
    rows_ += *samples.facts.rows;
    least_rows_ += *samples.facts.least_rows;
  }
  if (samples.facts.step && request.end != EndPolicy::drop) add(step_is(time_text(*samples.facts.step)));
}

void FileNotes::end(const Curves& curves) {
  if (remainders_ > 1) add(more_remainders(remainders_ - 1));
  if (rows_ > 0) add(rows_within(rows_, least_rows_));
  if (curves.skipped() > 0) add(skipped_rows(curves.skipped()));
  if (curves.gaps() > 0) add(gaps_divide(curves.gaps(), curves.largest_gap()));
  if (curves.midnights() > 0) add(midnights_passed(time_name_));
  if (const auto angles = curves.likely_angles(); !angles.empty()) add(angles_note(angles));
}

void warn_of_other_program(Report& report, const std::optional<ProvenanceRequest>& request) {
  if (!request || request->from.empty()) return;
  const std::string &earlier = request->earlier.program, &current = request->meta.program;
  if (earlier != current) report.warning(request->from, other_program(earlier, current));
}

}  // namespace tcb
