// Joined segments: keys from records that are segments.
#pragma once

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The keys of segments, whose ends are two keys each: where a segment begins at the end of the one before it, both are
/// one key, with the velocities of both. Throws: Error (data) with the line of a segment that does not begin there.
Source<KeyBlock> joined_segments(Source<KeyBlock> ends);

}  // namespace tcb
