// Row times: keys without times get those of rows at a rate.
#pragma once

#include <cstddef>

#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Sets the times of keys that have none: row i of a curve, and of a group in it, is at start + i / frame_rate, with i
/// counted from 0. Gaps count, too. `groups`: how many texts of a key tell its group. `skips_gaps`: gaps are removed,
/// as rows that are skipped, and do not break curves. Requires: time.counts_rows.
Source<KeyBlock> with_row_times(Source<KeyBlock> blocks, const TimeSchema& time, std::size_t groups, bool skips_gaps);

}  // namespace tcb
