// Velocities: the check of keys whose velocities are given, and keys from segments.
#pragma once

#include <string>
#include <vector>

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The same keys. Throws: Error (data) with the line of a key where a given velocity is missing, except before a
/// channel's first key and after its last; and about `equal_speed`, which would change them.
Source<KeyBlock> with_complete_velocities(Source<KeyBlock> blocks, std::vector<std::string> channels, bool equal_speed);

/// The keys of segments, whose ends are two keys each: where a segment begins at the end of the one before it, both are
/// one key, with the velocities of both. Throws: Error (data) with the line of a segment that does not begin there.
Source<KeyBlock> joined_segments(Source<KeyBlock> ends);

}  // namespace tcb
