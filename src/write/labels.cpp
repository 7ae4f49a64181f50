// Labels: the texts of keys that are repeated after the rows of their segments.
#include "write/labels.hpp"

#include <algorithm>
#include <iterator>

namespace tcb {
namespace {

/// The first `count` cells from `begin` on; none if there are none at all.
template <class T>
std::vector<T> range(const std::vector<T>& cells, std::size_t begin, std::size_t count) {
  if (cells.empty()) return {};
  const auto first = cells.begin() + static_cast<std::ptrdiff_t>(begin);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

Source<KeyBlock> Labels::observe(const std::shared_ptr<Labels>& labels, Source<KeyBlock> blocks) {
  return mapped(std::move(blocks), [labels](KeyBlock block) {
    if (!block.empty()) labels->add(block);
    return block;
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

std::string print_labelled(
    const LabelledBlock& block, const Evaluate& evaluate, std::span<const std::size_t> chosen,
    const std::function<void(std::string& out, const Table& row, const std::string& row_end, bool first)>& print) {
  std::vector<std::size_t> with_key(chosen.begin(), chosen.end());
  with_key.push_back(field_of("key"));
  std::string out;
  bool first = block.samples.first;
  for (std::size_t i = 0; i < block.samples.parts.size(); ++i) {
    const SampleBlock::Part& part = block.samples.parts[i];
    const Table table = evaluate({block.samples.owner, {part}, false}, with_key);
    const std::size_t width = table.cells.size() / (part.last - part.first);
    for (std::size_t row = 0; row < table.cells.size(); row += width) {
      const Cell& key = table.cells[row + width - 1];
      const bool at_end = !is_empty(key) && key.hi == static_cast<double>(part.segment.end_key) &&
                          key.hi != static_cast<double>(part.segment.number);
      print(out, {range(table.cells, row, width - 1), range(table.texts, row, width - 1)},
            at_end ? block.ends[i].second : block.ends[i].first, first);
      first = false;
    }
  }
  return out;
}

}  // namespace tcb
