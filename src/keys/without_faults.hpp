// Keys without faults: the faults of an input, gathered from its blocks into one error.
#pragma once

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Keys without faults. After a fault, the rest of the input is read for more, up to ten; a live input, which may not
/// end soon, is read no further. Throws: Error (data) with all faults that were found.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live);

}  // namespace tcb
