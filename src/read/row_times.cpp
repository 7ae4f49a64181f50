// Row times: keys without times get those of rows at a rate.
#include "read/row_times.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tcb {
namespace {

class RowTimes {
 public:
  RowTimes(const TimeSchema& time, std::size_t groups, bool skips_gaps)
      : step_(Rational(1) / *time.frame_rate), start_(time.start), groups_(groups), skips_gaps_(skips_gaps) {}

  KeyBlock operator()(KeyBlock block) {
    std::vector<Rational> times;
    for (std::size_t key = 0; key < block.size(); ++key) {
      const bool is_broken = std::exchange(is_broken_, false);
      if (is_broken || block.begins_curve(key)) rows_.clear();
      times.push_back(start_ + step_ * row(block, key));
      block.keys.times.push_back(nearest_time(times.back()));
    }
    is_broken_ = is_broken_ || block.breaks.at_end;
    block.rewrite_decimals([&](std::size_t key, std::size_t number, std::string_view text) {
      return number == NumberOfKey::time ? ratio_text(times[key]) : std::string(text);
    });
    return skips_gaps_ && !block.breaks.gaps.empty() ? without_gaps(std::move(block)) : std::move(block);
  }

 private:
  /// In a list without groups the number of the key, as null counts.
  std::uint64_t row(const KeyBlock& block, std::size_t key) {
    const std::vector<std::uint64_t>& numbers = block.text_positions.numbers;
    return groups_ == 0 && !numbers.empty() ? numbers[key] : rows_[group(block, key)]++;
  }

  std::vector<std::string> group(const KeyBlock& block, std::size_t key) const {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < groups_; ++i) texts.emplace_back(block.text(key, i));
    return texts;
  }

  static KeyBlock without_gaps(KeyBlock block) {
    std::vector<std::size_t> kept, breaks;
    bool is_broken = false;
    for (std::size_t key = 0; key < block.size(); ++key) {
      is_broken = is_broken || block.has_break_before(key);
      if (block.has_gap_at(key)) continue;
      if (std::exchange(is_broken, false)) breaks.push_back(kept.size());
      kept.push_back(key);
    }
    block.faults.skipped += block.breaks.gaps.size();
    KeyBlock rest = block.selected(kept);
    rest.take_block_data(block);
    rest.breaks.before = std::move(breaks);
    rest.breaks.at_end = rest.breaks.at_end || is_broken;
    return rest;
  }

  Rational step_, start_;
  std::size_t groups_;
  bool skips_gaps_;
  std::map<std::vector<std::string>, std::uint64_t> rows_;  ///< of each group so far
  bool is_broken_ = false;                                  ///< a break follows the last key
};

}  // namespace

Source<KeyBlock> with_row_times(Source<KeyBlock> blocks, const TimeSchema& time, std::size_t groups, bool skips_gaps) {
  return mapped(std::move(blocks), RowTimes(time, groups, skips_gaps));
}

}  // namespace tcb
