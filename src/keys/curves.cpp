// Curves: the keys of an input, arranged and split into curves.
#include "keys/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "keys/angles.hpp"
#include "keys/grouping.hpp"
#include "keys/order.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
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

/// What faults of one kind have in common: the message without the texts and numbers of each.
std::string kind_of(std::string_view message) {
  std::string kind;
  bool in_quotes = false, in_word = false;
  for (const char c : message) {
    const bool is_digit = c >= '0' && c <= '9';
    if (c == '"') in_quotes = !in_quotes;
    if (!in_quotes && (!is_digit || in_word)) kind += c;
    in_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (is_digit && in_word);
  }
  return kind;
}

/// Faults of one kind.
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

/// The stage of joined_segments(). Keys come in pairs: the start of a segment, and its end.
class Joiner {
 public:
  explicit Joiner(Source<KeyBlock> ends) : ends_(std::move(ends)) {}

  std::optional<KeyBlock> next() {
    std::optional<KeyBlock> block = waiting_ ? std::exchange(waiting_, std::nullopt) : ends_();
    if (!held_.empty() && (!block || block->begins_curve(0))) {
      waiting_ = std::move(block);
      return std::exchange(held_, {});
    }
    if (!block || block->empty()) return block;
    return keys_of(std::move(*block));
  }

 private:
  /// The keys of a block but the last one, which the next block may continue.
  KeyBlock keys_of(KeyBlock block) {
    std::vector<std::size_t> kept, breaks;
    const bool continues = !held_.empty();
    for (std::size_t start = 0; start < block.size(); start += 2) {
      const bool begins = start == 0 ? !continues : block.has_break_before(start);
      if (begins && start > 0) kept.push_back(start - 1);
      if (block.has_break_before(start)) breaks.push_back(kept.size());
      if (!begins) join(start == 0 ? held_ : block, start == 0 ? 0 : start - 1, block, start);
      kept.push_back(start);
      require_duration(block, start);
    }
    KeyBlock result = block.selected(kept);
    if (!result.decimals.empty()) result.decimals = joined_decimals(block, kept);
    result.take_block_data(block);
    result.breaks.before = std::move(breaks);
    held_ = block.range(block.size() - 1, block.size());
    return result;
  }

  /// Gives the start of a segment the incoming velocities of the end before it. Throws: Error (data) if they are apart.
  void join(const KeyBlock& before, std::size_t end, KeyBlock& block, std::size_t start) const {
    const Time &from = block.keys.times[start], &to = before.keys.times[end];
    const double distance = std::abs((from - to).hi);
    if (!(distance <= 0x1p-51 * std::max(size_, std::abs(from.hi)))) {
      throw data_error(
          "this segment starts at {}, but the segment before it ends at {}; expected segments without gaps, in order; "
          "correct them, or divide the curves with {}",
          time_text(from), time_text(to), option::group)
          .at(block.text_position(start));
    }
    const std::size_t channels = block.keys.channels;
    for (std::size_t i = 0; i < channels; ++i) {
      const double here = block.keys.position(start)[i], there = before.keys.position(end)[i];
      if (here != there)
        throw data_error(
            "this segment starts at the position {}, but the segment before it ends at {}; expected the same position; "
            "correct one of the two",
            here, there)
            .at(block.text_position(start));
      block.keys.velocities[start * channels + i].in = before.keys.velocities[end * channels + i].in;
    }
  }

  /// Sets the size of the times of a segment, to which their rounding errors are relative.
  void require_duration(const KeyBlock& block, std::size_t start) {
    const Time &from = block.keys.times[start], &to = block.keys.times[start + 1];
    const double duration = (to - from).hi;
    if (!(from < to)) throw segment_without_duration(duration).at(block.text_position(start));
    size_ = std::max(std::abs(from.hi), duration);
  }

  /// The numbers of the keys as written, with the incoming velocities of the ends that they are joined to.
  Texts joined_decimals(const KeyBlock& block, const std::vector<std::size_t>& kept) const {
    Texts texts;
    const std::size_t per_key = block.decimals.size() / block.size(), channels = block.keys.channels;
    const std::size_t first = NumberOfKey::of_channel(NumberOfKey::velocity_in_of, 0, channels);
    for (const std::size_t key : kept) {
      const bool is_start = key % 2 == 0;
      for (std::size_t i = 0; i < per_key; ++i) {
        const bool is_incoming = is_start && i >= first && i < first + channels;
        const Texts& from = is_incoming && key == 0 ? held_.decimals : block.decimals;
        const std::size_t owner = !is_incoming ? key : key == 0 ? 0 : key - 1;
        texts.add(from.empty() ? std::string_view() : from[owner * per_key + i]);
      }
    }
    return texts;
  }

  Source<KeyBlock> ends_;
  KeyBlock held_;                    ///< the end of the last segment
  std::optional<KeyBlock> waiting_;  ///< a block that begins a curve
  double size_ = 0;                  ///< of the times of the last segment
};

/// The keys of segments, whose ends are two keys each: where a segment begins at the end of the one before it, both are
/// one key, with the velocities of both. Throws: Error (data) with the line of a segment that does not begin there.
Source<KeyBlock> joined_segments(Source<KeyBlock> ends) {
  const auto joiner = std::make_shared<Joiner>(std::move(ends));
  return [joiner] { return joiner->next(); };
}

void require_times(const CurveOptions& options) {
  if (options.sort)
    throw data_error(
        "{} orders rows by time, but there is no time column; remove it, or name the column with {} time=NAME",
        option::sort, option::columns);
  if (options.max_gap) {
    throw data_error("{} is about times, but there is no time column; remove it, or name the column with {} time=NAME",
                     option::max_gap, option::columns);
  }
  if (options.duplicates != Duplicates::error)
    throw data_error(
        "{} is about equal times, but there is no time column; remove it, or name the column with {} time=NAME",
        option::duplicates, option::columns);
}

/// The keys in order, without faults; `midnights` is as for past_midnight().
Source<KeyBlock> arranged(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live,
                          const std::shared_ptr<std::uint64_t>& midnights) {
  const KeyTraits& traits = keys.traits;
  const bool is_ordered = schema.time.is_given && !options.any_order;
  Source<KeyBlock> blocks = is_ordered ? with_time_digits(keys.blocks) : keys.blocks;
  const bool is_grouped = traits.has_whole_curves && !options.sort;
  const bool by_text = !schema.groups.empty() && !traits.own_curves && !is_grouped;
  if (!schema.time.is_given) require_times(options);
  if (traits.are_segments && options.sort)
    throw data_error("{} orders keys, but the rows are segments; expected segments in order; remove {}", option::sort,
                     option::sort);
  if (by_text || options.sort) {
    blocks = grouped(without_faults(std::move(blocks), false),
                     {by_text ? schema.groups.size() : 0, options.sort, traits.own_curves,
                      by_text ? std::vector<Mark>{} : traits.marks});
  }
  blocks = without_gaps(std::move(blocks));
  if (is_ordered && !options.sort) {
    blocks = past_midnight(std::move(blocks), schema.time.notation, schema.time.frame_rate.value_or(1), midnights);
  }
  if (traits.are_segments) blocks = joined_segments(without_faults(std::move(blocks), live));
  if (is_ordered && options.duplicates == Duplicates::spread) blocks = spread_out(std::move(blocks));
  if (is_ordered) blocks = in_order(std::move(blocks), options.duplicates, {traits.marks, traits.channels});
  return without_faults(std::move(blocks), live);
}

}  // namespace

Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live) {
  return [blocks = std::move(blocks), live]() -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block || block->faults.errors.empty()) return block;
    std::vector<Error> faults;
    bool are_all = true;
    for (bool more = true; more;) {
      const bool is_full = block->faults.errors.size() >= most_faults;
      gather(faults, *block);
      more = faults.size() < most_faults && !block->faults.unreadable && !live;
      are_all = are_all && more && !is_full;
      try {
        if (more) block = blocks();
      } catch (const Error& error) {
        faults.push_back(error);
        more = are_all = false;
      }
      more = more && block;
    }
    refuse(faults, are_all);
  };
}

/// Splits blocks of keys where curves begin.
class Curves::Splitter {
 public:
  Splitter(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live)
      : angles_(schema),
        blocks_(angles_.observe(arranged(schema, keys, options, live, midnights_))),
        may_break_(keys.traits.may_break || !schema.groups.empty() || options.duplicates == Duplicates::break_curve ||
                   options.max_gap),
        max_gap_(max_gap(schema.time, options)),
        groups_(keys.traits.own_curves ? 0 : schema.groups.size()),
        curve_info_(std::make_shared<const CurveInfo>(keys.curve_info)),
        own_curves_(keys.traits.own_curves) {}

  /// Skips the rest of the current curve; whether there is another one.
  bool begin() {
    if (!first_ && !may_break_) return false;
    while (!first_ && next_keys()) {
    }
    const bool any = fill();
    if (!any && !first_) return false;
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
    return true;
  }

  /// The next keys of the current curve.
  std::optional<KeyBlock> next_keys() {
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

  std::vector<std::string> group() const {
    if (own_curves_) return {curve_info_->id};
    std::vector<std::string> texts;
    for (std::size_t i = 0; block_ && i < groups_; ++i) texts.emplace_back(block_->text(at_, i));
    return texts;
  }

  std::shared_ptr<const CurveInfo> curve_info() const { return curve_info_; }
  std::uint64_t skipped() const { return skipped_; }
  std::uint64_t midnights() const { return *midnights_; }
  std::uint64_t gaps() const { return gaps_; }
  double largest_gap() const { return largest_gap_; }
  std::optional<CurvePart> part(const std::shared_ptr<Splitter>& self) const {
    if (!max_gap_) return std::nullopt;
    return CurvePart{part_, origin_, [self] { return self->next_part(); }};
  }
  std::vector<NamedAngle> likely_angles() const { return angles_.found(); }

 private:
  /// The largest gap within a curve, in the unit of the times.
  static std::optional<Rational> max_gap(const TimeSchema& time, const CurveOptions& options) {
    std::optional<Rational> gap = options.max_gap;
    if (gap && options.is_max_gap_in_seconds) {
      if (time.unit == TimeUnit::frames) {
        throw data_error("the times in {} are frames, whose duration is unknown; give {} as a number of frames, or {}",
                         in_quotes(time.name), option::max_gap, option::input_fps);
      }
      if (time.unit) *gap *= units_per_second(*time.unit);
    }
    return gap;
  }

  /// Whether the next key is further from the last key of the curve than a curve allows.
  bool has_gap(std::size_t key) const {
    if (!max_gap_ || !last_ || block_->begins_curve(key)) return false;
    const Time& time = block_->keys.times[key];
    const double step = (time - *last_).hi, most = nearest_double(*max_gap_);
    const double doubt = 0x1p-50 * (std::abs(time.hi) + std::abs(last_->hi) + most);
    if (std::abs(step - most) > doubt) return step > most;
    return exact_time(time) - exact_time(*last_) > *max_gap_;
  }

  /// The time of the first key of the next part.
  std::optional<Time> next_part() {
    if (!fill() || !has_gap(at_)) return std::nullopt;
    return block_->keys.times[at_];
  }

  /// Reads blocks until there is a next key; whether there is one.
  bool fill() {
    while (!block_ || at_ == block_->size()) {
      block_ = blocks_();
      at_ = 0;
      if (!block_) return false;
      skipped_ += block_->faults.skipped;
    }
    return true;
  }

  std::shared_ptr<std::uint64_t> midnights_ = std::make_shared<std::uint64_t>(0);
  LikelyAngles angles_;
  Source<KeyBlock> blocks_;
  bool may_break_;
  std::optional<Rational> max_gap_;  ///< in the unit of the times
  std::size_t groups_;
  std::shared_ptr<const CurveInfo> curve_info_;
  bool own_curves_;
  std::optional<KeyBlock> block_;  ///< holds the next key
  std::size_t at_ = 0;             ///< its index
  std::uint64_t skipped_ = 0;
  bool first_ = true;         ///< no curve has begun
  bool started_ = false;      ///< the next key is the first of the current curve
  std::optional<Time> last_;  ///< the time of the last key that was handed out of the current curve
  Time origin_;               ///< the time of the first key of the first part of the current curve
  std::size_t part_ = 0;      ///< of the curve that gaps divide
  std::uint64_t gaps_ = 0;
  double largest_gap_ = 0;
};

Curves::Curves(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live)
    : splitter_(std::make_shared<Splitter>(schema, keys, options, live)) {}

std::optional<InputCurve> Curves::next() {
  if (!splitter_->begin()) return std::nullopt;
  return InputCurve{splitter_->group(), splitter_->curve_info(),
                    [splitter = splitter_] { return splitter->next_keys(); }, splitter_->part(splitter_)};
}

std::uint64_t Curves::skipped() const { return splitter_->skipped(); }
std::vector<NamedAngle> Curves::likely_angles() const { return splitter_->likely_angles(); }
std::uint64_t Curves::midnights() const { return splitter_->midnights(); }
std::uint64_t Curves::gaps() const { return splitter_->gaps(); }
double Curves::largest_gap() const { return splitter_->largest_gap(); }

}  // namespace tcb
