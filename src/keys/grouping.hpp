// Grouping: keys of several curves with their rows in any order, split into curves, and keys sorted by time.
#pragma once

#include <cstddef>
#include <vector>

#include "schema/columns.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// How grouped() arranges keys.
struct Grouping {
  std::size_t groups = 0;        ///< number of texts, from a key's first, that identify its curve
  bool sort = false;             ///< by time; the sort is stable
  bool own_curves = false;       ///< a curve begins with each block that has curve_info
  std::vector<Mark> marks = {};  ///< columns that may distinguish curves, by which no sort mixes them
};

/// The keys of one curve after another, in order of first appearance, with a break before each. The first call reads
/// the source to its end: the last row of an input may belong to its first curve.
/// Memory: 100 to 200 bytes per curve, and 16 bytes per key besides its numbers.
Source<KeyBlock> grouped(Source<KeyBlock> blocks, const Grouping& grouping);

}  // namespace tcb
