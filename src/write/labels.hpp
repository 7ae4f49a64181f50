// Labels: the texts of keys that are repeated after the rows of their segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sample/rows.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Samples with the texts after their rows.
struct LabelledBlock {
  SampleBlock samples;
  /// Of each part: the text after a row on its segment, and after one at the segment's last key.
  std::vector<std::pair<std::string, std::string>> ends;
};

/// The labels of a curve's keys, kept as long as rows may need them.
class Labels {
 public:
  /// Makes the text after a row from its labels.
  using RowEnd = std::function<std::string(std::span<const std::string_view> labels)>;

  /// `first`: index of the first label among the texts of a key.
  explicit Labels(std::size_t first) : first_(first) {}

  /// Passes keys on, and stores their labels.
  static Source<KeyBlock> observe(const std::shared_ptr<Labels>& labels, Source<KeyBlock> blocks);

  /// The samples with the texts after their rows. `forget`: segments come in order, so that labels of earlier keys
  /// are not needed again.
  static Source<LabelledBlock> attach(const std::shared_ptr<Labels>& labels, Source<SampleBlock> blocks, RowEnd row_end,
                                      bool forget);

 private:
  void add(const KeyBlock& block);
  std::vector<std::string_view> of(std::uint64_t key) const;
  /// Keeps the first keys, to which a closed curve returns.
  void forget_before(std::uint64_t key);

  struct BlockLabels {
    Texts texts;
    std::uint64_t first_key, keys;
  };
  std::size_t first_;
  std::deque<BlockLabels> blocks_;
};

}  // namespace tcb
