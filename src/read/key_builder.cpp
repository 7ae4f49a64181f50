// Key builder: cells become keys, for delimited text and for JSON alike.
#include "read/key_builder.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "numbers/dates.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The kind of the number of a role in one channel, and the number of another one.
constexpr std::array kinds_of_roles{std::pair{Role::position, NumberOfKey::position_of},
                                    std::pair{Role::channel_tension, NumberOfKey::tension_of},
                                    std::pair{Role::channel_continuity, NumberOfKey::continuity_of},
                                    std::pair{Role::channel_bias, NumberOfKey::bias_of},
                                    std::pair{Role::velocity, NumberOfKey::velocity_in_of},
                                    std::pair{Role::velocity_in, NumberOfKey::velocity_in_of},
                                    std::pair{Role::velocity_out, NumberOfKey::velocity_out_of}};
constexpr std::array numbers_of_roles{
    std::pair{Role::time, NumberOfKey::time},        std::pair{Role::nanoseconds, NumberOfKey::time},
    std::pair{Role::tension, NumberOfKey::tension},  std::pair{Role::continuity, NumberOfKey::continuity},
    std::pair{Role::bias, NumberOfKey::bias},        std::pair{Role::ease_in, NumberOfKey::ease_in},
    std::pair{Role::ease_out, NumberOfKey::ease_out}};

bool has_any(const Columns& columns, std::initializer_list<Role> roles) {
  return std::ranges::any_of(roles, [&](Role role) { return columns.has(role); });
}

bool is_tcb(Role role) {
  constexpr std::array all{Role::tension,         Role::continuity,         Role::bias,
                           Role::channel_tension, Role::channel_continuity, Role::channel_bias};
  return std::ranges::count(all, role) > 0;
}

bool has_channel_roles(const Columns& columns) {
  return std::ranges::any_of(columns.cells, [](const auto& column) { return is_of_channel(column.role); });
}

std::vector<std::size_t> channels_with(const Columns& columns, Role role) {
  std::vector<std::size_t> channels;
  for (const Columns::Column& column : columns.cells) {
    if (column.role == role) channels.push_back(column.channel);
  }
  return channels;
}

}  // namespace

Error time_parts_not_whole(std::string_view time) {
  return data_error(
      "{}: the two columns of the time are not whole seconds and nanoseconds; expected whole numbers, of nanoseconds "
      "from 0 to 999999999; correct the cells, or give --columns time=NAME",
      time);
}

Error number_in_empty_column(std::string_view number, const Columns& columns, std::size_t cell) {
  const std::string& name = columns.ignored[columns.cells[cell].channel];
  const std::string column = requested_as(name, cell);
  constexpr std::size_t most_shown = 8;
  std::string positions;
  for (std::size_t other = 0; columns.channels.size() <= most_shown && other < columns.cells.size(); ++other) {
    const Columns::Column& one = columns.cells[other];
    if (one.role == Role::position) positions += requested_as(columns.channels[one.channel], other) + ":";
  }
  return data_error(
      "{} is a number in column {}, which begins empty and is left out; expected none; give --columns {} to leave it "
      "out all the same, or --missing skip-cell --columns {} to take its numbers",
      in_quotes(number), in_quotes(name), in_shell("ignore=" + column),
      in_shell("position=" + (positions.empty() ? "NAME:" : positions) + column));
}

KeyBuilder::KeyBuilder(const Columns& columns, const KeyRules& rules, const KeyUnits& units)
    : rules_(rules),
      units_(units),
      is_timed_(columns.has(Role::time)),
      has_nanoseconds_(columns.has(Role::nanoseconds)),
      has_tcb_(has_any(columns, {Role::tension, Role::continuity, Role::bias})),
      has_ease_(has_any(columns, {Role::ease_in, Role::ease_out})),
      has_channel_roles_(has_channel_roles(columns)),
      has_channel_tcbs_(has_any(columns, {Role::channel_tension, Role::channel_continuity, Role::channel_bias})),
      both_sides_(channels_with(columns, Role::velocity)),
      texts_(columns.texts()) {
  const std::size_t channels = columns.channels.size();
  block_.keys.channels = channels;
  block_.keys.common_tcb = rules.tcb.value_or(spline::Tcb<double>{});
  for (const auto& [role, kind] : kinds_of_roles) first_of_role_[static_cast<std::size_t>(role)] = index_of(kind, 0);
  for (const auto& [role, number] : numbers_of_roles) first_of_role_[static_cast<std::size_t>(role)] = number;
  numbers_.resize(NumberOfKey::position + channels * (has_channel_roles_ ? std::size_t{NumberOfKey::kinds} : 1));
  if (rules.keeps_decimals) decimals_.resize(numbers_.size());
  for (const Role role : {Role::velocity, Role::velocity_in}) {
    for (const std::size_t channel : channels_with(columns, role)) {
      block_.keys.given.resize(channels);
      block_.keys.given[channel] = true;
    }
  }
}

void KeyBuilder::begin_key() {
  time_ = Time(nan);
  std::ranges::fill(numbers_, nan);
  const auto& [tension, continuity, bias] = block_.keys.common_tcb;
  numbers_[NumberOfKey::tension] = tension;
  numbers_[NumberOfKey::continuity] = continuity;
  numbers_[NumberOfKey::bias] = bias;
  numbers_[NumberOfKey::ease_in] = numbers_[NumberOfKey::ease_out] = 0;
  for (std::string& text : texts_) text.clear();
  for (std::string& decimal : decimals_) decimal.clear();
  is_missing_ = false;
  faults_ = block_.faults.errors.size();
}

bool KeyBuilder::take_decimal(const Columns::Column& column, std::string_view decimal) {
  const std::size_t index = index_of(column);
  if (keeps_decimals()) decimals_[index] = decimal;
  const bool is_ease = column.role == Role::ease_in || column.role == Role::ease_out;
  const bool is_from_0_to_50 = (is_tcb(column.role) || is_ease) && rules_.tcb_scale == TcbScale::max3ds;
  const Rational factor = index < units_.factors.size() ? units_.factors[index] : Rational(1);
  if (!is_from_0_to_50 && factor == 1) return true;
  const bool is_time = column.role == Role::time;
  const Rational given = parse_rational(decimal).value_or(is_time ? exact_time(time_) : Rational(number(column)));
  const Rational scaled = !is_from_0_to_50 ? given * factor : is_ease ? given / 50 : from_0_to_50(given);
  if (!within_doubles(scaled)) return false;
  if (is_time) {
    time_ = nearest_time(scaled);
  } else {
    number(column) = nearest_double(scaled);
  }
  if (keeps_decimals()) decimals_[index] = ratio_text(scaled);
  return true;
}

bool KeyBuilder::take(const Columns::Column& column, double number, std::string_view decimal) {
  const bool is_ratio = decimal.find('/') != std::string_view::npos;
  if (column.role != Role::time) {
    this->number(column) = number;
  } else {
    time_ = is_ratio ? nearest_time(parse_rational(decimal).value_or(Rational(number)))
                     : parse_time(decimal).value_or(Time(number));
  }
  return !takes_decimals() || take_decimal(column, decimal);
}

bool KeyBuilder::set_time_in_words(std::string_view text) {
  const std::string with_seconds = units_.are_hours_and_minutes ? std::string(text) + ":00" : "";
  if (units_.are_hours_and_minutes) text = with_seconds;
  const bool has_clock = text.find(':') != std::string_view::npos;
  if (has_clock && half_of_day(text).empty() != units_.dates.half_of_day.empty()) return false;
  if (is_date(units_.notation) && units_.dates.month_name.empty() && !keeps_decimals()) {
    const bool has_zone = units_.notation == TimeNotation::zoned_date;
    const auto usual = read_usual_date(text, units_.dates.order, has_zone);
    if (usual && usual->fraction.empty()) {
      time_ = whole_time(usual->seconds);
      return true;
    }
    if (usual && usual->seconds >= 0) {
      const auto time = parse_time(fmt::format("{}.{}", usual->seconds, usual->fraction));
      if (time) time_ = *time;
      if (time) return true;
    }
  }
  if (is_date(units_.notation)) {
    const auto format = find_date_format(text);
    const DateFormat& first = units_.dates;
    if (!format || format->month_name.empty() != first.month_name.empty()) return false;
    if (format->has_short_year != first.has_short_year) return false;
  }
  const auto seconds = read_time(text, units_.notation, units_.frame_rate.value_or(1), units_.dates.order);
  if (!seconds) return false;
  constexpr int as_many_as_it_has = 1;
  time_ = counts_frames(units_.notation) ? nearest_time(*seconds) : nearest_time(*seconds, as_many_as_it_has);
  if (keeps_decimals()) decimals_[NumberOfKey::time] = ratio_text(*seconds);
  return true;
}

bool KeyBuilder::add_nanoseconds() {
  const double nanoseconds = numbers_[NumberOfKey::time];
  if (std::isnan(time_.hi) || std::isnan(nanoseconds)) return true;  // one is missing
  constexpr std::int64_t nanoseconds_of_second = 1'000'000'000;
  const bool is_part =
      nanoseconds >= 0 && nanoseconds < nanoseconds_of_second && std::trunc(nanoseconds) == nanoseconds;
  const Rational seconds = exact_time(time_);
  if (!is_part || floor(seconds) != seconds) return false;
  const Rational time = seconds + Rational(static_cast<std::int64_t>(nanoseconds)) / nanoseconds_of_second;
  constexpr int decimals = 9;
  time_ = nearest_time(time, decimals);
  if (keeps_decimals()) decimals_[NumberOfKey::time] = ratio_text(time);
  return true;
}

bool KeyBuilder::miss(const Columns::Column& column) {
  if (column.role == Role::ignored || column.role == Role::carry) return true;
  if (is_velocity(column.role)) return true;  // whether it is needed depends on the keys around
  const bool is_time = column.role == Role::time || column.role == Role::nanoseconds;
  const bool skips_cell = rules_.missing == Missing::skip_cell;
  if (rules_.missing == Missing::error || (skips_cell && is_time)) return false;
  if (column.role == Role::group && rules_.missing != Missing::skip_row) return false;
  is_missing_ = is_missing_ || !skips_cell;
  return true;
}

bool KeyBuilder::end_key() {
  const bool is_faulty = block_.faults.errors.size() > faults_;
  const bool counts = rules_.counts_rows && !is_timed_;
  const bool is_gap = is_missing_ && (rules_.missing == Missing::break_curve || counts);
  if (is_faulty || (is_missing_ && !is_gap)) {
    if (!is_faulty) ++block_.faults.skipped;
    return false;
  }
  if (is_gap) block_.breaks.gaps.push_back(block_.size());
  if (has_channel_roles_) complete_channels();
  add_key();
  if (std::exchange(breaks_, false)) block_.breaks.before.push_back(block_.size());
  return true;
}

/// Gives channels the common tension, continuity and bias where they have none of their own, and a velocity for both
/// sides to the side after the key.
void KeyBuilder::complete_channels() {
  constexpr std::array common{std::pair{NumberOfKey::tension, NumberOfKey::tension_of},
                              std::pair{NumberOfKey::continuity, NumberOfKey::continuity_of},
                              std::pair{NumberOfKey::bias, NumberOfKey::bias_of}};
  for (std::size_t channel = 0; has_channel_tcbs_ && channel < block_.keys.channels; ++channel) {
    for (const auto& [number, kind] : common) {
      const std::size_t own = index_of(kind, channel);
      if (std::isnan(numbers_[own])) copy_number(number, own);
    }
  }
  for (const std::size_t channel : both_sides_) {
    copy_number(index_of(NumberOfKey::velocity_in_of, channel), index_of(NumberOfKey::velocity_out_of, channel));
  }
}

void KeyBuilder::copy_number(std::size_t from, std::size_t to) {
  numbers_[to] = numbers_[from];
  if (keeps_decimals()) decimals_[to] = decimals_[from];
}

void KeyBuilder::add_key() {
  Keys& keys = block_.keys;
  const double* const positions = numbers_.data() + NumberOfKey::position;
  keys.positions.insert(keys.positions.end(), positions, positions + keys.channels);
  if (is_timed_) keys.times.push_back(time_);
  if (has_tcb_ && !has_channel_tcbs_) {
    keys.tcbs.push_back(
        {numbers_[NumberOfKey::tension], numbers_[NumberOfKey::continuity], numbers_[NumberOfKey::bias]});
  }
  if (has_ease_) keys.eases.push_back({numbers_[NumberOfKey::ease_in], numbers_[NumberOfKey::ease_out]});
  const auto number = [&](NumberOfKey::Kind kind, std::size_t channel) { return numbers_[index_of(kind, channel)]; };
  for (std::size_t i = 0; has_channel_tcbs_ && i < keys.channels; ++i) {
    keys.tcbs.push_back(
        {number(NumberOfKey::tension_of, i), number(NumberOfKey::continuity_of, i), number(NumberOfKey::bias_of, i)});
  }
  for (std::size_t i = 0; i < keys.given.size(); ++i) {
    keys.velocities.push_back({number(NumberOfKey::velocity_in_of, i), number(NumberOfKey::velocity_out_of, i)});
  }
  for (const std::string& text : texts_) block_.texts.add(text);
  for (const std::string& decimal : decimals_) block_.decimals.add(decimal);
}

KeyBlock KeyBuilder::finish(std::string path) {
  block_.text_positions.path = std::move(path);
  block_.breaks.at_end = breaks_;
  return std::move(block_);
}

}  // namespace tcb
