// Curves: the keys of an input, arranged and split into curves.
#include "keys/curves.hpp"

#include <algorithm>
#include <utility>

#include "keys/angles.hpp"
#include "keys/errors.hpp"
#include "keys/grouping.hpp"
#include "keys/joined_segments.hpp"
#include "keys/without_faults.hpp"

namespace tcb {
namespace {

void require_times(const CurveOptions& options) {
  if (options.sort) throw sort_without_times();
  if (options.duplicates != Duplicates::error) throw duplicates_without_times();
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
  if (traits.are_segments && options.sort) throw sort_of_segments();
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
  if (is_ordered) blocks = in_order(std::move(blocks), options.duplicates, {traits.marks, traits.channels});
  return without_faults(std::move(blocks), live);
}

}  // namespace

/// Splits blocks of keys where curves begin.
class Curves::Splitter {
 public:
  Splitter(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live)
      : angles_(schema),
        blocks_(angles_.observe(arranged(schema, keys, options, live, midnights_))),
        may_break_(keys.traits.may_break || !schema.groups.empty() || options.duplicates == Duplicates::break_curve),
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
    if (any && block_->curve_info != nullptr && at_ == 0) curve_info_ = std::exchange(block_->curve_info, nullptr);
    started_ = true;
    return true;
  }

  /// The next keys of the current curve.
  std::optional<KeyBlock> next_keys() {
    if (!fill() || (!started_ && block_->begins_curve(at_))) return std::nullopt;
    started_ = false;
    const auto next = std::ranges::upper_bound(block_->breaks.before, at_);
    const std::size_t end = next == block_->breaks.before.end() ? block_->size() : *next;
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
  std::vector<NamedAngle> likely_angles() const { return angles_.found(); }

 private:
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
  std::size_t groups_;
  std::shared_ptr<const CurveInfo> curve_info_;
  bool own_curves_;
  std::optional<KeyBlock> block_;  ///< holds the next key
  std::size_t at_ = 0;             ///< its index
  std::uint64_t skipped_ = 0;
  bool first_ = true;     ///< no curve has begun
  bool started_ = false;  ///< the next key is the first of the current curve
};

Curves::Curves(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live)
    : splitter_(std::make_shared<Splitter>(schema, keys, options, live)) {}

std::optional<CurveKeys> Curves::next() {
  if (!splitter_->begin()) return std::nullopt;
  return CurveKeys{splitter_->group(), splitter_->curve_info(),
                   [splitter = splitter_] { return splitter->next_keys(); }};
}

std::uint64_t Curves::skipped() const { return splitter_->skipped(); }
std::vector<NamedAngle> Curves::likely_angles() const { return splitter_->likely_angles(); }
std::uint64_t Curves::midnights() const { return splitter_->midnights(); }

}  // namespace tcb
