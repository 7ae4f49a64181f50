// Curves: which keys of an input make a curve, one curve after another.
#include "keys/curves.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "input/key_block.hpp"
#include "input/faults.hpp"

namespace tcb {
namespace {

/// The keys in order, without faults.
Source<KeyBlock> prepared(const Input& input, const CurveOptions& options, bool live) {
  Source<KeyBlock> blocks = input.keys;
  const bool by_text = !input.groups.empty() && !input.own_curves;
  if (options.sort && !input.timed) {
    throw Error(Exit::data,
                "--sort orders rows by time, and there is no time column; take it out, or name the column "
                "with --columns time=NAME");
  }
  if (options.duplicates != Duplicates::error && !input.timed) {
    throw Error(Exit::data,
                "--duplicates is about equal times, and there is no time column; take it out, or name the "
                "column with --columns time=NAME");
  }
  if (by_text || options.sort) {
    blocks = grouped(without_faults(std::move(blocks), false),
                     {by_text ? input.groups.size() : 0, options.sort, input.own_curves});
  }
  blocks = without_gaps(std::move(blocks));
  if (input.timed) blocks = in_order(std::move(blocks), options.duplicates);
  return without_faults(std::move(blocks), live);
}

}  // namespace

/// Cuts blocks of keys where curves begin.
class Curves::Cutter {
 public:
  Cutter(const Input& input, const CurveOptions& options, bool live)
      : blocks_(prepared(input, options, live)),
        may_break_(input.may_break || !input.groups.empty() || options.duplicates == Duplicates::break_curve),
        groups_(input.own_curves ? 0 : input.groups.size()),
        beside_keys_(std::make_shared<const CurveInfo>(input.curve_info)),
        own_curves_(input.own_curves) {}

  /// Passes over the rest of the curve at hand; whether there is another one.
  bool begin() {
    if (!first_ && !may_break_) return false;
    while (!first_ && more()) {
    }
    const bool any = fill();
    if (!any && !first_) return false;
    first_ = false;
    if (any && block_->curve_info != nullptr && at_ == 0) beside_keys_ = std::exchange(block_->curve_info, nullptr);
    started_ = true;
    return true;
  }

  /// The next keys of the curve at hand.
  std::optional<KeyBlock> more() {
    if (!fill() || begins_curve()) return std::nullopt;
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

  std::vector<std::string> group() {
    if (own_curves_) return {beside_keys_->id};
    std::vector<std::string> texts;
    for (std::size_t i = 0; block_ && i < groups_; ++i) {
      const std::size_t per_key = block_->texts.size() / block_->size();
      texts.emplace_back(block_->texts[at_ * per_key + i]);
    }
    return texts;
  }

  std::shared_ptr<const CurveInfo> curve_info() const { return beside_keys_; }
  std::uint64_t skipped() const { return skipped_; }

 private:
  /// The next key begins another curve.
  bool begins_curve() const {
    if (started_) return false;
    return (at_ == 0 && block_->curve_info != nullptr) || std::ranges::binary_search(block_->breaks, at_);
  }

  /// Whether there is a next key.
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
  std::shared_ptr<const CurveInfo> beside_keys_;
  bool own_curves_;
  std::optional<KeyBlock> block_;  ///< with the next key of this number:
  std::size_t at_ = 0;
  std::uint64_t skipped_ = 0;
  bool first_ = true;     ///< no curve was begun
  bool started_ = false;  ///< the next key is the first of the curve at hand
};

Curves::Curves(const Input& input, const CurveOptions& options, bool live)
    : cutter_(std::make_shared<Cutter>(input, options, live)) {}

std::optional<CurveKeys> Curves::next() {
  if (!cutter_->begin()) return std::nullopt;
  return CurveKeys{cutter_->group(), cutter_->curve_info(), [cutter = cutter_] { return cutter->more(); }};
}

std::uint64_t Curves::skipped() const { return cutter_->skipped(); }

}  // namespace tcb
