// Labels: texts that keys carry through to the rows; a row has those of the key at its time or before it.
#include "output/labels.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tcb {
namespace {

/// The field that says which key a row is.
std::size_t key_field() {
  const auto known = fields();
  return static_cast<std::size_t>(std::ranges::find(known, "key", &Field::name) - known.begin());
}

/// Some columns of a row; none where there are none at all.
template <class T>
std::vector<T> columns(const std::vector<T>& cells, std::size_t row, std::size_t count) {
  if (cells.empty()) return {};
  const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(row);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

Source<KeyBlock> Labels::heard(const std::shared_ptr<Labels>& labels, Source<KeyBlock> blocks) {
  return [labels, blocks = std::move(blocks)] {
    std::optional<KeyBlock> block = blocks();
    if (block && !block->lines.empty()) labels->add(*block);
    return block;
  };
}

Source<LabelledBlock> Labels::joined(const std::shared_ptr<Labels>& labels, Source<SampleBlock> batches, RowEnd row_end,
                                     bool forget) {
  return
      [labels, batches = std::move(batches), row_end = std::move(row_end), forget]() -> std::optional<LabelledBlock> {
        std::optional<SampleBlock> batch = batches();
        if (!batch) return std::nullopt;
        LabelledBlock labelled{std::move(*batch), {}};
        for (const SampleBlock::Part& part : labelled.batch.parts) {
          if (forget) labels->forget_before(part.segment.number);
          // A single key is a segment without duration, and has no key at its end.
          const bool rests = part.segment.start == part.segment.end;
          labelled.ends.emplace_back(row_end(labels->of(part.segment.number)),
                                     row_end(labels->of(rests ? part.segment.number : part.segment.end_key)));
        }
        return labelled;
      };
}

void Labels::add(const KeyBlock& block) {
  const std::uint64_t next = kept_.empty() ? 0 : kept_.back().first_key + kept_.back().keys;
  const std::size_t per_key = block.texts.size() / block.lines.size();
  Kept kept{{}, next, block.lines.size()};
  for (std::size_t key = 0; key < block.lines.size(); ++key) {
    kept.texts.append(block.texts, key * per_key + first_, (key + 1) * per_key);
  }
  kept_.push_back(std::move(kept));
}

std::vector<std::string_view> Labels::of(std::uint64_t key) const {
  const auto after = std::ranges::upper_bound(kept_, key, {}, &Kept::first_key);
  const Kept& kept = *std::prev(after);
  const std::size_t per_key = kept.texts.size() / kept.keys;
  std::vector<std::string_view> texts;
  for (std::size_t i = 0; i < per_key; ++i) texts.push_back(kept.texts[(key - kept.first_key) * per_key + i]);
  return texts;
}

void Labels::forget_before(std::uint64_t key) {
  while (kept_.size() > 2 && kept_[2].first_key <= key) kept_.erase(kept_.begin() + 1);
}

std::string print_labelled(
    const LabelledBlock& labelled, const Evaluate& evaluate, std::span<const std::size_t> chosen,
    const std::function<void(std::string& out, const Table& row, const std::string& row_end, bool first)>& print) {
  std::vector<std::size_t> with_key(chosen.begin(), chosen.end());
  with_key.push_back(key_field());
  std::string out;
  bool first = labelled.batch.first;
  for (std::size_t i = 0; i < labelled.batch.parts.size(); ++i) {
    const SampleBlock::Part& part = labelled.batch.parts[i];
    const Table table = evaluate({labelled.batch.owner, {part}, false}, with_key);
    const std::size_t width = table.cells.size() / (part.last - part.first);
    for (std::size_t row = 0; row < table.cells.size(); row += width) {
      const Cell& key = table.cells[row + width - 1];
      const bool at_end = !is_empty(key) && key.hi == static_cast<double>(part.segment.end_key) &&
                          key.hi != static_cast<double>(part.segment.number);
      print(out, {columns(table.cells, row, width - 1), columns(table.texts, row, width - 1)},
            at_end ? labelled.ends[i].second : labelled.ends[i].first, first);
      first = false;
    }
  }
  return out;
}

}  // namespace tcb
