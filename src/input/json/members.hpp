// What the members of JSON keys mean: columns by the names in the first key.
#pragma once

#include <string>
#include <vector>

#include "input/input.hpp"

namespace tcb {

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
  std::size_t found = 0;         ///< so many cells are those of the first key; others may come in any key
  spline::Tcb<double> tcb = {};  ///< of keys that carry none
  Missing missing = Missing::error;
  bool keeps_decimals = false;
};

/// The meaning of the members of the first key of a chunk. `channels` names the numbers of "position",
/// where the input says so. Throws: Error (data).
JsonColumns find_members(const Chunk& chunk, const InputOptions& options, const std::vector<std::string>& channels);

/// Gives the numbers of "position" these names. Throws: Error (data) where there are not as many.
void name_channels(JsonColumns& columns, const std::vector<std::string>& channels);

}  // namespace tcb
