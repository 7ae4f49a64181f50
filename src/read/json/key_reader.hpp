// Reader of JSON keys: from the members of key objects to keys.
#pragma once

#include "read/json/members.hpp"
#include "read/json/splitter.hpp"
#include "schema/key_block.hpp"

namespace tcb {

/// The keys of a part of whole key objects. A pure function.
/// Errors are among its faults, at the position of the value; at most ten.
KeyBlock parse_json(const JsonPart& part, const JsonColumns& columns);

}  // namespace tcb
