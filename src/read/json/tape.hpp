// Tape: a JSON text as a list of its values, each with its place in the text.
//
// Source: RFC 8259. nlohmann-json parses the text through its events.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "error.hpp"
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

/// Goes through the elements of an array, or the names of the members of an object.
class JsonIterator {
 public:
  using value_type = std::size_t;
  using difference_type = std::ptrdiff_t;

  JsonIterator() = default;
  JsonIterator(const JsonNode* nodes, std::size_t at, bool is_name) : nodes_(nodes), at_(at), is_name_(is_name) {}
  std::size_t operator*() const { return at_; }
  JsonIterator& operator++() { return at_ = nodes_[at_ + (is_name_ ? 1 : 0)].next, *this; }
  JsonIterator operator++(int) { return std::exchange(*this, ++JsonIterator(*this)); }
  bool operator==(const JsonIterator& other) const { return at_ == other.at_; }

 private:
  const JsonNode* nodes_ = nullptr;
  std::size_t at_ = 0;
  bool is_name_ = false;
};

struct JsonRange {
  JsonIterator first, last;

  JsonIterator begin() const { return first; }
  JsonIterator end() const { return last; }
  bool empty() const { return first == last; }
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

  /// The elements of an array, or the names of the members of an object; nothing in another value.
  JsonRange inside(std::size_t value) const {
    const bool is_object = kind(value) == Kind::object;
    return {JsonIterator(nodes_.data(), value + 1, is_object),
            JsonIterator(nodes_.data(), nodes_[value].next, is_object)};
  }
  /// The value of the member with this name; an element itself.
  std::size_t value_of(std::size_t inner) const { return kind(inner) == Kind::name ? inner + 1 : inner; }
  /// The number of elements of an array, or of members of an object.
  std::size_t count(std::size_t value) const { return static_cast<std::size_t>(std::ranges::distance(inside(value))); }
  std::vector<std::uint32_t> elements(std::size_t array) const {
    std::vector<std::uint32_t> values;
    for (const std::size_t value : inside(array)) values.push_back(static_cast<std::uint32_t>(value));
    return values;
  }
  /// The value of the member with a name; nothing if there is none. Throws: Error (data) if there are two.
  std::optional<std::size_t> member(std::size_t object, std::string_view name) const;

  /// Whether a value is one of a kind, or holds one.
  bool holds(std::size_t value, Kind wanted) const {
    return std::any_of(nodes_.begin() + static_cast<std::ptrdiff_t>(value), nodes_.begin() + nodes_[value].next,
                       [&](const JsonNode& node) { return node.kind == wanted; });
  }

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

  /// The characters of a string or a name; other values as they are written.
  std::string_view shown(std::size_t value) const {
    return kind(value) == Kind::string || kind(value) == Kind::name ? text(value) : written(value);
  }

  /// The path of a value within another one, as in ".points[2].x".
  std::string path(std::size_t within, std::size_t value) const;

  TextPosition position(std::size_t value) const { return position_at(nodes_[value].begin); }
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

// Faults that are found in several places.
Error too_large(std::string_view decimal);
Error twice_in(std::string_view holder);
Error no_key_at_comma();

/// A number as the program prints it, whole below 2^64; its decimal is valid.
std::string json_number_text(std::string_view decimal);

}  // namespace tcb
