// Units and notations of times: seconds, frames, hours:minutes:seconds, SMPTE timecode, and dates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "numbers/rational.hpp"

namespace tcb {

enum class TimeUnit { s, ms, us, ns, minutes, hours, days, frames };

/// One second is units / seconds of this unit. A frame has no duration of its own.
struct TimeUnitRow {
  std::string_view name;
  TimeUnit unit;
  std::int64_t units, seconds = 1;
};

/// The units by their names for options, in the order of TimeUnit.
inline constexpr std::array time_units{
    TimeUnitRow{"s", TimeUnit::s, 1},
    TimeUnitRow{"ms", TimeUnit::ms, 1'000},
    TimeUnitRow{"us", TimeUnit::us, 1'000'000},
    TimeUnitRow{"ns", TimeUnit::ns, 1'000'000'000},
    TimeUnitRow{"min", TimeUnit::minutes, 1, 60},
    TimeUnitRow{"h", TimeUnit::hours, 1, 3'600},
    TimeUnitRow{"d", TimeUnit::days, 1, 86'400},
    TimeUnitRow{"frames", TimeUnit::frames, 1},
};

inline const TimeUnitRow& row_of(TimeUnit unit) { return time_units[static_cast<std::size_t>(unit)]; }

/// How many units a second has. Requires: not frames.
inline Rational units_per_second(TimeUnit unit) { return Rational(row_of(unit).units) / row_of(unit).seconds; }

/// The seconds of a duration such as 30min, 30m or 20ms, in a unit other than frames; nothing for other texts.
std::optional<Rational> read_duration(std::string_view text);

/// The decimals by which the frame rates of NTSC video go. Source: SMPTE ST 12-1 (30000/1001 and its multiples).
struct BroadcastRate {
  std::string_view decimal;
  int frames;  ///< in 1001 / 1000 seconds
};
inline constexpr std::array broadcast_rates{BroadcastRate{"23.976", 24}, BroadcastRate{"23.98", 24},
                                            BroadcastRate{"29.97", 30},  BroadcastRate{"47.952", 48},
                                            BroadcastRate{"59.94", 60},  BroadcastRate{"119.88", 120}};

/// The rate of NTSC video for which a decimal such as "29.97" stands; nothing for other texts.
std::optional<Rational> broadcast_rate(std::string_view text);

/// Timecode counts the frames of a second in whole numbers.
inline constexpr int most_frames_per_second = 1'000'000'000;

/// The rate of frames that a number is, also such a decimal; nothing for one that is not above 0, or beyond the most.
std::optional<Rational> frame_rate_in(std::string_view text);

enum class TimeNotation {
  seconds,     ///< a number
  frames,      ///< a number of frames
  clock,       ///< hh:mm:ss.fff, or mm:ss.fff, or a time of day with AM or PM
  smpte,       ///< hh:mm:ss:ff
  drop_frame,  ///< hh:mm:ss;ff, without the first frame numbers of most minutes
  date,        ///< YYYY-MM-DD hh:mm:ss.fff, and the other formats of dates.hpp, without a zone: in UTC
  zoned_date,  ///< YYYY-MM-DDThh:mm:ss.fffZ, and others with a zone
};

struct TimeNotationName {
  std::string_view name;
  TimeNotation notation;
};

/// The notations that can be requested; SMPTE timecode drops frames if the input does.
inline constexpr std::array time_notations{
    TimeNotationName{"seconds", TimeNotation::seconds}, TimeNotationName{"frames", TimeNotation::frames},
    TimeNotationName{"clock", TimeNotation::clock}, TimeNotationName{"smpte", TimeNotation::smpte},
    TimeNotationName{"iso", TimeNotation::zoned_date}};

/// Whether a notation counts frames, and so needs their rate.
constexpr bool counts_frames(TimeNotation notation) {
  return notation == TimeNotation::frames || notation == TimeNotation::smpte || notation == TimeNotation::drop_frame;
}

/// The notation of a text that is not a number, by its form; nothing if it has none of these forms.
std::optional<TimeNotation> find_notation(std::string_view text);

constexpr bool is_date(TimeNotation notation) {
  return notation == TimeNotation::date || notation == TimeNotation::zoned_date;
}

/// The order of the year, the month and the day.
enum class DateOrder { ymd, dmy, mdy };

struct DateOrderName {
  std::string_view name;
  DateOrder order;
};

/// The orders that can be requested, as a date with the year last, or with a year of two digits, does not tell which
/// number is the day.
inline constexpr std::array date_orders{DateOrderName{"dmy", DateOrder::dmy}, DateOrderName{"mdy", DateOrder::mdy},
                                        DateOrderName{"ymd", DateOrder::ymd}};

/// How dates are written.
struct DateFormat {
  DateOrder order = DateOrder::ymd;
  bool has_short_year = false;   ///< years are read from two digits, and written with four
  char mark = '-';               ///< between year, month and day: - / . or a blank; 0: none
  std::string month_name = {};   ///< of a month as written, such as "Mar"; empty: months are numbers
  bool is_padded = true;         ///< months, days and hours have two digits
  char before_clock = 'T';       ///< between the date and the time of day: T or a blank; 0: midnight is not written
  std::string half_of_day = {};  ///< AM or PM as written, with the blank before it; empty: the day has 24 hours
  std::string zone = "Z";        ///< as written, with the blank before it; empty: none, and the time is in UTC

  /// The text does not tell which number is the day.
  bool needs_order() const { return has_short_year || (order != DateOrder::ymd && month_name.empty()); }
};

/// The seconds of a time in words, which may be no time, such as a minute 60, or a frame number that is dropped or not
/// below the rate. `rate`: frames per second. `order`: of dates. Source of dropped numbers: SMPTE ST 12-1.
std::optional<Rational> read_time(std::string_view text, TimeNotation notation, const Rational& rate,
                                  DateOrder order = DateOrder::ymd);

/// The seconds after which times of day and timecode begin again; nothing for other notations.
std::optional<Rational> day_of(TimeNotation notation, const Rational& rate);

/// The frame at a time in seconds that was rounded once, as times in an input or on a grid are; nothing between frames.
std::optional<Rational> whole_frame(const Rational& seconds, const Rational& rate);

/// SMPTE timecode at a time in seconds; nothing between two frames, and before 0. `drops`: the first frame numbers of
/// most minutes.
std::optional<std::string> timecode_text(const Rational& seconds, bool drops, const Rational& rate);

}  // namespace tcb
