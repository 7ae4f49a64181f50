// Keys with rotations for tests, in one block.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

using Numbers = std::vector<double>;

/// Keys with a position x and four numbers of a rotation, on lines from 2.
inline KeyBlock block_of(const std::vector<Numbers>& rotations) {
  KeyBlock block;
  block.keys.channels = 5;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    block.keys.times.emplace_back(static_cast<double>(i));
    block.keys.positions.push_back(7);
    block.keys.positions.insert(block.keys.positions.end(), rotations[i].begin(), rotations[i].end());
    block.text_positions.lines.push_back(i + 2);
  }
  return block;
}

inline Source<KeyBlock> source_of(const KeyBlock& block) {
  return [block, done = false]() mutable -> std::optional<KeyBlock> {
    if (std::exchange(done, true)) return std::nullopt;
    return block;
  };
}

}  // namespace tcb
