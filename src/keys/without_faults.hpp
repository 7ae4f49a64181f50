// Keys without faults: the faults of an input, gathered from its blocks into one error.
#pragma once

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Passes keys on until one has a fault; then reads on to collect up to ten faults, unless the input is live, and
/// throws an Error (data) with all of them.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live);

}  // namespace tcb
