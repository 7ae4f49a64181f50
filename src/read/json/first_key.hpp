// First key of JSON: its members, and the kinds of their values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/json/splitter.hpp"

namespace tcb {

/// A member of the first key.
struct FoundMember {
  std::string name;
  bool array = false;          ///< it is an array of numbers
  bool text = false;           ///< it is one text, or true or false
  bool nested = false;         ///< it is an object, or an array with arrays or objects,
  bool deep_numbers = false;   ///< with numbers in them
  bool empty = true;           ///< it is [] or {}
  std::size_t numbers = 0;     ///< the count of its numbers, also missing ones
  std::string value = "";      ///< the text, if it is a number or a time in words
  std::string path = "";       ///< as in "keys[0].x"
  TextPosition position = {};  ///< of its name
};

struct FirstKey {
  std::vector<FoundMember> members;
  TextPosition position;  ///< where the key begins
};

/// Whether a member is an array [T,C,B]: of the key, or of one channel as "tcb.x".
inline bool holds_tcb(std::string_view name) { return name == "tcb" || name.starts_with("tcb."); }

/// Whether a member is the array "rotation", or a member of an object "rotation", as "rotation.x".
inline bool is_of_rotation(const FoundMember& member) {
  return member.name.starts_with("rotation.") || (member.name == "rotation" && (member.array || member.nested));
}

/// Whether the members of rotations are the four numbers of a quaternion: an array, or an object of x, y, z and w.
bool has_quaternion(const std::vector<FoundMember>& members);

/// Throws: Error (data) for members of rotations that are something else, but for arrays of one or two numbers.
void require_quaternion(const std::vector<FoundMember>& members);

/// The columns of a member of a quaternion.
std::vector<std::string> quaternion_columns(const FoundMember& member);

/// Reads the first key of a part. A member with a text there holds numbers if one of the first keys has a number, or
/// all have signs of missing ones. Throws: Error (data).
FirstKey read_first_key(const JsonPart& part, const std::vector<RoleRequest>& requests,
                        const std::vector<std::string>& signs);

}  // namespace tcb
