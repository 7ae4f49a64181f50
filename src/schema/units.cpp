// Units and names of an input: factors of its numbers, the unit of its times, and new names for its columns.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "schema/columns.hpp"
#include "schema/errors.hpp"
#include "schema/input.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Whether the times of these columns are frames that a rate turns into seconds.
bool is_converted(const InputOptions& options, const std::string& time) {
  if (!options.input_rate) return false;
  return !options.samples || unit_of_time(time) == TimeUnit::frames;
}

/// Throws: Error (data) where the column's name has another unit than the options.
void require_unit(const InputOptions& options, const std::string& time) {
  const auto named = unit_of_time(time);
  if (!named || options.samples) return;
  const auto refuse = [&](std::string_view option, TimeUnit unit) {
    throw time_units_differ(time, row_of(*named).name, row_of(unit).name).about(option);
  };
  if (options.input_rate && *named != TimeUnit::frames) refuse(option::input_fps, TimeUnit::frames);
  if (options.time_unit && *options.time_unit != *named) refuse(option::time_unit, *options.time_unit);
}

/// All names of an input.
std::vector<std::string*> names_of(Input& input) {
  std::vector<std::string*> names;
  if (input.timed) names.push_back(&input.time);
  const auto is_shown = [&](std::size_t channel) {
    return std::ranges::none_of(input.rotations, [&](const RotationColumns& rotation) {
      return rotation.shown.form != spline::RotationForm::quaternion && rotation.has(channel);
    });
  };
  for (std::size_t i = 0; i < input.channels.size(); ++i) {
    if (is_shown(i)) names.push_back(&input.channels[i]);
  }
  for (auto& list : input.rotation_names) {
    for (std::string& name : list) names.push_back(&name);
  }
  for (auto* const list : {&input.groups, &input.carried}) {
    for (std::string& name : *list) names.push_back(&name);
  }
  return names;
}

/// Throws: Error (data) about an option by which two columns have the same name.
void require_other_names(Input& input, std::string_view option) {
  std::vector<std::string> known;
  for (const std::string* name : names_of(input)) {
    if (std::ranges::count(known, *name) > 0) throw same_output_names(*name).about(option);
    known.push_back(*name);
  }
}

/// Throws: Error (data) for a name that no column has, and where two columns would have the same name.
void rename(Input& input, const std::vector<Renaming>& renamings) {
  const std::vector<std::string*> names = names_of(input);
  std::vector<std::string> before;
  before.reserve(names.size());
  for (const std::string* name : names) before.push_back(*name);
  for (const Renaming& renaming : renamings) {
    const auto found = std::ranges::find(before, renaming.from);
    if (found == before.end()) throw no_such_column(renaming.from, before).about(option::rename);
    *names[static_cast<std::size_t>(found - before.begin())] = renaming.to;
  }
  require_other_names(input, option::rename);
}

}  // namespace

void set_units(KeyRules& rules, const InputOptions& options, const Columns& columns, std::string_view first_time) {
  const bool is_timed = columns.has(Role::time);
  if (is_timed) rules.notation = find_notation(first_time).value_or(TimeNotation::seconds);
  rules.frame_rate = options.input_rate;
  if (counts_frames(rules.notation) && !options.input_rate) throw times_without_rate(columns.time);
  const bool is_number = rules.notation == TimeNotation::seconds;
  if (is_timed && is_number) require_unit(options, columns.time);
  const bool is_time_converted = is_timed && is_number && is_converted(options, columns.time);
  if (!is_time_converted && options.scales.empty()) return;
  const std::size_t channels = columns.channels.size();
  rules.factors.assign(NumberOfKey::position + channels * NumberOfKey::kinds, 1);
  if (is_time_converted) rules.factors[NumberOfKey::time] = Rational(1) / *options.input_rate;
  for (const ChannelScale& scale : options.scales) {
    const auto channel = std::ranges::find(columns.channels, scale.channel);
    if (channel == columns.channels.end()) {
      throw no_such_column(scale.channel, columns.channels).about(option::scale);
    }
    rules.factors[NumberOfKey::position + static_cast<std::size_t>(channel - columns.channels.begin())] = scale.factor;
  }
  rules.factors[NumberOfKey::duration] = rules.factors[NumberOfKey::time];
  for (std::size_t i = 0; i < channels; ++i) {
    rules.factors[NumberOfKey::of_channel(NumberOfKey::end_position_of, i, channels)] =
        rules.factors[NumberOfKey::position + i];
    for (const auto kind : {NumberOfKey::velocity_in_of, NumberOfKey::velocity_out_of, NumberOfKey::end_velocity_of}) {
      rules.factors[NumberOfKey::of_channel(kind, i, channels)] =
          rules.factors[NumberOfKey::position + i] / rules.factors[NumberOfKey::time];
    }
  }
}

void set_units_and_names(Input& input, const InputOptions& options) {
  if (options.rotation.shown && !options.samples) require_other_names(input, option::rotation_output);
  if (!input.timed) {
    if (options.input_rate || options.time_unit) {
      throw times_without_column().about(options.input_rate ? option::input_fps : option::time_unit);
    }
  } else {
    const bool is_number = input.time_notation == TimeNotation::seconds;
    input.time_unit = options.time_unit ? options.time_unit : unit_of_time(input.time);
    if (!is_number) {
      input.time_unit = TimeUnit::s;
      if (counts_frames(input.time_notation)) input.frame_rate = options.input_rate;
    } else if (is_converted(options, input.time)) {
      input.time_unit = TimeUnit::s;
      input.frame_rate = options.input_rate;
      if (unit_of_time(input.time) == TimeUnit::frames && !options.samples) input.time = "time";
    }
  }
  if (!options.renamings.empty()) rename(input, options.renamings);
}

}  // namespace tcb
