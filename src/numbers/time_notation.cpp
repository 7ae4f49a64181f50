// Notations of times: their forms, and the conversion to and from exact seconds.
#include "numbers/time_notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "numbers/dates.hpp"
#include "numbers/decimal_time.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Takes a whole number off the beginning of a text, with the character after it.
std::int64_t take_number(std::string_view& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const auto size = static_cast<std::size_t>(end - text.data());
  text.remove_prefix(std::min(size + 1, text.size()));
  return error == std::errc() ? value : -1;
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
  const auto part = text.empty() ? Rational(0) : parse_rational("0." + std::string(text));  // of a frame
  constexpr std::int64_t most_hours = 1'000'000'000;
  if (hours < 0 || hours > most_hours || minutes > 59 || seconds > 59 || frame >= nominal || !part) return std::nullopt;
  const std::int64_t dropped = drops ? dropped_numbers(rate) : 0;
  if (drops && (dropped == 0 || (seconds == 0 && frame < dropped && minutes % 10 != 0))) return std::nullopt;
  const std::int64_t all_minutes = hours * 60 + minutes;
  const std::int64_t number =
      (all_minutes * 60 + seconds) * nominal + frame - dropped * (all_minutes - all_minutes / 10);
  return (Rational(number) + *part) / rate;
}

/// hh:mm:ss.fff, or mm:ss.fff, or a time of day with AM or PM.
bool is_clock(std::string_view text) {
  text.remove_suffix(half_of_day(text).size());
  return has_form(text, "9:00:00") || has_form(text, "9:00:00.9") || has_form(text, "9:00") || has_form(text, "9:00.9");
}

/// What follows the days of a duration such as "0 days 00:00:01.5" or "1 day, 0:00:01"; empty for any other text.
std::string_view without_days(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  for (const std::string_view words : {" days ", " days, ", " day, ", " day "}) {
    if (text.substr(digits).starts_with(words)) return text.substr(digits + words.size());
  }
  return {};
}

std::optional<Rational> read_days_and_clock(std::string_view text) {
  const std::string_view clock = without_days(text);
  std::int64_t days = 0;
  if (!clock.empty()) {
    constexpr std::int64_t most_days = 10'000'000;
    days = take_number(text);
    if (days < 0 || days > most_days) return std::nullopt;
    text = clock;
  }
  const auto parts = [](std::string_view left) {  // mm:ss, of any number of minutes
    const std::int64_t minutes = take_number(left);
    return fmt::format("{}:{:02}:{}", minutes / 60, minutes % 60, left);
  };
  const std::optional<Rational> seconds =
      std::ranges::count(text, ':') == 2 || !half_of_day(text).empty() ? read_clock(text) : read_clock(parts(text));
  return seconds ? std::optional(*seconds + Rational(days) * 86'400) : std::nullopt;
}

}  // namespace

std::optional<TimeNotation> find_notation(std::string_view text) {
  if (text.empty() || text[0] < '0' || text[0] > '9') return std::nullopt;
  if (has_form(text, "9:00:00:00") || has_form(text, "9:00:00:00.9")) return TimeNotation::smpte;
  if (has_form(text, "9:00:00;00") || has_form(text, "9:00:00;00.9")) return TimeNotation::drop_frame;
  if (is_clock(text) || is_clock(without_days(text))) return TimeNotation::clock;
  const std::optional<DateFormat> dates = find_date_format(text);
  if (!dates) return std::nullopt;
  return dates->zone.empty() ? TimeNotation::date : TimeNotation::zoned_date;
}

std::optional<Rational> read_time(std::string_view text, TimeNotation notation, const Rational& rate, DateOrder order) {
  if (find_notation(text) != notation) return std::nullopt;
  switch (notation) {
    case TimeNotation::clock: return read_days_and_clock(text);
    case TimeNotation::smpte: return read_timecode(text, false, rate);
    case TimeNotation::drop_frame: return read_timecode(text, true, rate);
    case TimeNotation::date:
    case TimeNotation::zoned_date: return read_date(text, order);
    default: return std::nullopt;
  }
}

std::optional<Rational> whole_frame(const Rational& seconds, const Rational& rate) {
  const Rational nearest = floor(seconds * rate + Rational(1, 2));
  return nearest_time(nearest / rate) == nearest_time(seconds) ? std::optional(nearest) : std::nullopt;
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

std::optional<Rational> read_duration(std::string_view text) {
  const auto is_letter = [](char c) { return lower(c) >= 'a' && lower(c) <= 'z'; };
  std::string_view number = text;
  while (!number.empty() && is_letter(number.back())) number.remove_suffix(1);
  const std::string_view name = text.substr(number.size());
  const auto unit = std::ranges::find(time_units, name == "m" ? "min" : name, &TimeUnitRow::name);
  if (unit == time_units.end() || unit->unit == TimeUnit::frames) return std::nullopt;
  const std::optional<Rational> value = parse_rational(number);
  return value ? std::optional(*value / units_per_second(unit->unit)) : std::nullopt;
}

std::optional<Rational> day_of(TimeNotation notation, const Rational& rate) {
  switch (notation) {
    case TimeNotation::clock: return Rational(86'400);
    case TimeNotation::smpte: return read_timecode("24:00:00:00", false, rate);
    case TimeNotation::drop_frame: return read_timecode("24:00:00;00", true, rate);
    default: return std::nullopt;
  }
}

std::optional<Rational> broadcast_rate(std::string_view text) {
  const auto known = std::ranges::find(broadcast_rates, text, &BroadcastRate::decimal);
  return known == broadcast_rates.end() ? std::nullopt : std::optional(Rational(known->frames * 1000, 1001));
}

std::optional<Rational> frame_rate_in(std::string_view text) {
  if (const auto known = broadcast_rate(text)) return known;
  const auto rate = parse_rational(text);
  return rate && *rate > 0 && *rate <= most_frames_per_second && within_doubles(1 / *rate) ? rate : std::nullopt;
}

}  // namespace tcb
