// Curves: the keys of an input split into curves, one after another.
#include "keys/curves.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "input/input.hpp"

namespace tcb {
namespace {

void require_times(const CurveOptions& options) {
  if (options.sort) throw Error(Exit::data, ErrorCode::sort_without_times).about(Option::sort);
  if (options.duplicates != Duplicates::error) {
    throw Error(Exit::data, ErrorCode::duplicates_without_times).about(Option::duplicates);
  }
}

/// The keys in order, without faults.
Source<KeyBlock> arranged(const Input& input, const CurveOptions& options, bool live) {
  Source<KeyBlock> blocks = input.keys;
  const bool by_text = !input.groups.empty() && !input.own_curves;
  if (!input.timed) require_times(options);
  if (by_text || options.sort) {
    blocks = grouped(without_faults(std::move(blocks), false),
                     {by_text ? input.groups.size() : 0, options.sort, input.own_curves});
  }
  blocks = without_gaps(std::move(blocks));
  if (input.timed) blocks = in_order(std::move(blocks), options.duplicates);
  return without_faults(std::move(blocks), live);
}

}  // namespace

/// Splits blocks of keys where curves begin.
class Curves::Splitter {
 public:
  Splitter(const Input& input, const CurveOptions& options, bool live)
      : blocks_(arranged(input, options, live)),
        may_break_(input.may_break || !input.groups.empty() || options.duplicates == Duplicates::break_curve),
        groups_(input.own_curves ? 0 : input.groups.size()),
        curve_info_(std::make_shared<const CurveInfo>(input.curve_info)),
        own_curves_(input.own_curves) {}

  /// Passes over the rest of the current curve; whether there is another one.
  bool begin() {
    if (!first_ && !may_break_) return false;
    while (!first_ && next_keys()) {
    }
    const bool any = fill();
    if (!any && !first_) return false;
    first_ = false;
    if (any && block_->curve_info != nullptr && at_ == 0) curve_info_ = std::exchange(block_->curve_info, nullptr);
    started_ = true;
    return true;
  }

  /// The next keys of the current curve.
  std::optional<KeyBlock> next_keys() {
    if (!fill() || (!started_ && block_->begins_curve(at_))) return std::nullopt;
    started_ = false;
    const auto next = std::ranges::upper_bound(block_->breaks, at_);
    const std::size_t end = next == block_->breaks.end() ? block_->size() : *next;
    if (at_ == 0 && end == block_->size()) {
      std::optional<KeyBlock> whole = std::exchange(block_, std::nullopt);
      whole->breaks.clear();
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

 private:
  /// Reads blocks until there is a next key; whether there is one.
  bool fill() {
    while (!block_ || at_ == block_->size()) {
      block_ = blocks_();
      at_ = 0;
      if (!block_) return false;
      skipped_ += block_->skipped;
    }
    return true;
  }

  Source<KeyBlock> blocks_;
  bool may_break_;
  std::size_t groups_;
  std::shared_ptr<const CurveInfo> curve_info_;
  bool own_curves_;
  std::optional<KeyBlock> block_;  ///< holds the next key
  std::size_t at_ = 0;             ///< its index
  std::uint64_t skipped_ = 0;
  bool first_ = true;     ///< no curve has begun
  bool started_ = false;  ///< the next key is the first of the current curve
};

Curves::Curves(const Input& input, const CurveOptions& options, bool live)
    : splitter_(std::make_shared<Splitter>(input, options, live)) {}

std::optional<CurveKeys> Curves::next() {
  if (!splitter_->begin()) return std::nullopt;
  return CurveKeys{splitter_->group(), splitter_->curve_info(),
                   [splitter = splitter_] { return splitter->next_keys(); }};
}

std::uint64_t Curves::skipped() const { return splitter_->skipped(); }

}  // namespace tcb
