// Sparse channels: where keys lack some positions, each channel goes through its own keys, and all are joined again.
#pragma once

#include <string>
#include <vector>

#include "curve/segment_blocks.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// The segments between the keys. In a channel the curve runs through the keys that have a position there, by the
/// rules and with the neighbours of those alone; before the first and after the last of them it rests.
/// Promises: a channel without a missing position has the cubics that it would have alone, bit for bit.
/// Throws: Error (data) for a channel without any position.
Source<SegmentBlock> sparse_stretches(const LinkedKeys& linked, const Rules& rules, bool measured,
                                      const std::vector<std::string>& channels);

}  // namespace tcb
