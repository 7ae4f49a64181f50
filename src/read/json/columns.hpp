// Columns of JSON: what the members of keys mean, by the names and the values in the first key.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members have the roles of
// columns of the same names, and "tcb":[t,c,b] is accepted. A number deeper in a key is a column whose name is its
// path, as in pose.orientation.x and values[0].
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "read/input_options.hpp"
#include "read/json/tables.hpp"
#include "schema/columns.hpp"
#include "schema/key_rules.hpp"
#include "schema/units.hpp"

namespace tcb {

/// The meaning of the members of keys, as in the first one.
struct JsonColumns {
  struct Member {
    std::string name;        ///< in the object that it is a member of
    std::string title = {};  ///< the name of its column
    bool array = false;
    std::size_t cell = 0;   ///< its first cell in `columns`
    std::size_t cells = 0;  ///< the number of its cells; 0: it is ignored
    bool required = false;
    std::size_t number = 0;          ///< among all members
    bool is_whole = false;           ///< all numbers in it have cells
    std::vector<Member> inner = {};  ///< the members of an object, or the elements of an array, that have cells
    std::multimap<std::string, std::size_t, std::less<>> places = {};  ///< of the inner ones, by their names

    bool is_nested() const { return !inner.empty(); }
    /// The inner member with a name, of the kind of a value if there are two; null: there is none.
    const Member* find(std::string_view name, JsonNode::Kind kind) const;
    Member& add(Member inner_one);
  };
  Columns columns;
  Member key;                               ///< whose inner ones are the members of a key
  std::size_t all_members = 0;              ///< also the inner ones
  std::vector<std::string> row_names = {};  ///< of the cells of records that are arrays
  std::size_t found = 0;                    ///< the number of cells of the first key; others may come in any key
  KeyRules rules;
  KeyUnits units;
  std::uint64_t max_memory = default_max_memory;  ///< of numbers that are missing, in bytes
};

/// The memory of a number that a record does not have, where it is skipped and all keys are kept.
inline constexpr std::uint64_t bytes_of_missing_number = 96;

/// The meaning of the members of the first record. A member with a text there holds numbers if one of the first records
/// has a number, or all have signs of missing ones. `channels` are names for the numbers of "position", if any.
/// Throws: Error (data).
JsonColumns find_members(const JsonTable& records, const InputOptions& options,
                         const std::vector<std::string>& channels);

/// Gives the numbers of "position" these names. Throws: Error (data) if there are not as many.
void name_channels(JsonColumns& columns, const std::vector<std::string>& channels);

}  // namespace tcb
