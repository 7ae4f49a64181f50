// Labels: texts that keys carry through to the rows; a row has those of the key at its time or before it.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "curve/rows.hpp"
#include "input/input.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// Rows with what ends them.
struct LabelledBlock {
  SampleBlock batch;
  /// Of each part: what ends a row on its segment, and one at the segment's last key.
  std::vector<std::pair<std::string, std::string>> ends;
};

/// The labels of a curve's keys, as far as rows still need them.
class Labels {
 public:
  using RowEnd = std::function<std::string(std::span<const std::string_view> labels)>;

  /// Of each key's texts those from the given one on are labels.
  explicit Labels(std::size_t first) : first_(first) {}

  /// The same keys; their labels are kept as they go by.
  static Source<KeyBlock> heard(const std::shared_ptr<Labels>& labels, Source<KeyBlock> blocks);

  /// The batches with what ends their rows. `forget`: they go forward, and no earlier key is asked for again.
  static Source<LabelledBlock> joined(const std::shared_ptr<Labels>& labels, Source<SampleBlock> batches,
                                      RowEnd row_end, bool forget);

 private:
  void add(const KeyBlock& block);
  std::vector<std::string_view> of(std::uint64_t key) const;
  /// The first keys stay, to which a closed curve comes back.
  void forget_before(std::uint64_t key);

  struct Kept {
    Texts texts;
    std::uint64_t first_key, keys;
  };
  std::size_t first_;
  std::deque<Kept> kept_;
};

/// The rows of a batch, printed one by one: `print` makes text of a row's cells, given what ends it.
/// A pure function.
std::string print_labelled(
    const LabelledBlock& labelled, const Evaluate& evaluate, std::span<const std::size_t> chosen,
    const std::function<void(std::string& out, const Table& row, const std::string& row_end, bool first)>& print);

}  // namespace tcb
