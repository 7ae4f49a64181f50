// Units: factors of the numbers of keys, and the unit of their times.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"

namespace tcb {

struct Columns;
struct Schema;

struct ChannelScale {
  std::string channel;
  Rational factor;
};

struct UnitOptions {
  std::optional<TimeUnit> time = {};         ///< nothing: that of the column's name, if it has one
  std::optional<Rational> frame_rate = {};   ///< the times are frames, so many of them a second
  std::optional<Rational> start = {};        ///< the time of the first of rows without times, in seconds
  std::string rate_as_decimal = {};          ///< such as "29.97", where that rate is 30000/1001; else empty
  std::vector<ChannelScale> scales = {};     ///< factors of channels
  std::optional<DateOrder> date_order = {};  ///< of dates that do not tell it
  bool are_optional = false;  ///< a file may have other units and notations of time: frames only by the column's name
};

struct KeyUnits {
  TimeNotation notation = TimeNotation::seconds;  ///< of the times
  DateFormat dates = {};                          ///< of times that are dates
  bool are_hours_and_minutes = false;             ///< times such as 06:45, which are else minutes and seconds
  std::optional<TimeUnit> epoch_unit = {};        ///< in which times without a unit seem to count from 1970
  std::optional<Rational> frame_rate = {};        ///< of timecode
  std::vector<Rational> factors = {};             ///< of the numbers of a key, in the order of NumberOfKey; none: all 1
};

/// The times in a column are frames or timecode.
Error times_without_rate(std::string_view column);

/// The unit in which a whole number counts the time since 1970, by its size: from 2000 to 2100. The ranges of units do
/// not overlap.
std::optional<TimeUnit> unit_since_1970(std::string_view time);

/// Whether a time such as 06:45 is hours and minutes, as --time-unit min says.
bool ends_with_minutes(const UnitOptions& options, std::string_view time);

/// The options with the only order of year, month and day in which all times of the first records are dates, and a note
/// of it; the same options where dates tell their order, or it is not known. Requires: `first_times` is not empty.
UnitOptions with_date_order(UnitOptions options, const std::string& column, std::span<const std::string> first_times,
                            std::vector<std::string>& notes);

/// The units of keys, whose notation of times is that of the first of them. Throws: Error (data) for timecode without a
/// rate, dates without their order, units of time that contradict each other, and a channel that no column is.
KeyUnits units_of_keys(const UnitOptions& options, const Columns& columns, std::string_view first_time);

/// The meaning of records once their times have the unit to which the factors of units_of_keys() convert them. Throws:
/// Error (data) for a unit of times that records do not have.
Schema with_unit(Schema schema, const UnitOptions& options);

}  // namespace tcb
