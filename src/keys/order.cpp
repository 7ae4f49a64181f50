// Order: keys without gaps, whose times increase up to the next break.
//
// Each function of order.hpp is a stage on blocks of keys, in the order of arranged() in curves.cpp. Two of them hold
// keys back until those after them are known, as HoldingStage does: Order, which drops, replaces or refuses keys whose
// times do not increase; Spreader, which divides a step among keys of one time.
#include "keys/order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// A stage that holds keys of a curve back until those after them are known.
class HoldingStage {
 public:
  explicit HoldingStage(Source<KeyBlock> blocks) : blocks_(std::move(blocks)) {}
  HoldingStage(const HoldingStage&) = delete;
  HoldingStage& operator=(const HoldingStage&) = delete;
  virtual ~HoldingStage() = default;

  std::optional<KeyBlock> next() {
    std::optional<KeyBlock> block = waiting_ ? std::exchange(waiting_, std::nullopt) : blocks_();
    if (!held_.empty() && (!block || block->begins_curve(0))) {
      waiting_ = std::move(block);
      end_curve();
      return std::exchange(held_, {});
    }
    if (!block || block->empty()) return block;
    return pass(std::move(*block));
  }

 protected:
  /// The keys to pass on of those that are held and those of a block, which continues their curve.
  virtual KeyBlock pass(KeyBlock block) = 0;
  /// No key of the curve follows those that are held.
  virtual void end_curve() {}

  KeyBlock held_;

 private:
  Source<KeyBlock> blocks_;
  std::optional<KeyBlock> waiting_;  ///< a block that begins a curve
};

template <class Stage, class... Settings>
Source<KeyBlock> through(Source<KeyBlock> blocks, Settings&&... settings) {
  const auto stage = std::make_shared<Stage>(std::move(blocks), std::forward<Settings>(settings)...);
  return [stage] { return stage->next(); };
}

/// Where a key is in its input, for messages about later keys.
struct KeyLocation {
  spline::Time<double> time;
  std::uint64_t line = 0;
  std::string list_position;  ///< as KeyBlock::list_position()

  /// "keys[3]: " where a key is in a list; its line is the position of the error elsewhere.
  std::string beginning() const { return list_position.empty() ? "" : list_position + ": "; }
  /// As in "2 on line 5", or "2 of keys[3]".
  std::string time_and_position() const {
    if (!list_position.empty()) return fmt::format("{} of {}", time_text(time), list_position);
    return fmt::format("{} on line {}", time_text(time), line);
  }
};

/// The stage of in_order(). With Duplicates::last, the next key may replace the last one, which is held.
class Order : public HoldingStage {
 public:
  Order(Source<KeyBlock> blocks, Duplicates duplicates, OrderRemedies remedies)
      : HoldingStage(std::move(blocks)), duplicates_(duplicates), remedies_(std::move(remedies)) {}

 private:
  KeyBlock pass(KeyBlock block) override {
    if (!held_.empty() || !is_in_order(block)) block = filtered(std::move(block));
    if (block.empty()) return block;
    before_ = location(block, block.size() - 1);
    if (duplicates_ == Duplicates::last) held_ = block.cut(block.size() - 1);
    return block;
  }

  bool is_in_order(const KeyBlock& block) const {
    const auto& times = block.keys.times;
    if (before_ && !times.empty() && !block.begins_curve(0) && !is_earlier(before_->time, times[0])) return false;
    for (std::size_t i = 1; i < times.size(); ++i) {
      if (!is_earlier(times[i - 1], times[i]) && !block.begins_curve(i)) return false;
    }
    return true;
  }

  static KeyLocation location(const KeyBlock& block, std::size_t key) {
    return {block.keys.times[key], block.line(key), block.list_position(key)};
  }

  /// The keys to keep; the others are dropped, or are faults of the block.
  KeyBlock filtered(KeyBlock block) {
    KeyBlock all = std::exchange(held_, {});
    const std::size_t held = all.size();
    std::vector<std::size_t> kept, breaks = all.breaks.before;
    all.append(block, 0, block.size());
    if (held > 0) kept.push_back(0);
    for (std::size_t i = held; i < all.size(); ++i) {
      const bool begins_curve = block.begins_curve(i - held);
      const Placement placement = begins_curve ? Placement::begins_curve : placement_of(all.keys.times[i]);
      const bool repeats = placement == Placement::repeats;
      if (repeats || placement == Placement::goes_back) block.faults.errors.push_back(fault(all, i, repeats));
      if (repeats || placement == Placement::dropped) continue;
      if (placement == Placement::replaces_last) kept.pop_back();
      if (placement == Placement::begins_curve) breaks.push_back(kept.size());
      before_ = location(all, i);
      kept.push_back(i);
    }
    KeyBlock result = all.selected(kept);
    if (held > 0) result.curve_info = std::move(all.curve_info);
    result.breaks.before = std::move(breaks);
    result.take_block_data(block);
    return result;
  }

  /// The place of a key after those that were kept. With the time of the last one it is a fault or as requested;
  /// with an earlier time it is a fault, and the next key is compared with it.
  enum class Placement { follows, begins_curve, replaces_last, dropped, repeats, goes_back };
  Placement placement_of(const Time& time) const {
    if (!before_ || is_earlier(before_->time, time)) return Placement::follows;
    if (is_earlier(time, before_->time)) return Placement::goes_back;
    if (!remedies_.label.empty()) return Placement::repeats;
    switch (duplicates_) {
      case Duplicates::first: return Placement::dropped;
      case Duplicates::last: return Placement::replaces_last;
      case Duplicates::break_curve: return Placement::begins_curve;
      case Duplicates::spread:
      case Duplicates::error: break;
    }
    return Placement::repeats;
  }

  Error fault(const KeyBlock& block, std::size_t key, bool equal) const {
    const KeyLocation here = location(block, key);
    const std::string beginning = here.beginning(), time = time_text(here.time), before = before_->time_and_position();
    if (!remedies_.label.empty()) {
      return data_error(
                 "{}time {} {} the time {}, beside other values in column {}; expected the keys of one curve; {}",
                 beginning, time, equal ? "repeats" : "is less than", before, in_shell(remedies_.label),
                 remedy_for_label(remedies_.label))
          .at(block.text_position(key));
    }
    std::string give = "give ";
    if (remedies_.has_time_by_place) {
      give += "--parameter uniform if the first column is no time, --columns time=NUMBER if another one is, ";
    }
    if (!remedies_.group.empty()) give += fmt::format("--group {} if a column tells curves apart, ", remedies_.group);
    const bool has_others = give.ends_with(", ");
    give += has_others ? "or " : "";
    return (equal ? data_error("{}time {} repeats the time {}; expected increasing times; remove one of the keys, or "
                               "{}--duplicates first, last or break",
                               beginning, time, before, give)
                  : data_error("{}time {} is less than the time {}; expected increasing times; {}--sort{}", beginning,
                               time, before, give, has_others ? " if the keys are of one curve" : ""))
        .at(block.text_position(key));
  }

  Duplicates duplicates_;
  OrderRemedies remedies_;
  std::optional<KeyLocation> before_;  ///< of the last key that remained
};

/// The exact times of the keys of a block that are changed.
using WrittenTimes = std::vector<std::optional<Rational>>;

/// Sets the times of keys as written, if the numbers of keys are kept so. No text is changed for a key without a time.
void set_written_times(KeyBlock& block, std::span<const std::optional<Rational>> times) {
  const auto is_changed = [](const auto& time) { return time.has_value(); };
  if (std::ranges::none_of(times, is_changed)) return;
  block.rewrite_decimals([&](std::size_t key, std::size_t number, std::string_view text) {
    return times[key] && number == NumberOfKey::time ? ratio_text(*times[key]) : std::string(text);
  });
}

/// The stage of spread_out(), which holds the keys of one time.
class Spreader : public HoldingStage {
 public:
  using HoldingStage::HoldingStage;

 private:
  KeyBlock pass(KeyBlock block) override {
    KeyBlock all = std::exchange(held_, {});
    for (const std::size_t key : block.breaks.before) all.breaks.before.push_back(all.size() + key);
    all.append(block, 0, block.size());
    all.take_block_data(block);
    WrittenTimes times(all.size());
    std::size_t group = 0;  // the first key with the current time
    for (std::size_t key = 1; key < all.size(); ++key) {
      if (all.has_break_before(key)) {
        divide(all.keys, times, std::exchange(group, key), key);
        step_.reset();
      } else if (all.keys.times[key] != all.keys.times[group]) {
        step_ = exact_time(all.keys.times[key]) - exact_time(all.keys.times[group]);
        divide(all.keys, times, group, key);
        group = key;
      }
    }
    set_written_times(all, times);
    held_ = all.cut(group);
    return all;
  }

  void end_curve() override {
    WrittenTimes times(held_.size());
    divide(held_.keys, times, 0, held_.size());
    set_written_times(held_, times);
    step_.reset();
  }

  /// Gives keys with the same time equal parts of the step. Where there is none, or they go back, they stay.
  void divide(Keys& keys, WrittenTimes& times, std::size_t first, std::size_t last) const {
    if (last - first < 2 || !step_ || *step_ <= 0) return;
    const Rational start = exact_time(keys.times[first]), part = *step_ / (last - first);
    for (std::size_t key = first + 1; key < last; ++key) {
      times[key] = start + part * (key - first);
      keys.times[key] = nearest_time(*times[key]);
    }
  }

  std::optional<Rational> step_;  ///< between the last two times of the curve
};

}  // namespace

std::string remedy_for_label(std::string_view label) {
  return fmt::format("give --group {} for one curve per value, or --columns {} if the values do not distinguish curves",
                     in_shell(label), in_shell(fmt::format("carry={}", label)));
}

Source<KeyBlock> without_gaps(Source<KeyBlock> blocks) {
  return [blocks = std::move(blocks), broken = false, any = false]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block) return std::nullopt;
    if (block->breaks.gaps.empty() && block->breaks.before.empty() && !broken) {
      any = any || !block->empty();
      broken = std::exchange(block->breaks.at_end, false) && any;
      return block;
    }
    std::vector<std::size_t> kept, breaks;
    for (std::size_t i = 0; i < block->size(); ++i) {
      const bool gap = block->has_gap_at(i);
      broken = broken || gap || block->has_break_before(i);
      if (gap) continue;
      if (std::exchange(broken, false) && any) breaks.push_back(kept.size());
      kept.push_back(i);
      any = true;
    }
    broken = broken || block->breaks.at_end;
    if (!block->breaks.gaps.empty()) {
      KeyBlock rest = block->selected(kept);
      rest.take_block_data(*block);
      block = std::move(rest);
    }
    block->breaks.before = std::move(breaks);
    block->breaks.gaps.clear();
    block->breaks.at_end = false;
    return block;
  };
}

Source<KeyBlock> spread_out(Source<KeyBlock> blocks) { return through<Spreader>(std::move(blocks)); }

Source<KeyBlock> in_order(Source<KeyBlock> blocks, Duplicates duplicates, OrderRemedies remedies) {
  return through<Order>(std::move(blocks), duplicates, std::move(remedies));
}

Source<KeyBlock> past_midnight(Source<KeyBlock> blocks, TimeNotation notation, const Rational& rate,
                               std::uint64_t& midnights) {
  const std::optional<Rational> day = day_of(notation, rate);
  if (!day) return blocks;
  const auto later = [=](const Time& time, const Rational& days) {
    constexpr int as_many_as_it_has = 1;
    const Rational seconds = exact_time(time);
    if (!counts_frames(notation)) return nearest_time(seconds + days, as_many_as_it_has);
    const std::optional<Rational> frame = whole_frame(seconds, rate);
    return nearest_time((frame ? *frame / rate : seconds) + days);
  };
  const auto add_days = [=, &midnights, days = Rational(0), before = std::optional<double>()](KeyBlock block) mutable {
    std::vector<std::optional<Rational>> written(block.size());  // times with days that were added
    const std::size_t per_key = block.empty() ? 0 : block.decimals.size() / block.size();
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (block.begins_curve(i)) {
        before.reset();
        days = 0;
      }
      Time& time = block.keys.times[i];
      if (before && *before - time.hi > nearest_double(*day) / 2) {
        days += *day;
        ++midnights;
      }
      before = time.hi;
      if (days == 0) continue;
      time = later(time, days);
      if (per_key > 0) written[i] = parse_rational(block.decimals[i * per_key + NumberOfKey::time]);
      if (written[i]) *written[i] += days;
    }
    set_written_times(block, written);
    return block;
  };
  return with_time_digits(mapped(std::move(blocks), add_days));
}

namespace {

/// The exact time of a key of a block: that which is written, if texts are kept.
Rational exact_time_of(const KeyBlock& block, std::size_t key, const std::optional<FrameTimes>& frames) {
  const std::size_t per_key = block.empty() ? 0 : block.decimals.size() / block.size();
  if (per_key > 0) {
    if (const auto written = parse_rational(block.decimals[key * per_key + NumberOfKey::time])) return *written;
  }
  const auto frame = frames ? frames->exact(block.keys.times[key]) : std::nullopt;
  return frame ? *frame : exact_time(block.keys.times[key]);
}

Time time_nearest_to(const Rational& exact) {
  const Time decimal = nearest_time(exact, digits_of_time);
  return !std::isfinite(decimal.hi) || exact_time(decimal) == exact ? decimal : nearest_time(exact);
}

}  // namespace

std::optional<Rational> first_time(Source<KeyBlock>& keys, const std::optional<FrameTimes>& frames) {
  std::optional<KeyBlock> block = keys();
  while (block && block->empty()) block = keys();
  if (!block) return std::nullopt;
  const auto time = block->keys.times.empty() ? std::nullopt : std::optional(exact_time_of(*block, 0, frames));
  keys = preceded_by(std::move(*block), std::move(keys));
  return time;
}

Time less(const Time& time, const Rational& zero, const std::optional<FrameTimes>& frames) {
  const auto frame = frames ? frames->exact(time) : std::nullopt;
  return time_nearest_to((frame ? *frame : exact_time(time)) - zero);
}

Source<KeyBlock> less(Source<KeyBlock> keys, const Rational& zero, const std::optional<FrameTimes>& frames) {
  return with_time_digits(
      mapped(std::move(keys), [zero, frames, before = std::optional<Time>()](KeyBlock block) mutable {
        WrittenTimes written(block.size());
        for (std::size_t key = 0; key < block.keys.times.size(); ++key) {
          Time& time = block.keys.times[key];
          const Rational exact = exact_time_of(block, key, frames) - zero;
          const Time counted = time_nearest_to(exact);
          if (!std::isfinite(counted.hi) || (before && !(*before < counted))) {
            throw data_error(
                "time {} is too far from --time-zero; expected a difference below 1.8e308, and other than that of the "
                "key before; give a time that is nearer",
                time_text(time))
                .at(block.text_position(key));
          }
          before = time = counted;
          written[key] = exact;
        }
        if (!block.decimals.empty()) set_written_times(block, written);
        return block;
      }));
}

Source<KeyBlock> with_time_digits(Source<KeyBlock> blocks) {
  return mapped(std::move(blocks), [many = false](KeyBlock block) mutable {
    std::vector<Time>& times = block.keys.times;
    many = many || std::ranges::any_of(times, has_many_digits);
    for (Time& time : times) {
      if (many || time.lo != 0) time = many ? with_all_digits(time) : as_double(time);
    }
    return block;
  });
}

}  // namespace tcb
