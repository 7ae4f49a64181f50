// The order of keys: where curves break off, times that repeat, and times that go back.
#include "keys/order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "input/blocks.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

bool stands_in(const std::vector<std::size_t>& numbers, std::size_t number) {
  return std::ranges::binary_search(numbers, number);
}

/// Everything about a block but its keys.
KeyBlock with_the_rest(KeyBlock keys, KeyBlock& block) {
  keys.keys.channels = block.keys.channels;
  keys.keys.common_tcb = block.keys.common_tcb;
  keys.break_after = block.break_after;
  if (keys.curve_info == nullptr) keys.curve_info = std::move(block.curve_info);
  keys.skipped = block.skipped;
  keys.faults = std::move(block.faults);
  keys.unreadable = block.unreadable;
  return keys;
}

/// Walks over keys and remembers the time before.
class Order {
  using Time = spline::Time<double>;

 public:
  Order(Source<KeyBlock> blocks, Duplicates duplicates) : blocks_(std::move(blocks)), duplicates_(duplicates) {}

  std::optional<KeyBlock> next() {
    std::optional<KeyBlock> block = waiting_ ? std::exchange(waiting_, std::nullopt) : blocks_();
    if (!held_.lines.empty() && (!block || begins(*block, 0))) {
      waiting_ = std::move(block);
      return std::exchange(held_, {});
    }
    if (!block) return std::nullopt;
    if (!held_.lines.empty() || !is_in_order(*block)) block = sift(std::move(*block));
    if (duplicates_ == Duplicates::last) return hold_last(std::move(*block));
    remember(*block);
    return block;
  }

 private:
  bool is_in_order(const KeyBlock& block) const {
    const auto& times = block.keys.times;
    if (before_ && !times.empty() && !begins(block, 0) && !(*before_ < times[0])) return false;
    for (std::size_t i = 1; i < times.size(); ++i) {
      if (!(times[i - 1] < times[i]) && !begins(block, i)) return false;
    }
    return true;
  }

  /// A curve begins with this key.
  static bool begins(const KeyBlock& block, std::size_t key) {
    return (key == 0 && block.curve_info != nullptr) || stands_in(block.breaks, key);
  }

  void remember(const KeyBlock& block) {
    if (block.lines.empty()) return;
    before_ = block.keys.times.back();
    name_ = name_of_key(block, block.lines.size() - 1);
  }

  /// The keys that stay, one by one; those that do not are dropped or refused.
  KeyBlock sift(KeyBlock block) {
    KeyBlock all = std::exchange(held_, {});
    const std::size_t held = all.lines.size();
    std::vector<std::size_t> stay, breaks = all.breaks;
    append(all, block, 0, block.lines.size());
    if (held > 0) stay.push_back(0);
    for (std::size_t i = held; i < all.lines.size(); ++i) {
      const bool begins_curve = begins(block, i - held);
      if (begins_curve) breaks.push_back(stay.size());
      if (judge(all, i, begins_curve, block.faults, stay, breaks)) stay.push_back(i);
    }
    KeyBlock result = chosen(all, stay);
    if (held > 0) result.curve_info = std::move(all.curve_info);
    result.breaks = std::move(breaks);
    return with_the_rest(std::move(result), block);
  }

  /// Whether a key stays.
  bool judge(const KeyBlock& block, std::size_t key, bool begins_curve, std::vector<Error>& faults,
             std::vector<std::size_t>& stay, std::vector<std::size_t>& breaks) {
    const Time time = block.keys.times[key];
    const bool free = begins_curve || !before_ || *before_ < time;
    const bool equal = !free && *before_ == time;
    bool stays = free;
    if (equal && duplicates_ == Duplicates::break_curve) {
      breaks.push_back(stay.size());
      stays = true;
    } else if (equal && duplicates_ == Duplicates::last) {
      stay.pop_back();
      stays = true;
    } else if (!free && !(equal && duplicates_ == Duplicates::first)) {
      faults.push_back(fault(block, key, equal));
      stays = !equal;
    }
    if (!stays) return false;
    before_ = time;
    name_ = name_of_key(block, key);
    return true;
  }

  Error fault(const KeyBlock& block, std::size_t key, bool equal) const {
    const std::string subject = block.numbers.empty() ? "" : name_of_key(block, key) + ": ";
    return {Exit::data, place_of_key(block, key),
            fmt::format("{}time {} {} the time {} {} {}; expected times that increase; {}", subject,
                        time_text(block.keys.times[key]), equal ? "repeats" : "is less than", time_text(*before_),
                        block.numbers.empty() ? "in" : "of", name_,
                        equal ? "take one of them out, or give --duplicates first, last or break"
                              : "sort the rows by time, or give --sort")};
  }

  /// All but the last key, which the next one may replace.
  KeyBlock hold_last(KeyBlock block) {
    if (block.lines.empty()) return block;
    remember(block);
    const std::size_t last = block.lines.size() - 1;
    append(held_, block, last, last + 1);
    if (stands_in(block.breaks, last)) {
      held_.breaks = {0};
      block.breaks.pop_back();
    }
    KeyBlock rest;
    append(rest, block, 0, last);
    rest.breaks = std::move(block.breaks);
    if (last == 0) held_.curve_info = std::move(block.curve_info);
    rest.curve_info = std::move(block.curve_info);
    return with_the_rest(std::move(rest), block);
  }

  Source<KeyBlock> blocks_;
  Duplicates duplicates_;
  std::optional<Time> before_;  ///< the time of the key before, if there is one
  std::string name_;            ///< and its name
  KeyBlock held_;               ///< a key that the next one may replace
  std::optional<KeyBlock> waiting_;
};

}  // namespace

Source<KeyBlock> without_gaps(Source<KeyBlock> blocks) {
  return [blocks = std::move(blocks), broken = false, any = false]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block) return std::nullopt;
    if (block->gaps.empty() && block->breaks.empty() && !broken) {
      any = any || !block->lines.empty();
      broken = std::exchange(block->break_after, false) && any;
      return block;
    }
    std::vector<std::size_t> stay, breaks;
    for (std::size_t i = 0; i < block->lines.size(); ++i) {
      const bool gap = stands_in(block->gaps, i);
      broken = broken || gap || stands_in(block->breaks, i);
      if (gap) continue;
      if (std::exchange(broken, false) && any) breaks.push_back(stay.size());
      stay.push_back(i);
      any = true;
    }
    broken = broken || block->break_after;
    if (!block->gaps.empty()) block = with_the_rest(chosen(*block, stay), *block);
    block->breaks = std::move(breaks);
    block->gaps.clear();
    block->break_after = false;
    return block;
  };
}

Source<KeyBlock> in_order(Source<KeyBlock> blocks, Duplicates duplicates) {
  const auto order = std::make_shared<Order>(std::move(blocks), duplicates);
  return [order] { return order->next(); };
}

}  // namespace tcb
