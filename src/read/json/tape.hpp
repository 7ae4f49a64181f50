// Tape: a JSON text as a list of its values, each with its place in the text.
//
// Source: RFC 8259. nlohmann-json parses the text through its events.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "read/json/splitter.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// A value of JSON on a tape, or the name of a member, which the member's value follows.
struct JsonNode {
  enum class Kind : std::uint8_t { null, boolean, number, string, name, array, object };
  std::uint32_t begin = 0, end = 0;  ///< its text, with quotes or brackets
  std::uint32_t next = 0;            ///< the index of the node after it and all that it holds
  Kind kind = Kind::null;
  bool has_escapes = false;  ///< of a string or a name

  bool is_nested() const { return kind == Kind::array || kind == Kind::object; }
};

/// The values of a part of a text. A value is the index of its node; what an array or an object holds follows it.
class JsonTape {
 public:
  using Kind = JsonNode::Kind;

  /// Parses the part: a text, or the first of several values, which read_next() continues.
  /// Requires: `part` outlives the tape. Throws: Error (data) at what is not JSON, or is nested too deeply.
  /// Throws: Error (data) for more memory than is allowed, in bytes.
  explicit JsonTape(const JsonPart& part, std::uint64_t max_memory = default_max_memory);

  /// Parses the next one of several values, in place of the last one or after it; false at the end.
  /// Throws: Error (data); then the next call continues after the faulty value.
  bool read_next(bool keeps_last = false);

  const JsonNode& operator[](std::size_t value) const { return nodes_[value]; }
  Kind kind(std::size_t value) const { return nodes_[value].kind; }
  std::size_t size() const { return nodes_.size(); }

  /// Calls f(name, value) for each member of an object, until it returns false.
  template <class F>
  void for_each_member(std::size_t object, F f) const {
    for (std::size_t name = object + 1; name < nodes_[object].next; name = nodes_[name + 1].next) {
      if (!f(name, name + 1)) return;
    }
  }
  /// Calls f(value) for each element of an array, until it returns false.
  template <class F>
  void for_each_element(std::size_t array, F f) const {
    for (std::size_t value = array + 1; value < nodes_[array].next; value = nodes_[value].next) {
      if (!f(value)) return;
    }
  }
  /// The number of elements of an array, or of members of an object.
  std::size_t count(std::size_t value) const;
  /// The values of the elements of an array.
  std::vector<std::uint32_t> elements(std::size_t array) const;
  /// The value of the member with a name; nothing if there is none. Throws: Error (data) if there are two.
  std::optional<std::size_t> member(std::size_t object, std::string_view name) const;

  /// The text of a value as it is written.
  std::string_view written(std::size_t value) const {
    return std::string_view(part_.chunk.text).substr(nodes_[value].begin, nodes_[value].end - nodes_[value].begin);
  }
  /// The characters of a string or a name.
  std::string_view text(std::size_t value) const {
    const JsonNode& node = nodes_[value];
    if (node.has_escapes) return unescaped_.at(node.begin);
    return std::string_view(part_.chunk.text).substr(node.begin + 1, node.end - node.begin - 2);
  }

  /// The path of a value within another one, as in ".points[2].x".
  std::string path(std::size_t within, std::size_t value) const;

  TextPosition position(std::size_t value) const { return position_at(nodes_[value].begin); }
  /// The position of a byte of the text.
  TextPosition position_at(std::size_t byte) const;

  const JsonPart& part() const { return part_; }

 private:
  class Events;

  void parse(std::size_t first, bool is_one);

  void require_memory() const;

  const JsonPart& part_;
  std::uint64_t max_memory_;
  std::vector<JsonNode> nodes_;
  std::unordered_map<std::uint32_t, std::string> unescaped_;  ///< by the places of strings with escapes
  std::size_t end_ = 0;                                       ///< of the last value that was read
};

/// A number as the program prints it, whole below 2^64; its decimal is valid.
std::string json_number_text(std::string_view decimal);

}  // namespace tcb
