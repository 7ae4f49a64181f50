// FBX nodes: the text of an FBX file as a tree.
//
// A node is a name, a list of values, and children in braces. An array is a node with the value *COUNT and one child
// "a" with its numbers. Comments run from a semicolon to the end of the line.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "read/memory_use.hpp"
#include "read/written_number.hpp"

namespace tcb {

struct FbxNode {
  std::string_view name = {};
  std::string_view text = {};  ///< of its values, with commas between them
  std::uint64_t line = 0;
  std::vector<FbxNode> children = {};

  /// The first child of this name, or nullptr.
  const FbxNode* find(std::string_view child) const;
  /// Throws: Error (data) if it has no such child.
  const FbxNode& child(std::string_view child) const;
};

/// The values of a node, one after the other.
class FbxValues {
 public:
  /// Of a node, or of its array. Throws: Error (data) where the count of the array is no number; so does next() where
  /// it is not the number of values.
  explicit FbxValues(const FbxNode& node);

  bool at_end() const { return rest_.empty(); }
  std::uint64_t line() const { return line_; }  ///< of the next value
  /// The next value, a text without its quotes. Throws: Error (data) at the end.
  std::string_view next();
  /// The next value as a number. Throws: Error (data) for another one.
  WrittenNumber next_number();
  std::int64_t next_integer();

 private:
  void skip_blanks();
  void require_count() const;

  std::string_view rest_;
  std::uint64_t line_;
  std::optional<std::uint64_t> left_ = {};  ///< how many values of an array are left
};

/// The nodes of a file, as the children of one without a name; they refer to the text. Throws: Error (data).
FbxNode parse_fbx(std::string_view text, MemoryUse& memory);

}  // namespace tcb
