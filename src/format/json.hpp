// JSON: from the text of key objects to keys.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members mean
// what columns of the same names mean, and "tcb":[t,c,b] is accepted.
// Source: RFC 8259; parsed by nlohmann-json through its events, so that no document is ever held.
#pragma once

#include "format/input.hpp"
#include "format/json_columns.hpp"

namespace tcb::format {

/// The keys of a chunk of whole key objects, an array of them or one a line. A pure function.
/// Throws: Error (data), placed at the value.
KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns, const spline::Tcb<double>& tcb);

/// Opens JSON of any shape: an array of keys, an object with "keys", or JSON Lines.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Input open_json(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb::format
