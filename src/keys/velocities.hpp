// Velocities: the check of keys whose velocities are given.
#pragma once

#include <string>
#include <vector>

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Passes keys on. Throws: Error (data) with the line of a key where a given velocity is missing, except before a
/// channel's first key and after its last; and about `equal_speed`, which would change them.
Source<KeyBlock> with_complete_velocities(Source<KeyBlock> blocks, std::vector<std::string> channels, bool equal_speed);

}  // namespace tcb
