// Notations of times: their forms, and the conversion to and from exact seconds.
#include "numbers/time_notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>

#include "numbers/decimal_time.hpp"

namespace tcb {
namespace {

constexpr std::int64_t seconds_of_day = 86'400;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether a text has the form of a pattern: 0 is a digit, 9 one digit or more, all else is itself.
bool has_form(std::string_view text, std::string_view pattern) {
  for (const char c : pattern) {
    if (text.empty() || (c == '0' || c == '9' ? !is_digit(text[0]) : text[0] != c)) return false;
    text.remove_prefix(1);
    while (c == '9' && !text.empty() && is_digit(text[0])) text.remove_prefix(1);
  }
  return text.empty();
}

/// Takes a whole number off the beginning of a text, with the character after it.
std::int64_t take_number(std::string_view& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const auto size = static_cast<std::size_t>(end - text.data());
  text.remove_prefix(std::min(size + 1, text.size()));
  return error == std::errc() ? value : -1;
}

/// hh:mm:ss.fff in seconds. Requires: the form of a clock.
std::optional<Rational> read_clock(std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string_view whole = text.substr(0, point);
  const std::int64_t hours = take_number(whole), minutes = take_number(whole), seconds = take_number(whole);
  constexpr std::int64_t most_hours = 1'000'000'000;
  if (hours < 0 || hours > most_hours || minutes > 59 || seconds > 59) return std::nullopt;
  const auto fraction = point + 1 < text.size() ? parse_rational("0" + std::string(text.substr(point))) : Rational(0);
  if (!fraction) return std::nullopt;
  return Rational((hours * 60 + minutes) * 60 + seconds) + *fraction;
}

/// The whole rate that counts the frames of timecode, such as 30 for 30000/1001.
std::int64_t nominal_rate(const Rational& rate) { return static_cast<std::int64_t>(whole_number(-floor(-rate))); }

/// How many frame numbers each minute drops, but every tenth; 0 where timecode does not drop any.
std::int64_t dropped_numbers(const Rational& rate) {
  const std::int64_t nominal = nominal_rate(rate);
  return rate == Rational(nominal * 1000, 1001) && nominal % 30 == 0 ? nominal / 15 : 0;
}

std::optional<Rational> read_timecode(std::string_view text, bool drops, const Rational& rate) {
  const std::int64_t hours = take_number(text), minutes = take_number(text), seconds = take_number(text);
  const std::int64_t frame = take_number(text), nominal = nominal_rate(rate);
  constexpr std::int64_t most_hours = 1'000'000'000;
  if (hours < 0 || hours > most_hours || minutes > 59 || seconds > 59 || frame >= nominal) return std::nullopt;
  const std::int64_t dropped = drops ? dropped_numbers(rate) : 0;
  if (drops && (dropped == 0 || (seconds == 0 && frame < dropped && minutes % 10 != 0))) return std::nullopt;
  const std::int64_t all_minutes = hours * 60 + minutes;
  const std::int64_t number =
      (all_minutes * 60 + seconds) * nominal + frame - dropped * (all_minutes - all_minutes / 10);
  return Rational(number) / rate;
}

std::optional<Rational> read_date(std::string_view text) {
  std::string_view date = text.substr(0, 10);
  const auto year = static_cast<int>(take_number(date));
  const auto month = static_cast<unsigned>(take_number(date)), day = static_cast<unsigned>(take_number(date));
  const std::chrono::year_month_day ymd{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  if (!ymd.ok()) return std::nullopt;
  std::string_view clock = text.substr(11), offset;
  std::int64_t shift = 0;  // seconds
  if (clock.ends_with('Z')) {
    clock.remove_suffix(1);
  } else {
    const std::size_t sign = clock.find_last_of("+-");
    offset = clock.substr(sign + 1);
    const std::int64_t hours = take_number(offset), minutes = take_number(offset);
    if (hours > 23 || minutes > 59) return std::nullopt;
    shift = (hours * 60 + minutes) * 60 * (clock[sign] == '-' ? -1 : 1);
    clock = clock.substr(0, sign);
  }
  const auto time = read_clock(clock);
  if (!time || *time >= seconds_of_day) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(ymd).time_since_epoch().count();
  return Rational(days * seconds_of_day - shift) + *time;
}

/// The digits after the point of a number below 1, with a point; empty for 0.
std::string fraction_text(Rational rest, std::optional<int> decimals) {
  std::string text;
  for (int i = 0; decimals ? i < *decimals : rest != 0; ++i) {
    rest *= 10;
    const Rational digit = floor(rest);
    text += static_cast<char>('0' + whole_number(digit));
    rest -= digit;
  }
  return text.empty() ? text : "." + text;
}

std::string clock_text(const Rational& seconds, std::optional<int> decimals) {
  const Rational whole = floor(seconds);
  const std::uint64_t all = whole_number(whole);
  return fmt::format("{:02}:{:02}:{:02}{}", all / 3600, all / 60 % 60, all % 60,
                     fraction_text(seconds - whole, decimals));
}

std::optional<std::string> timecode_text(const Rational& seconds, bool drops, const Rational& rate) {
  const std::optional<Rational> frame = whole_frame(seconds, rate);
  if (!frame || *frame < 0) return std::nullopt;
  const auto nominal = static_cast<std::uint64_t>(nominal_rate(rate));
  std::uint64_t number = whole_number(*frame);
  if (drops) {
    const auto dropped = static_cast<std::uint64_t>(dropped_numbers(rate));
    if (dropped == 0) return std::nullopt;
    const std::uint64_t minute = nominal * 60 - dropped, ten_minutes = minute * 10 + dropped;
    const std::uint64_t rest = number % ten_minutes;
    number += dropped * (number / ten_minutes * 9 + (rest < minute + dropped ? 0 : (rest - dropped) / minute));
  }
  const std::uint64_t all = number / nominal;
  return fmt::format("{:02}:{:02}:{:02}{}{:02}", all / 3600, all / 60 % 60, all % 60, drops ? ';' : ':',
                     number % nominal);
}

std::optional<std::string> date_text(const Rational& seconds, std::optional<int> decimals) {
  const Rational day = floor(seconds / seconds_of_day);
  if (abs(day) > 10'000'000) return std::nullopt;
  const auto size = static_cast<int>(whole_number(abs(day)));
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(day < 0 ? -size : size))};
  const int year = static_cast<int>(date.year());
  if (year < 0 || year > 9999) return std::nullopt;
  return fmt::format("{:04}-{:02}-{:02}T{}Z", year, static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()), clock_text(seconds - day * seconds_of_day, decimals));
}

}  // namespace

std::optional<TimeNotation> find_notation(std::string_view text) {
  if (has_form(text, "9:00:00:00")) return TimeNotation::smpte;
  if (has_form(text, "9:00:00;00")) return TimeNotation::drop_frame;
  if (has_form(text, "9:00:00") || has_form(text, "9:00:00.9")) return TimeNotation::clock;
  if (text.size() < 20 || !(has_form(text.substr(0, 11), "0000-00-00T"))) return std::nullopt;
  const std::string_view clock = text.substr(11);
  for (const char* pattern :
       {"00:00:00Z", "00:00:00.9Z", "00:00:00+00:00", "00:00:00.9+00:00", "00:00:00-00:00", "00:00:00.9-00:00"}) {
    if (has_form(clock, pattern)) return TimeNotation::iso;
  }
  return std::nullopt;
}

std::optional<Rational> read_time(std::string_view text, TimeNotation notation, const Rational& rate) {
  if (find_notation(text) != notation) return std::nullopt;
  switch (notation) {
    case TimeNotation::clock: return read_clock(text);
    case TimeNotation::smpte: return read_timecode(text, false, rate);
    case TimeNotation::drop_frame: return read_timecode(text, true, rate);
    case TimeNotation::iso: return read_date(text);
    default: return std::nullopt;
  }
}

std::optional<Rational> whole_frame(const Rational& seconds, const Rational& rate) {
  const Rational nearest = floor(seconds * rate + Rational(1, 2));
  return nearest_time(nearest / rate) == nearest_time(seconds) ? std::optional(nearest) : std::nullopt;
}

std::optional<std::string> time_in_words(const Rational& seconds, TimeNotation notation, const Rational& rate,
                                         std::optional<int> decimals) {
  const bool has_fraction = notation == TimeNotation::clock || notation == TimeNotation::iso;
  const Rational rounded = has_fraction && decimals ? exact_time(rounded_to(seconds, *decimals)) : seconds;
  switch (notation) {
    case TimeNotation::clock: return rounded < 0 ? "-" + clock_text(-rounded, decimals) : clock_text(rounded, decimals);
    case TimeNotation::smpte: return timecode_text(seconds, false, rate);
    case TimeNotation::drop_frame: return timecode_text(seconds, true, rate);
    case TimeNotation::iso: return date_text(rounded, decimals);
    default: return std::nullopt;
  }
}

}  // namespace tcb
