// Curves: the keys of an input, arranged and split into curves.
#include "keys/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/rules.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// Takes the faults of a block, in the order of their positions.
void gather(std::vector<Error>& faults, KeyBlock& block) {
  std::ranges::stable_sort(block.faults.errors, {}, [](const Error& fault) {
    return std::pair(fault.position().line, fault.position().column);
  });
  std::ranges::move(block.faults.errors, std::back_inserter(faults));
}

/// What faults of one kind have in common: the message without the texts and numbers of each, and without the
/// column where an option is the remedy for all.
std::string kind_of(std::string_view message) {
  std::string kind;
  const std::size_t column = message.find(": ");
  const bool has_option = message.find(" give --") != std::string_view::npos;
  if (has_option && column < message.find_first_of("\";")) message.remove_prefix(column + 2);
  bool in_quotes = false, in_word = false;
  for (const char c : message) {
    const bool is_digit = c >= '0' && c <= '9';
    if (c == '"') in_quotes = !in_quotes;
    if (!in_quotes && (!is_digit || in_word)) kind += c;
    in_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (is_digit && in_word);
  }
  return kind;
}

struct FaultKind {
  std::string kind;
  Error first;
  std::size_t count = 1;
  std::uint64_t last_line = 0;

  /// The first fault, which tells how many there are.
  Error error(bool are_all) const {
    if (count == 1) return first;
    std::string message =
        fmt::format("{} ({}{} errors of this kind", first.message(), are_all ? "" : "at least ", count);
    if (last_line > 0) message += fmt::format(", the last in line {}", last_line);
    return Error(first.exit(), message + ")").at(first.position());
  }
};

/// Throws: Error (data) with each kind of them, at most ten. Requires: there is at least one. `are_all`: no other fault
/// follows these.
[[noreturn]] void refuse(const std::vector<Error>& faults, bool are_all) {
  constexpr std::size_t most_shown = 10;
  std::vector<FaultKind> kinds;
  for (const Error& fault : faults) {
    std::string kind = kind_of(fault.message());
    const auto known = std::ranges::find(kinds, kind, &FaultKind::kind);
    if (known == kinds.end()) {
      kinds.push_back({std::move(kind), fault});
    } else {
      ++known->count;
      known->last_line = fault.position().line;
    }
  }
  Error all = kinds[0].error(are_all);
  for (std::size_t i = 1; i < std::min(kinds.size(), most_shown); ++i) all.add(kinds[i].error(are_all));
  if (kinds.size() > most_shown) all.add(data_error("further errors are not shown"));
  throw Error(all);
}

void require_times(const CurveOptions& options) {
  const auto refuse = [](bool is_given, std::string_view option, std::string_view use) {
    if (!is_given) return;
    throw data_error("{} {}, but there is no time column; remove it, or name the column with --columns time=NAME",
                     option, use);
  };
  refuse(options.sort, "--sort", "orders rows by time");
  refuse(options.max_gap.has_value(), "--max-gap", "is about times");
  refuse(options.duplicates != Duplicates::error, "--duplicates", "is about equal times");
}

/// The largest gap within a curve, in the unit of the times.
std::optional<Rational> largest_allowed_gap(const TimeSchema& time, const CurveOptions& options) {
  std::optional<Rational> gap = options.max_gap;
  if (gap && options.is_max_gap_in_seconds) {
    if (time.unit == TimeUnit::frames) {
      throw data_error(
          "the times in {} are frames, whose duration is unknown; give --max-gap as a number of frames, or --input-fps",
          in_quotes(time.name));
    }
    if (time.unit) *gap *= units_per_second(*time.unit);
  }
  return gap;
}

/// The keys in order, without faults; `midnights` is as for past_midnight().
Source<KeyBlock> arranged(Source<KeyBlock> blocks, const Schema& schema, const KeyTraits& traits,
                          const CurveOptions& options, const std::function<bool()>& arrive, std::uint64_t& midnights) {
  const bool is_ordered = schema.time.is_given && !options.any_order;
  if (is_ordered) blocks = with_time_digits(std::move(blocks));
  const bool is_grouped = traits.has_whole_curves && !options.sort;
  const bool by_text = !schema.groups.empty() && !traits.own_curves && !is_grouped;
  if (!schema.time.is_given) require_times(options);
  const bool are_labelled = !traits.label.empty() && schema.groups.empty();
  if (are_labelled && options.sort) {
    throw data_error(
        "--sort would mix rows with different values in column {} in one curve; expected the rows of one curve; {}",
        in_shell(traits.label), remedy_for_label(traits.label));
  }
  if (by_text || options.sort) {
    blocks = grouped(without_faults(std::move(blocks)),
                     {by_text ? schema.groups.size() : 0, options.sort, traits.own_curves});
  }
  blocks = without_gaps(std::move(blocks));
  if (is_ordered && !options.sort) {
    blocks = past_midnight(std::move(blocks), schema.time.notation, schema.time.frame_rate.value_or(1), midnights);
  }
  if (is_ordered && options.duplicates == Duplicates::spread) blocks = spread_out(std::move(blocks));
  if (is_ordered) {
    const bool may_group = schema.groups.empty() && !traits.own_curves;
    const std::string_view any_column = schema.named ? "NAME" : "NUMBER";
    blocks =
        in_order(std::move(blocks), options.duplicates,
                 {schema.time.is_by_place, may_group ? any_column : "", are_labelled ? traits.label : std::string()});
  }
  return without_faults(std::move(blocks), arrive);
}

}  // namespace

bool is_gap(const Time& from, const Time& to, const Rational& most) {
  const double step = (to - from).hi, near_most = nearest_double(most);
  const double doubt = 0x1p-50 * (std::abs(to.hi) + std::abs(from.hi) + near_most);
  if (std::abs(step - near_most) > doubt) return step > near_most;
  return exact_time(to) - exact_time(from) > most;
}

Source<KeyBlock> without_faults(Source<KeyBlock> blocks, const std::function<bool()>& arrive) {
  return [blocks = std::move(blocks), arrive]() -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block || block->faults.errors.empty()) return block;
    std::vector<Error> faults;
    bool are_all = true;
    for (bool more = true; more;) {
      const bool is_full = block->faults.errors.size() >= most_faults;
      gather(faults, *block);
      more = faults.size() < most_faults && !block->faults.unreadable && (!arrive || arrive());
      are_all = are_all && more && !is_full;
      try {
        if (more) block = blocks();
      } catch (const Error& error) {
        faults.push_back(error);
        more = are_all = false;
      }
      more = more && block;
    }
    if (faults.size() > most_faults) faults.erase(faults.begin() + most_faults, faults.end());
    refuse(faults, are_all);
  };
}

CurvePart counted_from(const CurvePart& part, const Rational& zero, const std::optional<FrameTimes>& frames) {
  return {part.number, less(part.origin, zero, frames),
          [next = part.next, zero, frames] {
            const std::optional<Time> time = next();
            return time ? std::optional(less(*time, zero, frames)) : std::nullopt;
          },
          part.max_gap};
}

void count_from(InputCurve& curve, const Rational& zero, const std::optional<FrameTimes>& frames) {
  curve.keys = less(std::move(curve.keys), zero, frames);
  if (curve.part) curve.part = counted_from(*curve.part, zero, frames);
}

ObservedChannels::ObservedChannels(const Schema& schema, bool may_miss)
    : has_names_(schema.named), may_miss_(may_miss), channels_(schema.channels.size()) {
  const std::vector<bool> are_plain = plain_channels(schema);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    Channel& channel = channels_[i];
    channel.source = schema.sources.empty() ? i : schema.sources[i];
    channel.name = schema.channels[i];
    channel.is_named_angle = is_usual_angle(channel.name);
    channel.is_unknown = are_plain[i];
    channel.is_coordinate = is_coordinate(channel.name);
    channel.may_be_angle = are_plain[i] && (channel.is_named_angle || !schema.named || may_be_angle(channel.name));
  }
}

/// Keeps whether channels have numbers at the ends of curves.
void ObservedChannels::add_ends(const KeyBlock& block) {
  const Keys& keys = block.keys;
  for (std::size_t key = 0; key < block.size(); ++key) {
    const bool begins = block.begins_curve(key) || (is_beginning_ && key == 0);
    for (Channel& channel : channels_) {
      const bool is_missing = std::isnan(keys.position(key)[channel.source]);
      if (begins) channel.lacks_end = channel.lacks_end || channel.lacks_last || is_missing;
      channel.lacks_last = is_missing;
    }
  }
}

namespace {

/// Whether a number is one that others write in the place of a missing one: nines such as -999 and 99.9, the least
/// integer of 16 bits, and numbers of 20 digits and more.
bool may_be_sign(double value) {
  constexpr double least_integer = -32768, huge = 1e20, close = 0.99;
  const double size = std::abs(value);
  double power = 100;
  while (size >= power && power < huge) power *= 10;
  if (size >= huge || value == least_integer) return true;
  if (size < close * power) return false;
  const std::string digits = fmt::format("{}", size);
  return digits.find_first_not_of("9.") == std::string::npos;
}

}  // namespace

void ObservedChannels::add(const KeyBlock& block) {
  if (may_miss_) add_ends(block);
  const Keys& keys = block.keys;
  for (Channel& channel : channels_) {
    for (std::size_t i = channel.source; i < keys.positions.size(); i += keys.channels) {
      const double value = keys.positions[i];
      if (!(value < channel.least || value > channel.most)) continue;
      if (may_be_sign(value)) {
        channel.signs = value == channel.sign ? channel.signs + 1 : 1;
        channel.sign = value;
      } else {
        channel.least = std::min(channel.least, value);
        channel.most = std::max(channel.most, value);
      }
    }
    const bool counts = channel.may_be_angle || (channel.is_unknown && is_beginning_);
    for (std::size_t key = 0; counts && key < block.size(); ++key) {
      if (block.begins_curve(key)) channel.before.reset();
      const double value = keys.position(key)[channel.source];
      if (std::isnan(value)) continue;
      channel.largest = std::max(channel.largest, std::abs(value));
      channel.is_positive = channel.is_positive && value >= 0;
      const double before = channel.before.value_or(value);
      if (std::abs(value - before) > channel.jump) {
        channel.jump = std::abs(value - before);
        channel.from = before;
        channel.to = value;
      }
      channel.before = value;
    }
  }
  is_beginning_ = false;
}

/// Whether the largest jump is between the eighths of a turn beside its end, as from 179 to -179 or from 359 to 1.
bool ObservedChannels::Channel::jumps_over_end(bool degrees) const {
  const double eighth = degrees ? 45 : 0.785;
  if (is_positive) return std::max(from, to) > 7 * eighth && std::min(from, to) < eighth;
  return std::min(std::abs(from), std::abs(to)) > 3 * eighth;
}

std::vector<NamedAngle> ObservedChannels::likely_angles() const {
  constexpr double half_turn = 3.15, whole_turn = 6.3;  // rounded up
  std::vector<NamedAngle> angles;
  // All are in one unit: 5 beside 350 is in degrees, too.
  const bool any_degrees = std::ranges::any_of(
      channels_, [](const Channel& channel) { return channel.may_be_angle && channel.largest > whole_turn; });
  for (const Channel& channel : channels_) {
    const bool degrees = channel.largest > whole_turn || (has_names_ && any_degrees && channel.may_be_angle);
    // Within one turn, from 0 or around 0, where the name tells little.
    const double most = channel.is_positive ? (degrees ? 360.5 : 6.29) : (degrees ? 180.5 : half_turn);
    const double turn = degrees ? 360 : 6.2832;
    // As from 190 to -160, where the name tells that it is an angle.
    const bool is_rotation = has_names_ && in_lower_case(channel.name).find("rotat") != std::string::npos;
    const bool is_turn = is_rotation && channel.may_be_angle && std::abs(channel.jump - turn) < turn / 4;
    const bool is_beyond = channel.largest > (is_turn ? 1.5 * turn : most);
    if (!channel.is_named_angle && (is_beyond || (!has_names_ && !degrees))) continue;
    const bool may_be_angle =
        channel.may_be_angle || ((degrees || !channel.is_coordinate) && channel.jumps_over_end(degrees));
    if (!may_be_angle) continue;
    if (channel.jump > (degrees ? 180 : half_turn)) angles.push_back({channel.name, degrees});
  }
  return angles;
}

/// Once, a number may also be a wrong one; those that are not far below zero are some in several places, and 99 beside
/// others alone.
std::vector<LikelySign> ObservedChannels::likely_signs() const {
  const auto count_of = [&](double sign) {
    std::size_t count = 0;
    for (const Channel& channel : channels_) count += channel.sign == sign ? channel.signs : 0;
    return count;
  };
  std::vector<LikelySign> signs;
  bool is_clear = false;
  for (const Channel& channel : channels_) {
    if (channel.signs == 0 || channel.least > channel.most) continue;
    const double size = std::abs(channel.sign), others = std::max(std::abs(channel.least), std::abs(channel.most));
    const bool is_far_below = channel.sign <= -999 && size < 1e20 && channel.sign < channel.least / 2 - 500;
    const bool is_far = others > 0 && size > 3 * others && count_of(channel.sign) > 1;
    if (!is_far_below && !is_far) continue;
    signs.push_back({channel.name, channel.sign});
    is_clear = is_clear || size > 99;
  }
  return is_clear ? signs : std::vector<LikelySign>();
}

std::vector<std::string> ObservedChannels::without_ends() const {
  std::vector<std::string> names;
  for (const Channel& channel : channels_) {
    if (channel.lacks_end || channel.lacks_last) names.push_back(channel.name);
  }
  return names;
}

void ObservedTcbs::add(const KeyBlock& block, const CurveSettings& settings, bool begins) {
  const Keys& keys = block.keys;
  const auto carries = [](const spline::Tcb<double>& tcb) {
    return tcb.tension != 0 || tcb.continuity != 0 || tcb.bias != 0;
  };
  const auto any_of = [&](std::size_t first, std::size_t last) {  // of the keys between them
    if (keys.tcbs.empty()) return carries(keys.common_tcb);
    const std::size_t per_key = keys.tcbs_per_key();
    return std::ranges::any_of(std::span(keys.tcbs).subspan(first * per_key, (last - first) * per_key), carries);
  };
  const std::size_t size = block.size();  // also where keys have no times
  const bool is_linear = settings.tangents == spline::TangentRule::linear;
  const bool is_closed = settings.period || (settings.closed && settings.closed->value);
  const bool has_usual_ends = !settings.preset && !settings.ends && !is_closed && !is_linear;
  if (begins) {
    at_ends_ = at_ends_ || is_last_ || (has_usual_ends && any_of(0, 1));
    has_named_ends_ = has_named_ends_ || settings.ends;
  }
  is_last_ = has_usual_ends && any_of(size - 1, size);
  const bool is_new = !any_ || (is_linear && !any_linear_);
  if (is_new && any_of(0, size)) {
    any_ = true;
    any_linear_ = any_linear_ || is_linear;
  }
}

Curves::Curves(const Schema& schema, const InputKeys& keys, const CurveOptions& options,
               const std::function<bool()>& arrive)
    : channels_(schema, keys.traits.may_miss),
      blocks_(observed(arranged(observed(keys.blocks, [this](const KeyBlock& block) { count_breaks(block); }), schema,
                                keys.traits, options, arrive, midnights_),
                       [this](const KeyBlock& block) { channels_.add(block); })),
      may_break_(keys.traits.may_break || !schema.groups.empty() || options.duplicates == Duplicates::break_curve ||
                 options.max_gap),
      max_gap_(largest_allowed_gap(schema.time, options)),
      groups_(keys.traits.own_curves ? 0 : schema.groups.size()),
      curve_info_(std::make_shared<const CurveInfo>(keys.curve_info)),
      own_curves_(keys.traits.own_curves) {}

/// Counts those between two keys.
void Curves::count_breaks(const KeyBlock& block) {
  if (block.curve_info != nullptr) any_read_ = is_broken_ = false;
  if (!block.empty()) {
    const bool at_front = block.has_break_before(0);
    breaks_ += block.breaks.before.size() - (at_front ? 1 : 0) + (any_read_ && (at_front || is_broken_) ? 1 : 0);
    any_read_ = true;
    is_broken_ = false;
  }
  is_broken_ = is_broken_ || block.breaks.at_end;
}

std::optional<InputCurve> Curves::next() {
  if (!first_ && !may_break_) return std::nullopt;
  while (!first_ && observed_keys()) {  // the rest of the curve before
  }
  const bool any = fill();
  if (!any && !first_) return std::nullopt;
  first_ = false;
  const bool continues = any && has_gap(at_);
  if (any && block_->curve_info != nullptr && at_ == 0) curve_info_ = std::exchange(block_->curve_info, nullptr);
  started_ = true;
  part_ = continues ? part_ + 1 : 0;
  if (part_ > 0) {
    ++gaps_;
    largest_gap_ = std::max(largest_gap_, (block_->keys.times[at_] - *last_).hi);
  } else if (any && max_gap_) {
    origin_ = block_->keys.times[at_];
  }
  last_.reset();
  InputCurve curve{group(), curve_info_, [this] { return observed_keys(); }};
  if (max_gap_) curve.part = {part_, origin_, [this] { return next_part(); }, *max_gap_};
  return curve;
}

std::optional<KeyBlock> Curves::next_keys() {
  if (!fill() || (!started_ && (block_->begins_curve(at_) || has_gap(at_)))) return std::nullopt;
  started_ = false;
  const auto next = std::ranges::upper_bound(block_->breaks.before, at_);
  std::size_t end = next == block_->breaks.before.end() ? block_->size() : *next;
  if (max_gap_) {
    std::size_t key = at_;
    for (last_ = block_->keys.times[key++]; key < end && !has_gap(key); ++key) last_ = block_->keys.times[key];
    end = key;
  }
  if (at_ == 0 && end == block_->size()) {
    std::optional<KeyBlock> whole = std::exchange(block_, std::nullopt);
    whole->breaks.before.clear();
    return whole;
  }
  return block_->range(std::exchange(at_, end), end);
}

std::optional<KeyBlock> Curves::observed_keys() {
  const bool begins = started_;
  std::optional<KeyBlock> block = next_keys();
  if (block) tcbs_.add(*block, curve_info_->settings, begins);
  return block;
}

std::vector<std::string> Curves::group() const {
  if (own_curves_) return {curve_info_->id};
  std::vector<std::string> texts;
  for (std::size_t i = 0; block_ && i < groups_; ++i) texts.emplace_back(block_->text(at_, i));
  return texts;
}

/// Whether the next key is further from the last key of the curve than a curve allows.
bool Curves::has_gap(std::size_t key) const {
  if (!max_gap_ || !last_ || block_->begins_curve(key)) return false;
  return is_gap(*last_, block_->keys.times[key], *max_gap_);
}

std::optional<Time> Curves::next_part() {
  if (!fill() || !has_gap(at_)) return std::nullopt;
  return block_->keys.times[at_];
}

/// Reads blocks until there is a next key; whether there is one.
bool Curves::fill() {
  while (!block_ || at_ == block_->size()) {
    block_ = blocks_();
    at_ = 0;
    if (!block_) return false;
    skipped_ += block_->faults.skipped;
  }
  return true;
}

}  // namespace tcb
