// Members of JSON keys: their meaning, by the names and the values in the first key.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members have the roles of
// columns of the same names, and "tcb":[t,c,b] is accepted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "read/input_options.hpp"
#include "read/json/splitter.hpp"
#include "schema/columns.hpp"
#include "schema/key_rules.hpp"
#include "schema/units.hpp"

namespace tcb {

/// The meaning of the members of key objects, as in the first one. Each is a cell, or an array of cells.
struct JsonColumns {
  struct Member {
    std::string name;
    bool array = false;
    std::size_t cell = 0;   ///< its first cell in `columns`
    std::size_t cells = 0;  ///< the number of its cells; 0: it is ignored
    bool required = false;
  };
  Columns columns;
  std::vector<Member> members;
  std::size_t found = 0;  ///< the number of cells of the first key; others may come in any key
  KeyRules rules;
  KeyUnits units;
};

/// The meaning of the members of the first key of a part. `channels` are names for the numbers of "position", if any.
/// Throws: Error (data).
JsonColumns find_members(const JsonPart& part, const InputOptions& options, const std::vector<std::string>& channels);

/// Gives the numbers of "position" these names. Throws: Error (data) if there are not as many.
void name_channels(JsonColumns& columns, const std::vector<std::string>& channels);

}  // namespace tcb
