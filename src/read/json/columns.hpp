// Columns of JSON: what the members of keys mean, by the names and the values in the first key.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members have the roles of
// columns of the same names, and "tcb":[t,c,b] is accepted. A number deeper in a key is a column whose name is its
// path, as in pose.orientation.x and values[0].
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
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

    bool is_nested() const { return !inner.empty(); }
  };
  Columns columns;
  std::vector<Member> members;
  std::size_t all_members = 0;              ///< also the inner ones
  std::vector<std::string> row_names = {};  ///< of the cells of records that are arrays
  std::size_t found = 0;                    ///< the number of cells of the first key; others may come in any key
  KeyRules rules;
  KeyUnits units;
  std::uint64_t max_memory = default_max_memory;  ///< of numbers that are missing, in bytes
};

/// Finds members by their names. Requires: they do not change.
class MemberFinder {
 public:
  using Member = JsonColumns::Member;

  /// The member with a name, of the kind of a value. `expected`: its place, if all keys have the same order.
  const Member* find(const std::vector<Member>& members, std::string_view name, JsonNode::Kind kind,
                     std::size_t& expected) {
    const auto is_it = [&](const Member& member) {
      return member.name == name && member.is_nested() == (kind == JsonNode::Kind::object);
    };
    if (expected < members.size() && is_it(members[expected])) return &members[expected++];
    auto& by_name = by_name_[&members];
    if (by_name.empty()) {
      for (const Member& member : members) by_name.emplace(member.name, &member);
    }
    const auto [first, last] = by_name.equal_range(name);
    if (first == last) return nullptr;
    const auto found = std::find_if(first, last, [&](const auto& named) { return is_it(*named.second); });
    const Member* const member = (found == last ? first : found)->second;
    expected = static_cast<std::size_t>(member - members.data()) + 1;
    return member;
  }

 private:
  std::unordered_map<const std::vector<Member>*, std::unordered_multimap<std::string_view, const Member*>> by_name_;
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
