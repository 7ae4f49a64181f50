// Labels: the texts of keys that are repeated after the rows of their segments.
#include "write/labels.hpp"

#include <algorithm>
#include <iterator>

namespace tcb {

Source<KeyBlock> Labels::observe(const std::shared_ptr<Labels>& labels, Source<KeyBlock> blocks) {
  return observed(std::move(blocks), [labels](const KeyBlock& block) {
    if (!block.empty()) labels->add(block);
  });
}

Source<LabelledBlock> Labels::attach(const std::shared_ptr<Labels>& labels, Source<SampleBlock> blocks, RowEnd row_end,
                                     bool forget) {
  return mapped(std::move(blocks), [labels, row_end = std::move(row_end), forget](SampleBlock samples) {
    LabelledBlock labelled{std::move(samples), {}};
    for (const SampleBlock::Part& part : labelled.samples.parts) {
      const CurveSegment& segment = part.segment;
      if (forget) labels->forget_before(segment.number);
      // A single key is a segment without duration, and has no key at its end.
      const bool is_single = segment.start == segment.end;
      labelled.ends.emplace_back(row_end(labels->of(segment.number)),
                                 row_end(labels->of(is_single ? segment.number : segment.end_key)));
    }
    return labelled;
  });
}

void Labels::add(const KeyBlock& block) {
  const std::uint64_t next = blocks_.empty() ? 0 : blocks_.back().first_key + blocks_.back().keys;
  const std::size_t per_key = block.texts_per_key();
  BlockLabels added{{}, next, block.size()};
  for (std::size_t key = 0; key < block.size(); ++key) {
    added.texts.append(block.texts, key * per_key + first_, (key + 1) * per_key);
  }
  blocks_.push_back(std::move(added));
}

std::vector<std::string_view> Labels::of(std::uint64_t key) const {
  const auto after = std::ranges::upper_bound(blocks_, key, {}, &BlockLabels::first_key);
  const BlockLabels& block = *std::prev(after);
  const std::size_t per_key = block.texts.size() / block.keys;
  std::vector<std::string_view> texts;
  for (std::size_t i = 0; i < per_key; ++i) texts.push_back(block.texts[(key - block.first_key) * per_key + i]);
  return texts;
}

void Labels::forget_before(std::uint64_t key) {
  while (blocks_.size() > 2 && blocks_[2].first_key <= key) blocks_.erase(blocks_.begin() + 1);
}

}  // namespace tcb
