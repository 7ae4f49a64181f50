// Grouping: keys of several curves in any order of rows, sorted apart; and keys brought into the order of time.
#include "keys/group.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <memory>
#include <numeric>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "input/key_block.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_keys = 4096;  ///< of a block

/// Where a key is kept, and which curve it is on.
struct Kept {
  std::uint32_t block = 0, key = 0;
  std::uint32_t curve = 0;
  bool breaks = false;  ///< the curve breaks off before it
  bool gap = false;
};

/// Numbers for texts, in order of first appearance: a hash table of their numbers, and the texts in one string.
class Numbers {
 public:
  std::uint32_t number(const std::string& text) {
    if (texts_.size() * 2 >= slots_.size()) grow();
    std::uint32_t& slot = slots_[find(text)];
    if (slot == none) {
      slot = static_cast<std::uint32_t>(texts_.size());
      texts_.add(text);
    }
    return slot;
  }
  std::size_t size() const { return texts_.size(); }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  std::size_t find(std::string_view text) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = std::hash<std::string_view>()(text) & mask;
    while (slots_[at] != none && texts_[slots_[at]] != text) at = (at + 1) & mask;
    return at;
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), none);
    for (std::size_t i = 0; i < texts_.size(); ++i) slots_[find(texts_[i])] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> slots_;
  Texts texts_;
};

/// All keys of an input.
class Store {
 public:
  explicit Store(const Grouping& grouping) : grouping_(grouping) {}

  void add(KeyBlock block) {
    const std::size_t texts = block.empty() ? 0 : block.texts.size() / block.size();
    if (block.curve_info != nullptr) beside_keys_.push_back(std::exchange(block.curve_info, nullptr));
    if (blocks_.empty() || blocks_.back().size() + block.size() > most_keys) blocks_.emplace_back();
    KeyBlock& target = blocks_.back();
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (block.has_break_before(i)) ++section_;
      const bool gap = block.has_gap_at(i);
      if (gap && grouping_.sort && std::isnan(block.keys.times[i].hi)) continue;  // it has no place among the others
      const std::uint32_t curve = curve_of(block, i, texts);
      const bool breaks = sections_[curve] != section_;
      sections_[curve] = section_;
      kept_.push_back({static_cast<std::uint32_t>(blocks_.size() - 1),
                       static_cast<std::uint32_t>(target.size() + i), curve, breaks, gap});
    }
    if (block.break_after) ++section_;
    skipped_ += block.skipped;
    if (target.empty()) {
      target = std::move(block);
    } else {
      target.append(block, 0, block.size());
    }
  }

  /// Brings the keys into their order.
  void arrange() {
    std::vector<std::size_t> ends(sections_.size() + 1);
    for (const Kept& kept : kept_) ++ends[kept.curve + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    starts_ = ends;
    std::vector<Kept> arranged(kept_.size());
    for (const Kept& kept : kept_) arranged[ends[kept.curve]++] = kept;
    kept_ = std::move(arranged);
    if (grouping_.sort) sort();
  }

  /// The next keys in that order.
  std::optional<KeyBlock> next() {
    if (next_ == kept_.size()) return std::nullopt;
    KeyBlock block;
    block.skipped = std::exchange(skipped_, 0);
    const std::size_t end = std::min(kept_.size(), next_ + most_keys);
    for (; next_ < end; ++next_) {
      const Kept& kept = kept_[next_];
      const bool begins = next_ == starts_[kept.curve];
      if (begins && grouping_.own_curves) {
        if (!block.empty()) break;
        block.curve_info = beside_keys_[kept.curve];
      }
      if ((begins && next_ > 0) || (kept.breaks && !begins)) block.breaks.push_back(block.size());
      if (kept.gap) block.gaps.push_back(block.size());
      block.append(blocks_[kept.block], kept.key, kept.key + 1);
    }
    return block;
  }

 private:
  std::uint32_t curve_of(const KeyBlock& block, std::size_t key, std::size_t texts) {
    if (grouping_.own_curves) {
      sections_.resize(beside_keys_.size(), section_);
      return static_cast<std::uint32_t>(beside_keys_.size() - 1);
    }
    group_.clear();
    for (std::size_t i = 0; i < grouping_.groups; ++i) {
      group_ += block.texts[key * texts + i];
      group_ += '\0';
    }
    const std::uint32_t number = numbers_.number(group_);
    if (number == sections_.size()) sections_.push_back(section_);
    return number;
  }

  /// Sorts the keys of each curve, from break to break.
  void sort() {
    const auto time = [&](const Kept& kept) { return blocks_[kept.block].keys.times[kept.key]; };
    for (auto first = kept_.begin(); first != kept_.end();) {
      const auto last = std::find_if(first + 1, kept_.end(),
                                     [&](const Kept& kept) { return kept.curve != first->curve || kept.breaks; });
      const bool breaks = std::exchange(first->breaks, false);
      std::ranges::stable_sort(first, last, {}, time);
      first->breaks = breaks;
      first = last;
    }
  }

  Grouping grouping_;
  std::deque<KeyBlock> blocks_;
  std::vector<Kept> kept_;
  std::vector<std::size_t> starts_;      ///< where each curve begins
  std::vector<std::uint32_t> sections_;  ///< of each curve: the part of the input in which its last key stands
  std::vector<std::shared_ptr<const CurveInfo>> beside_keys_;  ///< of each curve, where each has its own
  Numbers numbers_;
  std::string group_;
  std::uint32_t section_ = 0;
  std::uint64_t skipped_ = 0;
  std::size_t next_ = 0;
};

}  // namespace

Source<KeyBlock> grouped(Source<KeyBlock> blocks, const Grouping& grouping) {
  return [blocks = std::move(blocks), grouping, store = std::shared_ptr<Store>()]() mutable {
    if (store == nullptr) {
      store = std::make_shared<Store>(grouping);
      while (std::optional<KeyBlock> block = blocks()) store->add(std::move(*block));
      store->arrange();
    }
    return store->next();
  };
}

}  // namespace tcb
