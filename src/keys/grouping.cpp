// Grouping: keys of several curves with their rows in any order, split into curves, and keys sorted by time.
#include "keys/order.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include "error.hpp"
#include "numbers/decimal_time.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_keys = 4096;  ///< of a block

/// Where a key is stored, and its curve.
struct KeyReference {
  std::uint32_t block = 0, key = 0;
  std::uint32_t curve = 0;
  bool breaks = false;  ///< there is a break before it
  bool gap = false;
};

/// All keys of an input: first add() for each block, then arrange(), then next() for each block of the result.
class Groups {
 public:
  explicit Groups(const Grouping& grouping) : grouping_(grouping) {}

  void add(KeyBlock block) {
    if (block.curve_info != nullptr) curve_infos_.push_back(std::exchange(block.curve_info, nullptr));
    const bool fits =
        !blocks_.empty() && blocks_.back().size() + block.size() <= most_keys && blocks_.back().has_shape_of(block);
    if (!fits) blocks_.emplace_back();
    KeyBlock& target = blocks_.back();
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (block.has_break_before(i)) ++section_;
      const bool gap = block.has_gap_at(i);
      if (gap && grouping_.sort && std::isnan(block.keys.times[i].hi)) continue;  // it cannot be sorted
      const std::uint32_t curve = curve_of(block, i);
      const bool breaks = std::exchange(sections_[curve], section_) != section_;
      keys_.push_back({static_cast<std::uint32_t>(blocks_.size() - 1), static_cast<std::uint32_t>(target.size() + i),
                       curve, breaks, gap});
    }
    if (block.breaks.at_end) ++section_;
    skipped_ += block.faults.skipped;
    if (target.empty()) {
      target = std::move(block);
    } else {
      target.append(block, 0, block.size());
    }
  }

  void arrange() {
    std::vector<std::size_t> ends(sections_.size() + 1);
    for (const KeyReference& key : keys_) ++ends[key.curve + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    starts_ = ends;
    std::vector<KeyReference> arranged(keys_.size());
    for (const KeyReference& key : keys_) arranged[ends[key.curve]++] = key;
    keys_ = std::move(arranged);
    if (grouping_.sort) sort();
  }

  std::optional<KeyBlock> next() {
    if (next_ == keys_.size()) return std::nullopt;
    KeyBlock block;
    block.faults.skipped = std::exchange(skipped_, 0);
    const std::size_t end = std::min(keys_.size(), next_ + most_keys);
    for (; next_ < end; ++next_) {
      const KeyReference& key = keys_[next_];
      if (!block.has_shape_of(blocks_[key.block])) break;
      const bool begins = next_ == starts_[key.curve];
      if (begins && grouping_.own_curves) {
        if (!block.empty()) break;
        block.curve_info = curve_infos_[key.curve];
      }
      if ((begins && next_ > 0) || (key.breaks && !begins)) block.breaks.before.push_back(block.size());
      if (key.gap) block.breaks.gaps.push_back(block.size());
      block.append(blocks_[key.block], key.key, key.key + 1);
    }
    return block;
  }

 private:
  std::uint32_t curve_of(const KeyBlock& block, std::size_t key) {
    if (grouping_.own_curves) {
      sections_.resize(curve_infos_.size(), section_);
      return static_cast<std::uint32_t>(curve_infos_.size() - 1);
    }
    group_.clear();
    for (std::size_t i = 0; i < grouping_.groups; ++i) {
      group_ += block.text(key, i);
      group_ += '\0';
    }
    const auto [found, is_new] = numbers_.try_emplace(group_, static_cast<std::uint32_t>(numbers_.size()));
    if (is_new) sections_.push_back(section_);
    return found->second;
  }

  /// Sorts the keys of each curve, from break to break.
  void sort() {
    const auto time = [&](const KeyReference& key) { return blocks_[key.block].keys.times[key.key]; };
    for (auto first = keys_.begin(); first != keys_.end();) {
      const auto last = std::find_if(first + 1, keys_.end(),
                                     [&](const KeyReference& key) { return key.curve != first->curve || key.breaks; });
      const bool breaks = std::exchange(first->breaks, false);
      std::ranges::stable_sort(first, last, is_earlier, time);
      first->breaks = breaks;
      first = last;
    }
  }

  Grouping grouping_;
  std::deque<KeyBlock> blocks_;
  std::vector<KeyReference> keys_;
  std::vector<std::size_t> starts_;  ///< index of the first key of each curve
  std::vector<std::uint32_t>
      sections_;  ///< of each curve: the section of the input, from break to break, of its last key
  std::vector<std::shared_ptr<const CurveInfo>> curve_infos_;  ///< of each curve, where each has its own
  std::unordered_map<std::string, std::uint32_t> numbers_;     ///< of curves, by the texts of their groups
  std::string group_;                                          ///< memory to reuse
  std::uint32_t section_ = 0;
  std::uint64_t skipped_ = 0;
  std::size_t next_ = 0;
};

}  // namespace

Source<KeyBlock> grouped(Source<KeyBlock> blocks, const Grouping& grouping) {
  return [blocks = std::move(blocks), grouping, groups = std::shared_ptr<Groups>()]() mutable {
    if (groups == nullptr) {
      groups = std::make_shared<Groups>(grouping);
      while (std::optional<KeyBlock> block = blocks()) groups->add(std::move(*block));
      groups->arrange();
    }
    return groups->next();
  };
}

}  // namespace tcb
