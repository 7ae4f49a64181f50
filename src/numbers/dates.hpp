// Dates and times of day: their forms in ISO 8601, in databases and in spreadsheets, to and from exact seconds.
//
// Dates are in the Gregorian calendar, in UTC or with an offset from it; their seconds count from 1970. There are no
// other time zones and no leap seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "numbers/decimal_time.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"

namespace tcb {

/// Whether a text has the form of a pattern: 0 is a digit, 9 one digit or more, all else is itself.
bool has_form(std::string_view text, std::string_view pattern);

/// AM or PM behind a time of day, with the blank before it, also as in "11:30a" and "11:30 p.m."; empty for any other
/// text.
std::string_view half_of_day(std::string_view text);

/// hh:mm:ss.fff in seconds, also with AM or PM; nothing for an hour, minute or second that does not exist. Requires:
/// the form of a time of day.
std::optional<Rational> read_clock(std::string_view text);

/// The format of a date by its form; its order is dmy if the year is last, or has two digits. Nothing if the text is no
/// date.
std::optional<DateFormat> find_date_format(std::string_view text);

/// A date in a form that is not read, in the nearest one that is: "2024-03-14 10:00:00" for "20240314 100000" and for
/// "2024:03:14 10:00:00", the first day for a month or a week. Empty for any other text.
std::string date_in_known_form(std::string_view text);

/// As date_in_known_form(), for a time of day of 1900 hours or more that seems to be a date, as in EXIF: 2024:03:14.
std::string date_like_clock(std::string_view text);

/// The seconds of a date that has a form of find_date_format(), with its numbers in this order; nothing if that date
/// does not exist. Years of two digits are 1969 to 2068, as in POSIX (strptime, %y).
std::optional<Rational> read_date(std::string_view text, DateOrder order);

/// The whole seconds of a date and the digits of its fraction.
struct DateSeconds {
  std::int64_t seconds = 0;
  std::string_view fraction = {};
};

/// As read_date(), for dates with all digits and a time of day with seconds, in UTC without a zone or with Z, which are
/// nearly all; nothing for any other text, which read_date() may read.
std::optional<DateSeconds> read_usual_date(std::string_view text, DateOrder order, bool has_zone);

/// The seconds by which local time in a format is ahead of UTC.
std::int64_t zone_offset(const DateFormat& format);

/// Whole seconds, rounded down, and the digits of the rest with a point before them; empty where there is none.
struct SplitSeconds {
  std::int64_t whole = 0;
  std::string fraction = {};
};

/// Writes times in a notation of words. Dates of one day share its text.
class TimeWords {
 public:
  /// `rate`: frames per second, of timecode. `decimals`: how many a second has; nothing: as many as the time. `unit`:
  /// of the times; not frames.
  TimeWords(TimeNotation notation, Rational rate, std::optional<int> decimals, DateFormat dates = {},
            TimeUnit unit = TimeUnit::s);

  /// Appends a time; false where it has no words: between two frames, before 0 in timecode, or beyond the years 0 to
  /// 9999.
  bool append(std::string& out, const Time& time);

  std::optional<std::string> text(const Time& time) {
    std::string words;
    return append(words, time) ? std::optional(words) : std::nullopt;
  }

 private:
  bool append_date(std::string& out, const SplitSeconds& utc);
  bool set_day(std::int64_t day);

  TimeNotation notation_;
  Rational rate_;
  std::optional<int> decimals_;
  DateFormat dates_;
  TimeUnitRow unit_;
  std::int64_t offset_;              ///< of the zone
  std::optional<std::int64_t> day_;  ///< since 1970, of the text
  std::string day_text_;
};

}  // namespace tcb
