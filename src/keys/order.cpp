// The order of keys: where curves break off, times that repeat, and times that go back.
#include "keys/order.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "input/key_block.hpp"
#include "text/print_number.hpp"

namespace tcb {
namespace {

/// Where a key is in its input, for messages about later keys.
struct KeyLocation {
  spline::Time<double> time;
  std::uint64_t line = 0;
  std::string list_position;  ///< as KeyBlock::list_position()
};

/// The stage of in_order().
class Order {
 public:
  Order(Source<KeyBlock> blocks, Duplicates duplicates) : blocks_(std::move(blocks)), duplicates_(duplicates) {}

  std::optional<KeyBlock> next() {
    std::optional<KeyBlock> block = waiting_ ? std::exchange(waiting_, std::nullopt) : blocks_();
    if (!held_.empty() && (!block || block->begins_curve(0))) {
      waiting_ = std::move(block);
      return std::exchange(held_, {});
    }
    if (!block) return std::nullopt;
    if (!held_.empty() || !is_in_order(*block)) block = filtered(std::move(*block));
    if (block->empty()) return block;
    before_ = location(*block, block->size() - 1);
    // The next key may replace the last one.
    if (duplicates_ == Duplicates::last) held_ = block->split_last();
    return block;
  }

 private:
  bool is_in_order(const KeyBlock& block) const {
    const auto& times = block.keys.times;
    if (before_ && !times.empty() && !block.begins_curve(0) && !(before_->time < times[0])) return false;
    for (std::size_t i = 1; i < times.size(); ++i) {
      if (!(times[i - 1] < times[i]) && !block.begins_curve(i)) return false;
    }
    return true;
  }

  static KeyLocation location(const KeyBlock& block, std::size_t key) {
    return {block.keys.times[key], block.lines[key], block.list_position(key)};
  }

  /// The keys that remain; the others are dropped, or are faults of the block.
  KeyBlock filtered(KeyBlock block) {
    KeyBlock all = std::exchange(held_, {});
    const std::size_t held = all.size();
    std::vector<std::size_t> kept, breaks = all.breaks;
    all.append(block, 0, block.size());
    if (held > 0) kept.push_back(0);
    for (std::size_t i = held; i < all.size(); ++i) {
      const bool begins_curve = block.begins_curve(i - held);
      if (begins_curve) breaks.push_back(kept.size());
      if (!keeps(all, i, begins_curve, block.faults, kept, breaks)) continue;
      before_ = location(all, i);
      kept.push_back(i);
    }
    KeyBlock result = all.selected(kept);
    if (held > 0) result.curve_info = std::move(all.curve_info);
    result.breaks = std::move(breaks);
    result.take_block_data(block);
    return result;
  }

  /// Whether a key remains. The last of equal times replaces the one before in `kept`.
  bool keeps(const KeyBlock& block, std::size_t key, bool begins_curve, std::vector<Error>& faults,
             std::vector<std::size_t>& kept, std::vector<std::size_t>& breaks) const {
    const Time time = block.keys.times[key];
    if (begins_curve || !before_ || before_->time < time) return true;
    const bool equal = before_->time == time;
    if (equal && duplicates_ == Duplicates::first) return false;
    if (equal && duplicates_ == Duplicates::break_curve) {
      breaks.push_back(kept.size());
      return true;
    }
    if (equal && duplicates_ == Duplicates::last) {
      kept.pop_back();
      return true;
    }
    faults.push_back(fault(block, key, equal));
    return !equal;
  }

  Error fault(const KeyBlock& block, std::size_t key, bool equal) const {
    const bool in_list = !before_->list_position.empty();
    std::vector<ErrorValue> values{time_text(block.keys.times[key]), time_text(before_->time)};
    if (in_list) {
      values.insert(values.end(), {before_->list_position, block.list_position(key)});
    } else {
      values.emplace_back(before_->line);
    }
    const ErrorCode code = equal ? (in_list ? ErrorCode::equal_times_in_list : ErrorCode::equal_times)
                                 : (in_list ? ErrorCode::decreasing_times_in_list : ErrorCode::decreasing_times);
    return Error(Exit::data, code, std::move(values)).at(block.text_position(key));
  }

  Source<KeyBlock> blocks_;
  Duplicates duplicates_;
  std::optional<KeyLocation> before_;  ///< of the last key that remained
  KeyBlock held_;                      ///< that key, where the next one may replace it
  std::optional<KeyBlock> waiting_;
};

}  // namespace

Source<KeyBlock> without_gaps(Source<KeyBlock> blocks) {
  return [blocks = std::move(blocks), broken = false, any = false]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block) return std::nullopt;
    if (block->gaps.empty() && block->breaks.empty() && !broken) {
      any = any || !block->empty();
      broken = std::exchange(block->break_after, false) && any;
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
    broken = broken || block->break_after;
    if (!block->gaps.empty()) {
      KeyBlock rest = block->selected(kept);
      rest.take_block_data(*block);
      block = std::move(rest);
    }
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
