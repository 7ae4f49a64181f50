// JSON: from the text of key objects to keys.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members mean
// what columns of the same names mean, and "tcb":[t,c,b] is accepted.
// Source: RFC 8259; parsed by nlohmann-json through its events, so that no document is ever held.
#pragma once

#include <string>
#include <vector>

#include "format/input.hpp"

namespace tcb::format {

/// What the members of key objects mean, taken from the first one. A member that is an array of
/// numbers has a cell for each of them.
struct JsonColumns {
  struct Member {
    std::string name;
    bool array = false;
    std::size_t cell = 0;   ///< its first cell in `columns`
    std::size_t cells = 0;  ///< how many it has; 0: it is passed over
    bool required = false;
  };
  Columns columns;
  std::vector<Member> members;
};

/// The meaning of the members of the first key of a chunk. `channels` names the numbers of "position",
/// where the input says so. Throws: Error (data).
JsonColumns find_members(const Chunk& chunk, const std::vector<RoleRequest>& roles,
                         const std::vector<std::string>& channels);

/// The keys of a chunk of whole key objects, an array of them or one a line. A pure function.
/// Throws: Error (data), placed at the value.
KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns, const spline::Tcb<double>& tcb);

/// Opens JSON of any shape: an array of keys, an object with "keys", or JSON Lines.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Input open_json(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb::format
