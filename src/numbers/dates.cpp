// Dates and times of day: their forms in ISO 8601, in databases and in spreadsheets, to and from exact seconds.
#include "numbers/dates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::int64_t seconds_of_day = 86'400;

/// Before the fraction of a second, as in ISO 8601.
bool is_mark(char c) { return c == '.' || c == ','; }

/// Whether the character fits one of a pattern of has_form().
bool fits(char c, char pattern) {
  return pattern == '0' || pattern == '9' ? is_digit(c) : pattern == '.' ? is_mark(c) : c == pattern;
}

bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// Takes the digits off the beginning of a text.
std::string_view take_digits(std::string_view& text) {
  const auto size = static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  const std::string_view digits = text.substr(0, size);
  text.remove_prefix(size);
  return digits;
}

/// A whole number; -1 if it is too large.
std::int64_t number_of(std::string_view digits) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() ? value : -1;
}

constexpr std::array<std::string_view, 12> month_names{"january",   "february", "march",    "april",
                                                       "may",       "june",     "july",     "august",
                                                       "september", "october",  "november", "december"};

/// The number of a month by its English name or the first three letters of that; 0 for other texts.
unsigned month_of(std::string_view text) {
  const std::string name = in_lower_case(text);
  const auto found = std::ranges::find_if(
      month_names, [&](std::string_view month) { return name == month || name == month.substr(0, 3); });
  return found == month_names.end() ? 0 : static_cast<unsigned>(found - month_names.begin()) + 1;
}

/// The name of a month, as long and with such letters as another one.
std::string month_like(std::string_view other, unsigned month) {
  constexpr std::size_t short_size = 3;
  std::string name(month_names[month - 1].substr(0, other.size() == short_size ? short_size : std::string::npos));
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char like = other[std::min(i, other.size() - 1)];
    if (like != lower(like)) name[i] = static_cast<char>(name[i] - 'a' + 'A');
  }
  return name;
}

/// The parts of a date as they are written.
struct DateParts {
  std::array<std::string_view, 3> numbers;  ///< of the year, month and day, in the order of the text
  char mark;
  std::string_view month_name;  ///< in place of the month's number; or empty
  char before_clock;            ///< 0: the time of day is missing
  std::string_view clock, half_of_day, zone;

  bool is_year_first() const { return numbers[0].size() == 4; }
  bool has_short_year() const { return !is_year_first() && numbers[2].size() != 4; }
};

/// Takes AM or PM off the beginning of a text, with the blank before it.
std::string_view take_half_of_day(std::string_view& text) {
  for (const std::string_view form : {" a.m.", " am", " a", "a.m.", "am", "a"}) {
    const std::string_view half = text.substr(0, form.size());
    if (!std::ranges::equal(half, form, [](char c, char of_form) {
          return lower(c) == of_form || (of_form == 'a' && lower(c) == 'p');
        }))
      continue;
    text.remove_prefix(half.size());
    return half;
  }
  return {};
}

bool is_after_noon(std::string_view half_of_day) { return half_of_day.find_first_of("pP") != std::string_view::npos; }

bool is_zone(std::string_view text) {
  if (text.starts_with(' ')) text.remove_prefix(1);
  constexpr std::array forms{"Z", "UTC", "+00:00", "-00:00", "+0000", "-0000", "+00", "-00"};
  return std::ranges::any_of(forms, [text](std::string_view form) { return has_form(text, form); });
}

std::optional<DateParts> parts_of(std::string_view text) {
  DateParts parts{};
  parts.numbers[0] = take_digits(text);
  const auto is_one_of = [](char c, std::string_view all) { return all.find(c) != std::string_view::npos; };
  parts.mark = !text.empty() && is_one_of(text[0], "-/. ") ? text[0] : '\0';
  for (std::size_t i = 1; i < 3; ++i) {
    if (parts.mark != 0 && !text.starts_with(parts.mark)) return std::nullopt;
    if (parts.mark != 0) text.remove_prefix(1);
    if (i == 1) {
      const auto end = std::ranges::find_if_not(text, is_letter);
      parts.month_name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
      text.remove_prefix(parts.month_name.size());
    }
    if (i == 2 || parts.month_name.empty()) parts.numbers[i] = take_digits(text);
  }
  const bool has_month =
      parts.month_name.empty() ? parts.mark != 0 && parts.mark != ' ' : month_of(parts.month_name) > 0;
  if (!has_month) return std::nullopt;
  const auto is_short = [](std::string_view digits) { return digits.size() == 1 || digits.size() == 2; };
  const std::string_view year = parts.numbers[parts.is_year_first() ? 0 : 2];
  const std::string_view other = parts.numbers[parts.is_year_first() ? 2 : 0];
  const bool is_month = !parts.month_name.empty() || is_short(parts.numbers[1]);
  const bool is_year = year.size() == 4 || (is_short(year) && (year.size() == 2 || other.size() == 2));
  if (!is_year || !is_short(other) || !is_month) return std::nullopt;
  if (text.empty()) return parts;
  parts.before_clock = text[0];
  text.remove_prefix(1);
  const auto end = std::ranges::find_if_not(text, [](char c) { return is_digit(c) || c == ':' || is_mark(c); });
  parts.clock = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  parts.zone = text.substr(parts.clock.size());
  parts.half_of_day = take_half_of_day(parts.zone);
  constexpr std::array forms{"00:00:00", "00:00:00.9", "00:00", "0:00:00", "0:00:00.9", "0:00"};
  const bool has_clock = std::ranges::any_of(forms, [&](std::string_view form) { return has_form(parts.clock, form); });
  const bool is_separated = parts.before_clock == 'T' || parts.before_clock == ' ';
  return has_clock && is_separated && (parts.zone.empty() || is_zone(parts.zone)) ? std::optional(parts) : std::nullopt;
}

/// The parts of what may be a date: year, month, day, hours, minutes, seconds and their fraction, the date in any
/// order.
struct LooseDate {
  std::vector<std::string_view> parts;
  std::string marks;      ///< the one character after each part but the last
  std::string_view rest;  ///< what follows
};

/// Appends digits without marks between them, as in 20240314 and 100000, in parts of these sizes.
void append_parts(LooseDate& date, std::string_view digits, std::initializer_list<std::size_t> sizes, char mark) {
  for (const std::size_t size : sizes) {
    if (digits.empty()) return;
    date.parts.push_back(digits.substr(0, size));
    digits.remove_prefix(std::min(size, digits.size()));
    if (!digits.empty()) date.marks += mark;
  }
}

/// Takes a month off the beginning of a text: a name, or digits.
std::string_view take_month(std::string_view& text) {
  const std::string_view name =
      text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin()));
  if (month_of(name) == 0) return take_digits(text);
  text.remove_prefix(name.size());
  return name;
}

LooseDate loose_date(std::string_view text) {
  LooseDate date;
  for (date.rest = text;;) {
    const std::string_view digits = date.parts.size() == 1 ? take_month(date.rest) : take_digits(date.rest);
    if (date.parts.empty() && digits.size() == 8) {
      append_parts(date, digits, {4, 2, 2}, '-');
    } else if (date.parts.size() == 3 && (digits.size() == 4 || digits.size() == 6)) {
      append_parts(date, digits, {2, 2, 2}, ':');
    } else {
      date.parts.push_back(digits);
    }
    const bool is_zone_next = date.parts.size() > 4 && (date.rest.starts_with('+') || date.rest.starts_with('-'));
    const bool is_month_next = date.parts.size() == 1 && date.rest.size() > 1 && is_letter(date.rest[1]);
    if (date.rest.size() < 2 || is_zone_next || !(is_digit(date.rest[1]) || is_month_next)) return date;
    date.marks += date.rest[0];
    date.rest.remove_prefix(1);
  }
}

/// A day in the form of the others.
std::string day_text(std::chrono::sys_days day) {
  const std::chrono::year_month_day date{day};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

/// A date by its week, as in 2024-W11-4, 2024W114 and 2024-W11, or by its day of the year, as in 2024-074, as one by
/// its month; with what follows it. Empty for any other text.
std::string date_by_month(std::string_view text) {
  using std::chrono::days;
  for (const std::string_view form : {"0000-W00-0", "0000W000", "0000-W00", "0000W00", "0000-000"}) {
    if (!has_form(text.substr(0, form.size()), form)) continue;
    const std::string_view rest = text.substr(form.size());
    if (!rest.empty() && rest[0] != 'T' && rest[0] != ' ') continue;
    const std::chrono::year year(static_cast<int>(number_of(text.substr(0, 4))));
    const std::chrono::sys_days first = year / 1 / 1, next = (year + std::chrono::years(1)) / 1 / 1;
    const std::size_t mark = text.find('W');
    if (mark == std::string_view::npos) {
      const std::int64_t day = number_of(text.substr(5, 3));
      const std::chrono::sys_days date = first + days(day - 1);
      return day > 0 && date < next ? day_text(date) + std::string(rest) : "";
    }
    const auto first_week = [](std::chrono::sys_days begin) {  // its Monday; it has the year's fourth day
      const std::chrono::sys_days fourth = begin + days(3);
      return fourth - days(std::chrono::weekday(fourth).iso_encoding() - 1);
    };
    const std::int64_t week = number_of(text.substr(mark + 1, 2));
    const bool has_day = form == "0000-W00-0" || form == "0000W000";
    const std::int64_t day = has_day ? number_of(text.substr(form.size() - 1, 1)) : 1;
    const std::chrono::sys_days date = first_week(first) + days(7 * (week - 1) + day - 1);
    const bool exists = week > 0 && day > 0 && day < 8 && date < first_week(next);
    return exists ? day_text(date) + std::string(rest) : "";
  }
  return "";
}

/// The text if it is a date that exists, or empty.
std::string known_form(const std::string& text) {
  const auto exists = [&](DateOrder order) { return read_date(text, order).has_value(); };
  return exists(DateOrder::ymd) || exists(DateOrder::dmy) || exists(DateOrder::mdy) ? text : "";
}

/// The seconds by which the clocks of a zone are ahead of UTC; nothing for one that does not exist.
std::optional<std::int64_t> offset_of(std::string_view zone) {
  const std::size_t sign = zone.find_first_of("+-");
  if (sign == std::string_view::npos) return 0;
  std::string_view digits = zone.substr(sign + 1);
  const std::int64_t hours = number_of(digits.substr(0, 2));
  const std::int64_t minutes = digits.size() > 2 ? number_of(digits.substr(digits.size() - 2)) : 0;
  if (hours > 23 || minutes > 59) return std::nullopt;
  return (hours * 60 + minutes) * 60 * (zone[sign] == '-' ? -1 : 1);
}

using Digits = LongDecimal::Digits;

/// Sets the last digits of a text of zeros to those of a number.
void set_digits(std::string& text, Digits value) {
  constexpr std::size_t digits = 18;
  constexpr std::uint64_t split = 1'000'000'000'000'000'000;
  for (std::size_t end = text.size(); value != 0; end -= std::min(end, digits), value /= split) {
    std::size_t at = end;
    for (auto part = static_cast<std::uint64_t>(value % split); part != 0; part /= 10) {
      text[--at] = static_cast<char>('0' + part % 10);
    }
  }
}

/// Nothing from 10^18 seconds on. `decimals`: as in TimeWords.
std::optional<SplitSeconds> split_seconds(LongDecimal seconds, std::optional<int> decimals) {
  constexpr std::int64_t most_seconds = 1'000'000'000'000'000'000;
  constexpr int most_places = 38;
  if (decimals) seconds = rounded(seconds, *decimals);
  for (; seconds.exponent > 0; --seconds.exponent) {
    if (seconds.digits >= most_seconds) return std::nullopt;
    seconds.digits *= 10;
  }
  Digits unit = 1;
  for (int i = std::max(seconds.exponent, -most_places); i < 0; ++i) unit *= 10;
  const bool has_whole = seconds.exponent >= -most_places;
  const Digits whole = has_whole ? seconds.digits / unit : 0, rest = seconds.digits - whole * unit;
  if (whole >= most_seconds) return std::nullopt;
  SplitSeconds result{static_cast<std::int64_t>(whole)};
  std::string& fraction = result.fraction;
  if (rest != 0) {
    fraction.assign(static_cast<std::size_t>(1 - seconds.exponent), '0');
    fraction[0] = '.';
    set_digits(fraction, rest);
    fraction.resize(fraction.find_last_not_of('0') + 1);
  }
  if (seconds.negative) {
    result.whole = -result.whole - (rest == 0 ? 0 : 1);
    for (char& digit : fraction) digit = digit == '.' ? '.' : static_cast<char>('9' - digit + '0');
    if (rest != 0) ++fraction.back();
  }
  if (decimals && *decimals > 0) {
    if (fraction.empty()) fraction = ".";
    fraction.resize(static_cast<std::size_t>(*decimals) + 1, '0');
  }
  return result;
}

bool is_zero(const SplitSeconds& seconds) {
  return seconds.whole == 0 && seconds.fraction.find_first_not_of(".0") == std::string::npos;
}

/// hh:mm:ss.fff. Requires: seconds >= 0.
void append_clock(std::string& out, const SplitSeconds& seconds) {
  const std::int64_t hours = seconds.whole / 3600;
  if (hours > 99) out += std::to_string(hours / 100);
  const auto digit = [](std::int64_t number) { return static_cast<char>('0' + number % 10); };
  const std::int64_t minute = seconds.whole / 60 % 60, second = seconds.whole % 60;
  const std::array clock{digit(hours / 10),  digit(hours), ':', digit(minute / 10), digit(minute), ':',
                         digit(second / 10), digit(second)};
  out.append(clock.data(), clock.size());
  out += seconds.fraction;
}

}  // namespace

bool has_form(std::string_view text, std::string_view pattern) {
  for (const char c : pattern) {
    if (text.empty() || !fits(text[0], c)) return false;
    text.remove_prefix(1);
    while (c == '9' && !text.empty() && is_digit(text[0])) text.remove_prefix(1);
  }
  return text.empty();
}

std::string_view half_of_day(std::string_view text) {
  text.remove_prefix(text.find_last_of("0123456789") + 1);
  const std::string_view half = take_half_of_day(text);
  return text.empty() || is_zone(text) ? half : std::string_view();
}

std::optional<Rational> read_clock(std::string_view text) {
  const std::string_view half = half_of_day(text);
  text.remove_suffix(half.size());
  const std::size_t point = std::min(text.find_first_of(".,"), text.size());
  std::string_view whole = text.substr(0, point);
  std::array<std::int64_t, 3> numbers{};  // hours, minutes, seconds
  for (std::int64_t& number : numbers) {
    number = number_of(take_digits(whole));
    if (whole.empty()) break;
    whole.remove_prefix(1);
  }
  constexpr std::int64_t most_hours = 1'000'000'000;
  auto [hours, minutes, seconds] = numbers;
  if (hours < 0 || hours > most_hours || minutes > 59 || seconds > 59) return std::nullopt;
  if (!half.empty()) {
    if (hours < 1 || hours > 12) return std::nullopt;
    hours = hours % 12 + (is_after_noon(half) ? 12 : 0);
  }
  const auto fraction =
      point + 1 < text.size() ? parse_rational("0." + std::string(text.substr(point + 1))) : Rational(0);
  if (!fraction) return std::nullopt;
  return Rational((hours * 60 + minutes) * 60 + seconds) + *fraction;
}

std::optional<DateFormat> find_date_format(std::string_view text) {
  const std::optional<DateParts> parts = parts_of(text);
  if (!parts) return std::nullopt;
  const bool has_short_number = std::ranges::any_of(parts->numbers, [](auto digits) { return digits.size() == 1; });
  const bool is_padded = !has_short_number && (parts->clock.empty() || parts->clock[1] != ':');
  return DateFormat{parts->is_year_first() ? DateOrder::ymd : DateOrder::dmy,
                    parts->has_short_year(),
                    parts->mark,
                    std::string(parts->month_name),
                    is_padded,
                    parts->before_clock,
                    std::string(parts->half_of_day),
                    std::string(parts->zone)};
}

std::string date_in_known_form(std::string_view text) {
  if (find_date_format(text) || text.find_first_not_of("0123456789") == std::string_view::npos) return "";
  if (const std::string by_month = date_by_month(text); !by_month.empty()) return known_form(by_month);
  const LooseDate date = loose_date(text);
  if (date.parts.size() < 2 || date.parts.size() > 7) return "";
  const auto part = [&](std::size_t i) { return i < date.parts.size() ? date.parts[i] : "00"; };
  const std::string mark(1, std::string_view("-/. ").find(date.marks[0]) != std::string::npos ? date.marks[0] : '-');
  if (date.parts.size() == 2) {
    const bool is_year_first = part(0).size() == 4;
    const std::string_view year = is_year_first ? part(0) : part(1), month = is_year_first ? part(1) : part(0);
    const bool is_month =
        (mark == "-" || mark == "/") && date.rest.empty() && (year.starts_with("19") || year.starts_with("20"));
    return is_month ? known_form(fmt::format("{}-{:0>2}-01", year, month)) : "";
  }
  std::string form = fmt::format("{}{mark}{}{mark}{}", part(0), part(1), part(2), fmt::arg("mark", mark));
  if (part(0).size() != 4 && part(2).size() != 4) return "";
  if (date.parts.size() > 3) form += (date.marks[2] == 'T' ? "T" : " ") + fmt::format("{}:{}", part(3), part(4));
  if (date.parts.size() > 5) form += fmt::format(":{}", part(5));
  if (date.parts.size() > 6) form += fmt::format(".{}", part(6));
  return known_form(form + std::string(date.rest));
}

std::string date_like_clock(std::string_view text) {
  const bool is_year = text.starts_with("19") || text.starts_with("20");
  return is_year && has_form(text, "0000:00:00") ? date_in_known_form(text) : "";
}

std::optional<Rational> read_date(std::string_view text, DateOrder order) {
  const std::optional<DateParts> parts = parts_of(text);
  if (!parts) return std::nullopt;
  const bool has_name = !parts->month_name.empty(), is_short = parts->has_short_year();
  const bool is_year_first = is_short ? order == DateOrder::ymd : parts->is_year_first();
  if (!has_name && is_year_first != (order == DateOrder::ymd)) return std::nullopt;
  auto [year, month, day] = parts->numbers;
  if (!is_year_first) std::swap(year, day);  // d.m.y to y.m.d
  if (!has_name && order == DateOrder::mdy) std::swap(month, day);
  constexpr std::size_t short_size = 2;
  if (is_short && year.size() != short_size) return std::nullopt;
  const std::int64_t last = number_of(year), full = !is_short ? last : last < 69 ? 2000 + last : 1900 + last;
  const auto number_of_month = has_name ? month_of(parts->month_name) : static_cast<unsigned>(number_of(month));
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(full)), std::chrono::month(number_of_month),
                                         std::chrono::day(static_cast<unsigned>(number_of(day)))};
  const auto clock =
      parts->clock.empty() ? Rational(0) : read_clock(fmt::format("{}{}", parts->clock, parts->half_of_day));
  const auto offset = offset_of(parts->zone);
  if (!date.ok() || !clock || *clock >= seconds_of_day || !offset) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return Rational(days * seconds_of_day - *offset) + *clock;
}

std::optional<DateSeconds> read_usual_date(std::string_view text, DateOrder order, bool has_zone) {
  constexpr std::size_t size_of_date = 10, size = 19;  // YYYY-MM-DD hh:mm:ss
  if (has_zone && !text.ends_with('Z')) return std::nullopt;
  if (has_zone) text.remove_suffix(1);
  if (text.size() < size || (text[size_of_date] != 'T' && text[size_of_date] != ' ')) return std::nullopt;
  bool are_digits = true;
  const auto number = [&](std::size_t at, std::size_t digits) {
    int value = 0;
    for (std::size_t i = at; i < at + digits; ++i) {
      are_digits = are_digits && is_digit(text[i]);
      value = value * 10 + (text[i] - '0');
    }
    return value;
  };
  const bool is_year_first = order == DateOrder::ymd;
  const char mark = text[is_year_first ? 4 : 2];
  const bool are_marked = (mark == '-' || mark == '/' || mark == '.') && text[is_year_first ? 7 : 5] == mark &&
                          text[13] == ':' && text[16] == ':';
  if (!are_marked) return std::nullopt;
  const int year = is_year_first ? number(0, 4) : number(6, 4);
  const int first = is_year_first ? number(5, 2) : number(0, 2), second = is_year_first ? number(8, 2) : number(3, 2);
  const int month = order == DateOrder::dmy ? second : first, day = order == DateOrder::dmy ? first : second;
  const int hours = number(11, 2), minutes = number(14, 2), seconds = number(17, 2);
  std::string_view fraction = text.substr(size);
  if (!fraction.empty() && (fraction.size() == 1 || !is_mark(fraction[0]))) return std::nullopt;
  if (!fraction.empty()) fraction.remove_prefix(1);
  if (!are_digits || !std::ranges::all_of(fraction, is_digit)) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok() || hours > 23 || minutes > 59 || seconds > 59) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  const std::int64_t time = (std::int64_t{hours} * 60 + minutes) * 60 + seconds;
  return DateSeconds{days * seconds_of_day + time, fraction};
}

std::int64_t zone_offset(const DateFormat& format) { return offset_of(format.zone).value_or(0); }

TimeWords::TimeWords(TimeNotation notation, Rational rate, std::optional<int> decimals, DateFormat dates, TimeUnit unit)
    : notation_(notation),
      rate_(std::move(rate)),
      decimals_(decimals),
      dates_(std::move(dates)),
      unit_(row_of(unit)),
      offset_(zone_offset(dates_)) {}

bool TimeWords::append(std::string& out, const Time& time) {
  if (notation_ == TimeNotation::smpte || notation_ == TimeNotation::drop_frame) {
    const Rational seconds = exact_time(time) * unit_.seconds / unit_.units;
    const auto text = timecode_text(seconds, notation_ == TimeNotation::drop_frame, rate_);
    if (text) out += *text;
    return text.has_value();
  }
  std::optional<LongDecimal> seconds = exact_decimal_of(time);
  if (!seconds) return false;
  seconds->digits *= static_cast<std::uint64_t>(unit_.seconds);
  for (std::int64_t units = unit_.units; units > 1; units /= 10) --seconds->exponent;
  if (is_date(notation_)) {
    const auto utc = split_seconds(*seconds, decimals_);
    return utc && append_date(out, *utc);
  }
  const bool is_negative = std::exchange(seconds->negative, false);
  const auto size = split_seconds(*seconds, decimals_);
  if (!size) return false;
  if (is_negative && !is_zero(*size)) out += '-';
  append_clock(out, *size);
  return true;
}

/// Sets the text of a day; false beyond the years.
bool TimeWords::set_day(std::int64_t day) {
  constexpr std::int64_t most = 10'000'000;
  if (day < -most || day > most) return false;
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(static_cast<int>(day)))};
  const int year = static_cast<int>(date.year());
  if (year < 0 || year > 9999) return false;
  const auto in_digits = [&](unsigned number) { return fmt::format("{:0{}}", number, dates_.is_padded ? 2 : 1); };
  std::array numbers{fmt::format("{:04}", year), in_digits(static_cast<unsigned>(date.month())),
                     in_digits(static_cast<unsigned>(date.day()))};
  if (!dates_.month_name.empty()) numbers[1] = month_like(dates_.month_name, static_cast<unsigned>(date.month()));
  if (dates_.order == DateOrder::mdy) std::swap(numbers[1], numbers[2]);
  if (dates_.order != DateOrder::ymd) std::swap(numbers[0], numbers[2]);
  const std::string mark(dates_.mark == 0 ? 0 : 1, dates_.mark);
  day_text_ = fmt::format("{}", fmt::join(numbers, mark));
  day_ = day;
  return true;
}

bool TimeWords::append_date(std::string& out, const SplitSeconds& utc) {
  const std::int64_t local = utc.whole + offset_;
  const std::int64_t day = local / seconds_of_day - (local % seconds_of_day < 0 ? 1 : 0);
  if (day_ != day && !set_day(day)) return false;
  out += day_text_;
  SplitSeconds clock{local - day * seconds_of_day, utc.fraction};
  if (dates_.before_clock == 0 && is_zero(clock)) return true;
  out += dates_.before_clock == 0 ? ' ' : dates_.before_clock;
  constexpr std::int64_t half_a_day = seconds_of_day / 2;
  const bool is_late = clock.whole >= half_a_day;
  if (!dates_.half_of_day.empty()) {
    clock.whole %= half_a_day;
    if (clock.whole < 3600) clock.whole += half_a_day;
  }
  const std::size_t begin = out.size();
  append_clock(out, clock);
  if (!dates_.is_padded && out[begin] == '0') out.erase(begin, 1);
  for (const char c : dates_.half_of_day) {
    const char half = is_late ? 'p' : 'a';
    out += lower(c) == 'a' || lower(c) == 'p' ? static_cast<char>(c - lower(c) + half) : c;
  }
  out += dates_.zone;
  return true;
}

}  // namespace tcb
