// Key objects of JSON: from events to keys.
#pragma once

#include "input/input.hpp"
#include "input/json/members.hpp"

namespace tcb {

/// The keys of a chunk of whole key objects, an array of them or one a line. A pure function.
/// What is wrong stands in its faults, placed at the value; ten at most.
KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns);

}  // namespace tcb
