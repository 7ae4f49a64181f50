// Units: factors of the numbers of keys, and the unit of their times.
#include "schema/units.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "numbers/dates.hpp"
#include "schema/columns.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// Whether the times of these columns are frames that a rate turns into seconds.
bool is_converted(const UnitOptions& options, const std::string& time) {
  if (!options.frame_rate) return false;
  return !options.are_optional || unit_of_time(time) == TimeUnit::frames;
}

/// Throws: Error (data) where the column's name has another unit than the options.
void require_unit(const UnitOptions& options, const Columns& columns) {
  if (options.are_optional || !(options.frame_rate || options.time)) return;
  const std::string& time = columns.time;
  const auto named = columns.has(Role::nanoseconds) ? TimeUnit::s : unit_of_time(time);
  if (!named) return;
  const auto refuse = [&](std::string_view option, TimeUnit unit) {
    throw data_error(
        "the times are in {} by this option, but in {} by the name of column {}; expected one unit; remove the option, "
        "or rename the column",
        row_of(unit).name, row_of(*named).name, in_quotes(time))
        .about(option);
  };
  if (options.frame_rate && *named != TimeUnit::frames) refuse("--input-fps", TimeUnit::frames);
  if (options.time && *options.time != *named) refuse("--time-unit", *options.time);
}

/// The format of dates like this one; that of others if it is none. Throws: Error (data) if only an option can tell the
/// order of its numbers.
DateFormat date_format_of(const UnitOptions& options, std::string_view date, const std::string& column) {
  DateFormat format = find_date_format(date).value_or(DateFormat{});
  if (!format.needs_order()) {
    if (options.date_order && !options.are_optional)
      throw data_error(
          "the dates in column {}, such as {}, tell their order; expected dates of numbers with the year last, or "
          "years of two digits; remove the option",
          in_quotes(column), in_quotes(date))
          .about("--date-order");
    return format;
  }
  if (!options.date_order && format.has_short_year)
    throw data_error(
        "the dates in column {}, such as {}, have years of two digits; expected years of four digits, or the order of "
        "the dates; give --date-order dmy, mdy or ymd, which takes years as 1969 to 2068{}",
        in_quotes(column), in_quotes(date),
        is_usual_time(column) ? ""
                              : fmt::format(", or --columns {} if they are no dates", in_shell("ignore=" + column)));
  if (!options.date_order)
    throw data_error(
        "the dates in column {}, such as {}, have the year last; expected dates with the year first, or the order of "
        "day and month; give --date-order dmy if the day is first, or --date-order mdy if the month is",
        in_quotes(column), in_quotes(date));
  if (!format.has_short_year && *options.date_order == DateOrder::ymd)
    throw data_error(
        "the dates in column {}, such as {}, have the year last; expected dates with years of two digits; give "
        "--date-order dmy if the day is first, or --date-order mdy if the month is",
        in_quotes(column), in_quotes(date))
        .about("--date-order");
  format.order = *options.date_order;
  return format;
}

/// Throws: Error (data) for a time of day that seems to be a date, as in EXIF: 2024:03:14.
void require_no_date(std::string_view column, std::string_view time) {
  const std::string date = date_like_clock(time);
  if (date.empty()) return;
  throw data_error(
      "{}: {} is a date in a form that is not read, or a time of {} hours; expected the date as {}; write the dates "
      "so, as to_datetime of pandas does with the argument format, or such hours in seconds",
      column, in_quotes(time), time.substr(0, 4), date);
}

}  // namespace

std::optional<TimeUnit> unit_since_1970(std::string_view time) {
  const auto number = parse_rational(time);
  if (!number || floor(*number) != *number) return std::nullopt;
  constexpr std::int64_t in_2000 = 946'684'800, in_2100 = 4'102'444'800;
  for (const TimeUnit unit : {TimeUnit::s, TimeUnit::ms, TimeUnit::us, TimeUnit::ns}) {
    const Rational seconds = *number / units_per_second(unit);
    if (seconds >= in_2000 && seconds < in_2100) return unit;
  }
  return std::nullopt;
}

UnitOptions with_date_order(UnitOptions options, const std::string& column, std::span<const std::string> first_times,
                            std::vector<std::string>& notes) {
  const auto format = find_date_format(first_times[0]);
  if (options.date_order || !format || !format->needs_order()) return options;
  const DateOrderName* only = nullptr;
  for (const DateOrderName& row : date_orders) {
    const auto is_date = [&](const std::string& time) { return time.empty() || read_date(time, row.order); };
    if (!std::ranges::all_of(first_times, is_date)) continue;
    if (only != nullptr) return options;
    only = &row;
  }
  if (only == nullptr) return options;
  options.date_order = only->order;
  notes.push_back(fmt::format(
      "the dates in column {} are taken as {}, the only order in which the first ones are dates", in_quotes(column),
      only->order == DateOrder::dmy   ? "day, month, year"
      : only->order == DateOrder::mdy ? "month, day, year"
                                      : "year, month, day"));
  return options;
}

bool ends_with_minutes(const UnitOptions& options, std::string_view time) {
  return options.time == TimeUnit::minutes && find_notation(time) == TimeNotation::clock &&
         std::ranges::count(time, ':') == 1;
}

KeyUnits units_of_keys(const UnitOptions& options, const Columns& columns, std::string_view first_time) {
  KeyUnits units;
  const bool is_timed = columns.has(Role::time);
  if (is_timed) units.notation = find_notation(first_time).value_or(TimeNotation::seconds);
  if (columns.has(Role::clock) && !is_date(units.notation)) {
    throw data_error(
        "the columns of the time together are {}; expected a date and a time of day, or a year, a month and a day, "
        "with an hour, a minute and a second if there are such; correct --columns time=",
        in_quotes(first_time));
  }
  if (is_date(units.notation)) {
    units.dates = date_format_of(options, first_time, columns.time);
  } else if (options.date_order && !options.are_optional) {
    throw data_error("the times in column {} are not dates; expected dates with the year last; remove the option",
                     in_quotes(columns.time))
        .about("--date-order");
  }
  if (units.notation == TimeNotation::clock) require_no_date(columns.time, first_time);
  if (units.notation == TimeNotation::clock) units.dates.half_of_day = half_of_day(first_time);
  units.are_hours_and_minutes = ends_with_minutes(options, first_time);
  units.frame_rate = options.frame_rate;
  if (counts_frames(units.notation) && !options.frame_rate) throw times_without_rate(columns.time);
  const bool is_number = units.notation == TimeNotation::seconds;
  if (is_timed && is_number) require_unit(options, columns);
  const bool has_unit = options.time || options.frame_rate || unit_of_time(columns.time);
  if (is_timed && is_number && !has_unit) units.epoch_unit = unit_since_1970(first_time);
  if (units.epoch_unit == TimeUnit::s) units.epoch_unit.reset();
  const bool is_time_converted = is_timed && is_number && is_converted(options, columns.time);
  if (!is_time_converted && options.scales.empty()) return units;
  const std::size_t channels = columns.channels.size();
  std::vector<Rational>& factors = units.factors;
  factors.assign(NumberOfKey::position + channels * NumberOfKey::kinds, 1);
  if (is_time_converted) factors[NumberOfKey::time] = Rational(1) / *options.frame_rate;
  for (const ChannelScale& scale : options.scales) {
    const auto channel = std::ranges::find(columns.channels, scale.channel);
    if (channel == columns.channels.end()) {
      throw no_such_column(scale.channel, columns.channels).about("--scale");
    }
    factors[NumberOfKey::position + static_cast<std::size_t>(channel - columns.channels.begin())] = scale.factor;
  }
  for (std::size_t i = 0; i < channels; ++i) {
    for (const auto kind : {NumberOfKey::velocity_in_of, NumberOfKey::velocity_out_of}) {
      factors[NumberOfKey::of_channel(kind, i, channels)] =
          factors[NumberOfKey::position + i] / factors[NumberOfKey::time];
    }
  }
  return units;
}

Schema with_unit(Schema schema, const UnitOptions& options) {
  TimeSchema& time = schema.time;
  if (!time.is_given) {
    if (options.are_optional || (!options.frame_rate && !options.time)) return schema;
    if (options.time) {
      throw data_error(
          "there is no time column, but the option needs one; name the column with --columns time=NAME, or remove the "
          "option: the times are then 0, 1, 2, ..., and --step 0.5 makes two rows for each")
          .about("--time-unit");
    }
    time.is_given = time.counts_rows = true;
    time.unit = TimeUnit::s;
    time.frame_rate = options.frame_rate;
    time.start = options.start.value_or(0);
    return schema;
  }
  if (options.start && !options.are_optional)
    throw data_error("column {} has the times; expected rows without times; remove the option{}",
                     in_quotes(schema.named ? time.name : "1"),
                     time.is_by_place ? ", or give --parameter uniform if the first column is no time" : "")
        .about("--time-start");
  if (!time.unit) time.unit = options.time ? options.time : unit_of_time(time.name);
  if (time.notation != TimeNotation::seconds) {
    time.unit = TimeUnit::s;
    if (counts_frames(time.notation)) time.frame_rate = options.frame_rate;
  } else if (is_converted(options, time.name)) {
    time.unit = TimeUnit::s;
    time.frame_rate = options.frame_rate;
    if (unit_of_time(time.name) == TimeUnit::frames && !options.are_optional) time.name = "time";
  }
  return schema;
}

Error times_without_rate(std::string_view column) {
  return data_error(
      "the times in column {} are frames or timecode, but no frame rate is given; expected one; give it with "
      "--input-fps, as in --input-fps 24 or --input-fps 30000/1001",
      in_quotes(column));
}

}  // namespace tcb
