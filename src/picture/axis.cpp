// Axis: a range of numbers relative to a round base, with round numbers as its ticks.
#include "picture/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "numbers/dates.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

constexpr std::int64_t seconds_of_day = 86'400;

/// 10^exponent, to a few units in the last place.
double ten_to_the(int exponent) {
  double power = 1;
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
  return exponent < 0 ? 1 / power : power;
}

/// The exponent of the smallest power of ten that is not less than a number above 0, up to rounding.
int exponent_above(double size) {
  int exponent = 0;
  for (double rest = size; rest > 1; rest /= 10) ++exponent;
  for (double rest = size * 10; rest <= 1; rest *= 10) --exponent;
  return exponent;
}

/// The power of ten that is the unit of an axis, so that scales and steps are far from the ends of the range of
/// doubles.
int exponent_of_units(double largest) {
  constexpr int far = 150;
  return largest > 1e150 ? far : largest > 0 && largest < 1e-150 ? -far : 0;
}

/// The base of an axis in a title.
std::string base_text_of(const Rational& whole, int exponent) {
  constexpr int many = 25;  // zeros, which nobody counts
  const std::string text = whole_text(whole);
  if (whole == 0 || std::abs(exponent) <= many) return decimal_text(text, exponent);
  const std::string digits = text.substr(0, text.find_last_not_of('0') + 1);
  return fmt::format("{}e{}", digits, exponent + static_cast<int>(text.size() - digits.size()));
}

/// A whole multiple of a power of ten: with k, M or G for thousands, millions or billions, or in the exponent notation,
/// as in 2.5e12.
std::string short_text(std::int64_t multiple, int exponent) {
  if (multiple == 0) return "0";
  std::string digits = std::to_string(std::abs(multiple));
  constexpr std::array<std::pair<int, char>, 3> suffixes{{{9, 'G'}, {6, 'M'}, {3, 'k'}}};
  const int power = exponent + static_cast<int>(digits.size()) - 1;
  for (const auto& [thousands, suffix] : suffixes) {
    if (power >= thousands && power < 12)
      return decimal_text(std::to_string(multiple), exponent - thousands, true) + suffix;
  }
  exponent += static_cast<int>(digits.size()) - 1;
  digits.resize(digits.find_last_not_of('0') + 1);
  if (digits.size() > 1) digits.insert(1, ".");
  return fmt::format("{}{}e{}", multiple < 0 ? "-" : "", digits, exponent);
}

/// Seconds since an epoch as a decimal.
std::string seconds_text(const Rational& seconds) {
  constexpr int decimals = 9;
  return decimal_text(whole_text(floor(seconds * *parse_rational("1e9"))), -decimals, true);
}

/// Of the multiples first to last of a step, every how many have a tick: those that are multiples of this number too.
/// At most `most` are, and at least two, if that is possible with one grid; otherwise the first and the last one.
std::int64_t stride_of(std::int64_t first, std::int64_t last, double most) {
  if (static_cast<double>(last - first) < most) return 1;
  for (std::int64_t stride = 2; stride < last - first; ++stride) {
    const auto begin = static_cast<std::int64_t>(std::ceil(static_cast<double>(first) / static_cast<double>(stride)));
    const auto end = static_cast<std::int64_t>(std::floor(static_cast<double>(last) / static_cast<double>(stride)));
    if (end > begin && static_cast<double>(end - begin + 1) <= most) return stride;
  }
  return last - first;
}

std::int64_t first_multiple(std::int64_t first, std::int64_t last, std::int64_t stride) {
  if (stride == 1 || stride == last - first) return first;
  return static_cast<std::int64_t>(std::ceil(static_cast<double>(first) / static_cast<double>(stride))) * stride;
}

/// The steps of times in words, in seconds; below a second, a tenth of 1, 2 or 5 seconds, a hundredth, and so on.
constexpr std::array<std::int64_t, 28> steps_in_seconds{
    1,      2,       5,       10,      15,       30,       60,       120,      300,    600,
    900,    1800,    3600,    7200,    10800,    21600,    43200,    86400,    172800, 432000,
    864000, 1728000, 4320000, 8640000, 17280000, 43200000, 86400000, 864000000};

/// Steps of times in words, from short to long.
std::vector<Rational> steps_of(const TimeScale& scale) {
  std::vector<Rational> steps;
  Rational second = 1;
  if (scale.notation == TimeNotation::smpte || scale.notation == TimeNotation::drop_frame) {
    const Rational& rate = scale.frames_per_second;
    second = -floor(-rate) / rate;  // of timecode
    for (const int frames : {1, 2, 5, 10}) {
      if (Rational(frames) / rate < second) steps.push_back(Rational(frames) / rate);
    }
  } else {
    for (int exponent = -9; exponent < 0; ++exponent) {
      for (const int factor : {1, 2, 5}) steps.push_back(*parse_rational(fmt::format("{}e{}", factor, exponent)));
    }
  }
  for (const std::int64_t seconds : steps_in_seconds) steps.push_back(second * seconds);
  return steps;
}

}  // namespace

std::string decimal_text(const std::string& whole, int exponent, bool is_short) {
  const bool negative = whole.front() == '-';
  std::string digits = negative ? whole.substr(1) : whole;
  if (digits == "0") return digits;
  while (is_short && digits.back() == '0') {
    digits.pop_back();
    ++exponent;
  }
  if (exponent >= 0) return (negative ? "-" : "") + digits + std::string(static_cast<std::size_t>(exponent), '0');
  const auto decimals = static_cast<std::size_t>(-exponent);
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  digits.insert(digits.size() - decimals, ".");
  return (negative ? "-" : "") + digits;
}

double size_of(const Interval& interval) { return std::max(std::abs(interval.low.hi), std::abs(interval.high.hi)); }

Axis::Axis(const Interval& interval, double margin, double besides) {
  const double size = interval.length();
  const double largest = size_of(interval);
  exponent_ = exponent_of_units(std::max(largest, besides));
  units_ = ten_to_the(exponent_);
  constexpr double many_digits = 1e4;  // the ratio of number to length from which digits that do not change are omitted
  if (size > 0 && largest >= many_digits * size) {
    const int exponent = exponent_above(size);
    const Rational unit = *parse_rational(fmt::format("1e{}", exponent));
    Rational whole = floor(exact_time(interval.low) / unit);
    const bool is_double = std::isfinite(nearest_double(whole * unit));
    if (!is_double) whole += 1;
    base_ = nearest_time(whole * unit);
    base_text_ = base_text_of(whole, exponent);
  }
  low_ = from_base(interval.low);
  high_ = from_base(interval.high);
  // A single number is in the middle of an axis.
  constexpr double least = 1e-200;  // shorter ones are next to numbers that are much larger
  const bool is_single = in_units(size) < least;
  const double half = !is_single ? margin * in_units(size) : largest > 0 ? std::max(in_units(largest) / 2, least) : 1;
  low_ -= half;
  high_ += half;
}

Axis::Axis(const Interval& times, TimeScale scale) : Axis(times, 0) {
  const bool is_in_words = scale.notation != TimeNotation::seconds && scale.notation != TimeNotation::frames;
  if (is_in_words) {
    base_ = Time(std::floor(times.low.hi));
    base_text_.clear();
    exponent_ = 0;
    units_ = 1;
  } else if (scale.units_per_second) {
    units_ *= nearest_double(*scale.units_per_second);
    if (!base_text_.empty()) {
      base_ = times.low;
      base_text_ = seconds_text(exact_time(base_) / *scale.units_per_second);
    }
  } else {
    return;
  }
  low_ = from_base(times.low);
  high_ = from_base(times.high);
  if (low_ == high_) {
    const double half = std::max(1.0, std::abs(low_) / 2);
    low_ -= half;
    high_ += half;
  }
  scale_ = std::move(scale);
  if (!is_date(scale_->notation)) return;
  const auto day_of = [this](const Time& time) { return words(exact_time(time), seconds_of_day); };
  if (day_of(times.low) == day_of(times.high)) day_ = day_of(times.low);
}

void Axis::set_length(double length) {
  const double middle = low_ + (high_ - low_) / 2;
  low_ = middle - length / 2;
  high_ = middle + length / 2;
}

std::string Axis::title(std::string_view name) const {
  if (!day_.empty()) return fmt::format("{}, {}", name, day_);
  if (scale_ && scale_->units_per_second) {
    return base_text_.empty() ? fmt::format("{}, seconds", name)
                              : fmt::format("{}, seconds after {}", name, base_text_);
  }
  if (base_text_.empty() || base_text_ == "0") return std::string(name);
  const bool negative = base_text_.front() == '-';
  return fmt::format("{} {} {}", name, negative ? "+" : "−", base_text_.substr(negative ? 1 : 0));
}

/// A time in words without what all ticks at multiples of the step have in common.
std::string Axis::words(const Rational& time, const Rational& step) const {
  TimeWords notation(scale_->notation, scale_->frames_per_second, {}, scale_->dates);
  std::string text = notation.text(nearest_time(time)).value_or("");
  if (!is_date(scale_->notation)) return text;
  const std::size_t date = std::min(text.find_first_of("T "), text.size());
  if (step >= seconds_of_day || date == text.size()) return text.substr(0, date);
  std::string clock = text.substr(date + 1);
  clock.resize(std::min(clock.find_first_not_of("0123456789:."), clock.size()));
  if (step >= 60 && clock.ends_with(":00")) clock.resize(clock.size() - 3);
  return day_.empty() ? text.substr(0, date) + " " + clock : clock;
}

Tick Axis::tick_in_words(double at, const Rational& step) const {
  return {at, words(exact_time(base_) + Rational(at), step)};
}

/// Ticks at the firsts of months between two times of the zone.
std::vector<Tick> Axis::ticks_at_months(const Rational& low, const Rational& high, double most) const {
  using std::chrono::days, std::chrono::months, std::chrono::sys_days, std::chrono::year_month_day;
  const auto day_of = [](const Rational& time) {
    const Rational day = floor(time / seconds_of_day);
    const auto count = static_cast<int>(whole_number(abs(day)));
    return year_month_day(sys_days(days(day < Rational(0) ? -count : count)));
  };
  const auto month_of = [](const year_month_day& day) {
    return static_cast<int>(day.year()) * 12 + static_cast<int>(static_cast<unsigned>(day.month())) - 1;
  };
  const auto start_of = [](int month) {
    const std::chrono::year_month first = std::chrono::year(0) / std::chrono::January + months(month);
    return Rational(static_cast<std::int64_t>(sys_days(first / 1).time_since_epoch().count())) * seconds_of_day;
  };
  const Rational offset = zone_offset(scale_->dates), base = exact_time(base_) + offset;
  for (const int step : {1, 2, 3, 6, 12, 24, 60, 120, 240, 600, 1200}) {
    std::vector<Tick> ticks;
    for (int month = month_of(day_of(low)) / step * step; start_of(month) <= high; month += step) {
      const Rational time = start_of(month);
      if (time >= low) ticks.push_back({nearest_double(time - base), words(time - offset, seconds_of_day)});
    }
    if (static_cast<double>(ticks.size()) <= most && ticks.size() >= 2) return ticks;
    if (ticks.size() < 2) break;
  }
  return {tick_in_words(low_, seconds_of_day), tick_in_words(high_, seconds_of_day)};
}

std::vector<Tick> Axis::ticks_in_words(double most) const {
  const Rational offset = is_date(scale_->notation) ? zone_offset(scale_->dates) : Rational(0);
  const Rational base = exact_time(base_) + offset;
  const Rational low = base + Rational(low_), high = base + Rational(high_);
  const std::vector<Rational> steps = steps_of(*scale_);
  const auto multiples = [&](const Rational& step) {
    return std::pair(-floor(-low / step), floor(high / step));  // of the first and the last tick
  };
  const auto fits = [&](const Rational& step) {
    const auto [first, last] = multiples(step);
    return last - first + 1 <= Rational(most);
  };
  auto step = std::ranges::find_if(steps, fits);
  if (step == steps.end()) --step;
  while (step != steps.begin() && (multiples(*step).second - multiples(*step).first) * *step < (high - low) / 2) --step;
  if (is_date(scale_->notation) && *step >= Rational(20 * seconds_of_day)) return ticks_at_months(low, high, most);
  const auto [first, last] = multiples(*step);
  const Rational count = last - first, stride = count < Rational(most) ? Rational(1) : count;
  std::vector<Tick> ticks;
  for (Rational i = first; i <= last; i += stride) {
    const Rational time = i * *step;
    ticks.push_back({nearest_double(time - base), words(time - offset, *step)});
  }
  if (ticks.size() >= 2) return ticks;
  return {tick_in_words(low_, *step), tick_in_words(high_, *step)};  // shorter than all steps
}

std::vector<Tick> Axis::ticks(double most) const {
  if (scale_ && !scale_->units_per_second) return ticks_in_words(most);
  int exponent = exponent_above(length() / most) - 1;
  int factor = 1;
  const auto step = [&] { return factor * ten_to_the(exponent); };
  constexpr double slack = 1e-9;  // an end of the axis may be a tick
  const auto first = [&] { return static_cast<std::int64_t>(std::ceil(low_ / step() - slack)); };
  const auto last = [&] { return static_cast<std::int64_t>(std::floor(high_ / step() + slack)); };
  while (static_cast<double>(last() - first() + 1) > most) {
    factor = factor == 1 ? 2 : factor == 2 ? 5 : 1;
    if (factor == 1) ++exponent;
  }
  while (static_cast<double>(last() - first()) * step() < length() / 2) {  // two ticks far apart show the scale
    factor = factor == 5 ? 2 : factor == 2 ? 1 : 5;
    if (factor == 5) --exponent;
  }
  const std::int64_t stride = stride_of(first(), last(), most);
  const double largest = static_cast<double>(std::max(std::abs(first()), std::abs(last()))) * step();
  const bool plain = largest < 1e6 && largest > 1e-4 && exponent >= -8 && exponent_ == 0;
  std::vector<Tick> ticks;
  for (std::int64_t i = first_multiple(first(), last(), stride); i <= last(); i += stride) {
    const std::int64_t multiple = i * factor;
    const double value = exponent < 0 ? static_cast<double>(multiple) / ten_to_the(-exponent)
                                      : static_cast<double>(multiple) * ten_to_the(exponent);
    ticks.push_back(
        {value, plain ? decimal_text(std::to_string(multiple), exponent) : short_text(multiple, exponent + exponent_)});
  }
  return ticks;
}

}  // namespace tcb
