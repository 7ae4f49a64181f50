// Units: factors of the numbers of keys, and the unit of their times.
#include "schema/units.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "option_names.hpp"
#include "schema/errors.hpp"
#include "schema/key_block.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Whether the times of these columns are frames that a rate turns into seconds.
bool is_converted(const UnitOptions& options, const std::string& time) {
  if (!options.frame_rate) return false;
  return !options.of_samples || unit_of_time(time) == TimeUnit::frames;
}

/// Throws: Error (data) where the column's name has another unit than the options.
void require_unit(const UnitOptions& options, const std::string& time) {
  const auto named = unit_of_time(time);
  if (!named || options.of_samples) return;
  const auto refuse = [&](std::string_view option, TimeUnit unit) {
    throw time_units_differ(time, row_of(*named).name, row_of(unit).name).about(option);
  };
  if (options.frame_rate && *named != TimeUnit::frames) refuse(option::input_fps, TimeUnit::frames);
  if (options.time && *options.time != *named) refuse(option::time_unit, *options.time);
}

}  // namespace

void set_units(KeyRules& rules, const UnitOptions& options, const Columns& columns, std::string_view first_time) {
  const bool is_timed = columns.has(Role::time);
  if (is_timed) rules.notation = find_notation(first_time).value_or(TimeNotation::seconds);
  rules.frame_rate = options.frame_rate;
  if (counts_frames(rules.notation) && !options.frame_rate) throw times_without_rate(columns.time);
  const bool is_number = rules.notation == TimeNotation::seconds;
  if (is_timed && is_number) require_unit(options, columns.time);
  const bool is_time_converted = is_timed && is_number && is_converted(options, columns.time);
  if (!is_time_converted && options.scales.empty()) return;
  const std::size_t channels = columns.channels.size();
  rules.factors.assign(NumberOfKey::position + channels * NumberOfKey::kinds, 1);
  if (is_time_converted) rules.factors[NumberOfKey::time] = Rational(1) / *options.frame_rate;
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

Schema with_unit(Schema schema, const UnitOptions& options) {
  TimeSchema& time = schema.time;
  if (!time.is_given) {
    if (!options.frame_rate && !options.time) return schema;
    throw times_without_column().about(options.frame_rate ? option::input_fps : option::time_unit);
  }
  time.unit = options.time ? options.time : unit_of_time(time.name);
  if (time.notation != TimeNotation::seconds) {
    time.unit = TimeUnit::s;
    if (counts_frames(time.notation)) time.frame_rate = options.frame_rate;
  } else if (is_converted(options, time.name)) {
    time.unit = TimeUnit::s;
    time.frame_rate = options.frame_rate;
    if (unit_of_time(time.name) == TimeUnit::frames && !options.of_samples) time.name = "time";
  }
  return schema;
}

}  // namespace tcb
