// JSON: the shapes that an input may have, and the curves in it.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members mean
// what columns of the same names mean, and "tcb":[t,c,b] is accepted.
// Source: RFC 8259; parsed by nlohmann-json through its events, so that no document is ever held.
#pragma once

#include "input/input.hpp"

namespace tcb {

/// Opens JSON of any shape: an array of keys, an object with "keys", one with "curves", or JSON Lines. Keys with
/// settings beside them are kept until these are known.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Input open_json(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
