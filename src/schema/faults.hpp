// Faults: errors of keys, gathered from the blocks of an input into one error.
#pragma once

#include <cstddef>

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The largest number of faults of an input that are reported.
inline constexpr std::size_t most_faults = 10;

/// Keys without faults. After a fault, the rest of the input is read for more, up to ten; a live input, which may not
/// end soon, is read no further. Throws: Error (data) with all faults that were found.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live);

}  // namespace tcb
