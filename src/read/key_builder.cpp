// Key builder: cells become keys, for delimited text and for JSON alike.
#include "read/key_builder.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "option_names.hpp"

namespace tcb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The index of a column's number among the decimals of a key. Requires: the column holds numbers.
std::size_t number_of_key(const Columns::Column& column, std::size_t channels) {
  const auto of_channel = [&](NumberOfKey::Kind kind) {
    return NumberOfKey::of_channel(kind, column.channel, channels);
  };
  switch (column.role) {
    case Role::time:
    case Role::nanoseconds: return NumberOfKey::time;
    case Role::tension: return NumberOfKey::tension;
    case Role::continuity: return NumberOfKey::continuity;
    case Role::bias: return NumberOfKey::bias;
    case Role::ease_in: return NumberOfKey::ease_in;
    case Role::ease_out: return NumberOfKey::ease_out;
    case Role::channel_tension: return of_channel(NumberOfKey::tension_of);
    case Role::channel_continuity: return of_channel(NumberOfKey::continuity_of);
    case Role::channel_bias: return of_channel(NumberOfKey::bias_of);
    case Role::velocity:
    case Role::velocity_in: return of_channel(NumberOfKey::velocity_in_of);
    case Role::velocity_out: return of_channel(NumberOfKey::velocity_out_of);
    case Role::end_position: return of_channel(NumberOfKey::end_position_of);
    case Role::end_velocity: return of_channel(NumberOfKey::end_velocity_of);
    case Role::duration: return NumberOfKey::duration;
    default: return of_channel(NumberOfKey::position_of);
  }
}

bool has_any(const Columns& columns, std::initializer_list<Role> roles) {
  return std::ranges::any_of(roles, [&](Role role) { return columns.has(role); });
}

bool is_tcb(Role role) {
  constexpr std::array all{Role::tension,         Role::continuity,         Role::bias,
                           Role::channel_tension, Role::channel_continuity, Role::channel_bias};
  return std::ranges::count(all, role) > 0;
}

bool has_channel_tcbs(const Columns& columns) {
  return has_any(columns, {Role::channel_tension, Role::channel_continuity, Role::channel_bias});
}

bool has_channel_roles(const Columns& columns) {
  return std::ranges::any_of(columns.cells, [](const auto& column) { return is_of_channel(column.role); });
}

/// The channels in which a column has a role.
std::vector<std::size_t> channels_with(const Columns& columns, Role role) {
  std::vector<std::size_t> channels;
  for (const Columns::Column& column : columns.cells) {
    if (column.role == role) channels.push_back(column.channel);
  }
  return channels;
}

/// The number of the kinds of numbers of a channel that keys have.
std::size_t kinds(const Columns& columns) { return has_channel_roles(columns) ? std::size_t{NumberOfKey::kinds} : 1; }

}  // namespace

Error time_parts_not_whole(std::string_view time) {
  return data_error(
      "{}: the two columns of the time are not whole seconds and nanoseconds; expected whole numbers, of nanoseconds "
      "from 0 to 999999999; correct the cells, or give {} time=NAME",
      time, option::columns);
}

KeyBuilder::KeyBuilder(const Columns& columns, const KeyRules& rules, const KeyUnits& units)
    : rules_(rules),
      units_(units),
      is_timed_(columns.has(Role::time)),
      has_nanoseconds_(columns.has(Role::nanoseconds)),
      has_tcb_(has_any(columns, {Role::tension, Role::continuity, Role::bias})),
      has_ease_(has_any(columns, {Role::ease_in, Role::ease_out})),
      has_channel_roles_(has_channel_roles(columns)),
      both_sides_(channels_with(columns, Role::velocity)),
      channel_tcbs_(has_channel_tcbs(columns) ? columns.channels.size() : 0),
      marks_(columns.marks.size()),
      texts_(columns.texts()),
      decimals_(rules.keeps_decimals ? NumberOfKey::position + columns.channels.size() * kinds(columns) : 0) {
  block_.keys.channels = columns.channels.size();
  block_.keys.common_tcb = rules.tcb.value_or(spline::Tcb<double>{});
  for (const Role role : {Role::velocity, Role::velocity_in}) {
    for (const std::size_t channel : channels_with(columns, role)) {
      block_.keys.given.resize(columns.channels.size());
      block_.keys.given[channel] = true;
    }
  }
  if (columns.are_segments) block_.keys.given.assign(columns.channels.size(), true);
  if (columns.are_segments) ends_.resize(columns.channels.size());
  velocities_.resize(block_.keys.given.size());
}

void KeyBuilder::begin_key() {
  position_ = block_.size() * block_.keys.channels;
  block_.keys.positions.resize(position_);
  block_.keys.positions.resize(position_ + block_.keys.channels, nan);
  time_ = Time(nan);
  nanoseconds_ = nan;
  tcb_ = block_.keys.common_tcb;
  ease_ = {};
  if (has_channel_roles_) {
    std::ranges::fill(channel_tcbs_, spline::Tcb<double>{nan, nan, nan});
    std::ranges::fill(velocities_, spline::Velocity<double>{nan, nan});
  }
  std::ranges::fill(marks_, 0);
  for (std::string& text : texts_) text.clear();
  for (std::string& decimal : decimals_) decimal.clear();
  is_missing_ = false;
  faults_ = block_.faults.errors.size();
}

void KeyBuilder::keep_decimal(const Columns::Column& column, std::string decimal) {
  decimals_[number_of_key(column, block_.keys.channels)] = std::move(decimal);
}

bool KeyBuilder::take_decimal(const Columns::Column& column, std::string_view decimal) {
  if (keeps_decimals()) keep_decimal(column, std::string(decimal));
  const bool is_ease = column.role == Role::ease_in || column.role == Role::ease_out;
  const bool is_from_0_to_50 = (is_tcb(column.role) || is_ease) && rules_.tcb_scale == TcbScale::max3ds;
  const std::size_t index = number_of_key(column, block_.keys.channels);
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
  if (keeps_decimals()) keep_decimal(column, ratio_text(scaled));
  return true;
}

bool KeyBuilder::set_time_in_words(const Columns::Column& column, std::string_view text) {
  if (is_date(units_.notation) && !keeps_decimals()) {
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
  const auto seconds = read_time(text, units_.notation, units_.frame_rate.value_or(1), units_.dates.order);
  if (!seconds) return false;
  constexpr int as_many_as_it_has = 1;
  time_ = counts_frames(units_.notation) ? nearest_time(*seconds) : nearest_time(*seconds, as_many_as_it_has);
  if (keeps_decimals()) keep_decimal(column, ratio_text(*seconds));
  return true;
}

bool KeyBuilder::add_nanoseconds() {
  if (std::isnan(time_.hi) || std::isnan(nanoseconds_)) return true;  // one is missing
  constexpr std::int64_t nanoseconds_of_second = 1'000'000'000;
  const bool is_part =
      nanoseconds_ >= 0 && nanoseconds_ < nanoseconds_of_second && std::trunc(nanoseconds_) == nanoseconds_;
  const Rational seconds = exact_time(time_);
  if (!is_part || floor(seconds) != seconds) return false;
  const Rational time = seconds + Rational(static_cast<std::int64_t>(nanoseconds_)) / nanoseconds_of_second;
  constexpr int decimals = 9;
  time_ = nearest_time(time, decimals);
  if (keeps_decimals()) decimals_[NumberOfKey::time] = ratio_text(time);
  return true;
}

bool KeyBuilder::miss(const Columns::Column& column) {
  if (column.role == Role::ignored || column.role == Role::carry) return true;
  if (!ends_.empty()) return false;           // segments are whole
  if (is_velocity(column.role)) return true;  // whether it is needed depends on the keys around
  const bool is_time = column.role == Role::time || column.role == Role::nanoseconds;
  const bool skips_cell = rules_.missing == Missing::skip_cell;
  if (rules_.missing == Missing::error || (skips_cell && is_time)) return false;
  if (column.role == Role::group && rules_.missing != Missing::skip_row) return false;
  is_missing_ = is_missing_ || !skips_cell;
  return true;
}

bool KeyBuilder::end_key() {
  if (!ends_.empty() && !std::isfinite((time_ + Time(duration_)).hi)) {
    add_fault(segment_without_duration(duration_));
  }
  const bool is_faulty = block_.faults.errors.size() > faults_;
  const bool is_gap = is_missing_ && rules_.missing == Missing::break_curve;
  if (is_faulty || (is_missing_ && !is_gap)) {
    if (!is_faulty) ++block_.faults.skipped;
    return false;
  }
  if (is_gap) block_.breaks.gaps.push_back(block_.size());
  if (has_channel_roles_) {
    complete_channels();
    complete_velocities();
  }
  add_key();
  if (std::exchange(breaks_, false)) block_.breaks.before.push_back(block_.size());
  if (!ends_.empty()) add_segment_end();
  return true;
}

void KeyBuilder::add_key() {
  if (is_timed_) block_.keys.times.push_back(time_);
  if (channel_tcbs_.empty() && has_tcb_) block_.keys.tcbs.push_back(tcb_);
  if (has_ease_) block_.keys.eases.push_back(ease_);
  if (has_channel_roles_) {
    block_.keys.tcbs.insert(block_.keys.tcbs.end(), channel_tcbs_.begin(), channel_tcbs_.end());
    block_.keys.velocities.insert(block_.keys.velocities.end(), velocities_.begin(), velocities_.end());
  }
  block_.marks.insert(block_.marks.end(), marks_.begin(), marks_.end());
  for (const std::string& text : texts_) block_.texts.add(text);
  for (const std::string& decimal : decimals_) block_.decimals.add(decimal);
}

/// Adds the key at the end of a segment. The time is a double where that at the start is one.
void KeyBuilder::add_segment_end() {
  const bool is_double = time_.lo == 0;
  time_ = time_ + Time(duration_);
  if (is_double) time_ = Time(time_.hi);
  const std::size_t channels = ends_.size();
  const auto move_decimal = [&](NumberOfKey::Kind from, NumberOfKey::Kind to, std::size_t channel) {
    if (!keeps_decimals()) return;
    decimals_[NumberOfKey::of_channel(to, channel, channels)] =
        decimals_[NumberOfKey::of_channel(from, channel, channels)];
  };
  if (keeps_decimals()) decimals_[NumberOfKey::time].clear();
  for (std::size_t i = 0; i < channels; ++i) {
    block_.keys.positions.push_back(ends_[i].position);
    velocities_[i] = {ends_[i].velocity, nan};
    move_decimal(NumberOfKey::end_position_of, NumberOfKey::position_of, i);
    move_decimal(NumberOfKey::end_velocity_of, NumberOfKey::velocity_in_of, i);
  }
  add_key();
}

/// The number of a cell with a role in one channel, or the duration of a segment.
double& KeyBuilder::number_of_channel(const Columns::Column& column) {
  switch (column.role) {
    case Role::channel_tension: return channel_tcbs_[column.channel].tension;
    case Role::channel_continuity: return channel_tcbs_[column.channel].continuity;
    case Role::channel_bias: return channel_tcbs_[column.channel].bias;
    case Role::velocity:
    case Role::velocity_in: return velocities_[column.channel].in;
    case Role::velocity_out: return velocities_[column.channel].out;
    case Role::end_position: return ends_[column.channel].position;
    case Role::end_velocity: return ends_[column.channel].velocity;
    default: return duration_;
  }
}

/// Gives channels the common tension, continuity and bias where they have none of their own.
void KeyBuilder::complete_channels() {
  struct Value {
    double spline::Tcb<double>::*member;
    std::size_t common;
    NumberOfKey::Kind own;
  };
  constexpr std::array values{
      Value{&spline::Tcb<double>::tension, NumberOfKey::tension, NumberOfKey::tension_of},
      Value{&spline::Tcb<double>::continuity, NumberOfKey::continuity, NumberOfKey::continuity_of},
      Value{&spline::Tcb<double>::bias, NumberOfKey::bias, NumberOfKey::bias_of}};
  for (std::size_t i = 0; i < channel_tcbs_.size(); ++i) {
    for (const auto& [member, common, own] : values) {
      if (!std::isnan(channel_tcbs_[i].*member)) continue;
      channel_tcbs_[i].*member = tcb_.*member;
      if (keeps_decimals()) decimals_[NumberOfKey::of_channel(own, i, channel_tcbs_.size())] = decimals_[common];
    }
  }
}

/// A velocity for both sides is also that after the key.
void KeyBuilder::complete_velocities() {
  for (const std::size_t channel : both_sides_) {
    velocities_[channel].out = velocities_[channel].in;
    if (!keeps_decimals()) continue;
    const auto index = [&](NumberOfKey::Kind kind) {
      return NumberOfKey::of_channel(kind, channel, velocities_.size());
    };
    decimals_[index(NumberOfKey::velocity_out_of)] = decimals_[index(NumberOfKey::velocity_in_of)];
  }
}

KeyBlock KeyBuilder::finish(std::string path) {
  block_.keys.positions.resize(block_.size() * block_.keys.channels);  // drops a key that was not ended
  block_.text_positions.path = std::move(path);
  block_.breaks.at_end = breaks_;
  return std::move(block_);
}

}  // namespace tcb
