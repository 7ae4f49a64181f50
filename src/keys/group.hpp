// Grouping: keys of several curves in any order of rows, sorted apart; and keys brought into the order of time.
#pragma once

#include <cstddef>

#include "input/input.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// How keys are sorted.
struct Grouping {
  std::size_t groups = 0;   ///< so many of a key's first texts say which curve it is on
  bool sort = false;        ///< by time, those of equal times as they came
  bool own_curves = false;  ///< blocks say where curves begin
};

/// The keys of one curve after another, in order of first appearance, a break before each. All of them are kept from
/// the first call on: an input's last row may belong to its first curve.
/// Shapes: some hundred bytes a curve, and a key's numbers with 16 bytes more.
Source<KeyBlock> grouped(Source<KeyBlock> blocks, const Grouping& grouping);

}  // namespace tcb
