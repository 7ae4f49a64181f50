// JSON text: the values of a text of JSON, each with its place, and a text cut into whole values.
//
// Source: RFC 8259. Differs: NaN is null, as Python writes it; several values may follow one another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "read/memory_use.hpp"
#include "read/text_bytes.hpp"
#include "stream/source.hpp"
#include "text/utf8.hpp"

namespace tcb {

class JsonRange;

/// The records, or the lines, by which columns are found.
inline constexpr std::size_t most_first_records = 100;

/// The values of a text as a list of nodes: an array or an object is followed by what it holds, and the value of a
/// member by its name. A value is the index of its node.
class Json {
 public:
  enum class Kind : std::uint8_t { null, boolean, number, string, name, array, object };

  /// The root, which node 0 is, holds all values of the text. `begin`: where the text is in the file. `nodes`: so many
  /// at most. Throws: Error (data) for what is no JSON, and where it is nested too deeply.
  Json(std::string text, LinePosition begin, std::size_t nodes);

  Kind kind(std::size_t value) const { return static_cast<Kind>(nodes_[value].kind); }
  bool is(std::size_t value, Kind wanted) const { return kind(value) == wanted; }
  bool is_nested(std::size_t value) const { return kind(value) >= Kind::array; }
  bool is_name(std::size_t value) const { return is(value, Kind::name); }
  /// The node behind a value and all that it holds.
  std::size_t next(std::size_t value) const { return value + 1 + (is_nested(value) ? nodes_[value].extent : 0); }
  std::size_t size() const { return nodes_.size(); }

  JsonRange inside(std::size_t value) const;
  std::size_t count(std::size_t value) const;
  std::vector<std::uint32_t> values(std::size_t value) const;
  bool is_empty(std::size_t value) const { return next(value) == value + 1; }
  /// The first of the values in an array or object. Requires: it is not empty.
  std::size_t first(std::size_t value) const { return value + (is(value, Kind::object) ? 2 : 1); }

  /// The name of the value of a member; empty for an element.
  std::string_view name(std::size_t value) const {
    return value > 0 && is_name(value - 1) ? text(value - 1) : std::string_view();
  }
  bool is_member(std::size_t value) const { return value > 0 && is_name(value - 1); }
  /// The value of the first member with this name; nothing in another value than an object.
  std::optional<std::size_t> member(std::size_t object, std::string_view wanted) const;
  /// Whether an array or object is not empty, and all values in it are of this kind.
  bool has_only(std::size_t value, Kind wanted) const;
  /// Whether a value is of this kind, or holds one.
  bool holds(std::size_t value, Kind wanted) const;

  /// The characters of a string or a name; a number, a word or an array as it is written.
  std::string_view text(std::size_t value) const;
  /// A value as it is written, with quotes.
  std::string_view written(std::size_t value) const;
  /// A value as a message shows it.
  std::string shown(std::size_t value) const;

  /// The path of a value within another one, as in points[2].x.
  std::string path(std::size_t within, std::size_t value) const;

  std::size_t offset(std::size_t value) const { return nodes_[value].begin; }
  TextPosition position(std::size_t value) const;
  TextPosition position_at(std::size_t byte) const;

  /// A byte with its place.
  struct Mark {
    std::size_t byte = 0;
    LinePosition at = {};
  };
  /// That of a byte, from the last one that is known before it, if it is near.
  Mark mark_at(std::size_t byte, const Mark& last) const;

 private:
  class Events;
  struct Node {
    std::uint32_t begin;                  ///< of its text
    std::uint32_t kind : 3, extent : 29;  ///< the size of that; the number of nodes in an array or an object
  };
  std::size_t end_of(std::size_t value) const;
  void set_marks(LinePosition begin);

  std::string text_;
  std::vector<Mark> marks_;  ///< at even distances
  std::vector<Node> nodes_;
  /// A string with escapes, and where its characters begin among those of all.
  struct Unescaped {
    std::uint32_t node, begin;
  };
  std::vector<Unescaped> unescaped_;
  std::string characters_;
};

/// Goes through the values in an array or an object.
class JsonIterator {
 public:
  using value_type = std::uint32_t;
  using difference_type = std::ptrdiff_t;

  JsonIterator() = default;
  JsonIterator(const Json& json, std::size_t node, std::size_t end, bool has_names)
      : json_(&json), at_(node + (has_names && node < end ? 1 : 0)), end_(end), has_names_(has_names) {}
  std::uint32_t operator*() const { return static_cast<std::uint32_t>(at_); }
  JsonIterator& operator++() {
    at_ = json_->next(at_);
    if (has_names_ && at_ < end_) ++at_;
    return *this;
  }
  JsonIterator operator++(int) { return std::exchange(*this, ++JsonIterator(*this)); }
  bool operator==(const JsonIterator& other) const { return at_ == other.at_; }

 private:
  const Json* json_ = nullptr;
  std::size_t at_ = 0, end_ = 0;
  bool has_names_ = false;
};

/// The elements of an array, or the values of the members of an object.
class JsonRange {
 public:
  JsonRange(const Json& json, std::size_t value)
      : first_(json, value + 1, json.next(value), json.is(value, Json::Kind::object)),
        last_(json, json.next(value), json.next(value), false) {}
  JsonIterator begin() const { return first_; }
  JsonIterator end() const { return last_; }

 private:
  JsonIterator first_, last_;
};

inline JsonRange Json::inside(std::size_t value) const { return {*this, value}; }

/// A text of whole values.
struct JsonBlock {
  std::string text;
  LinePosition begin = {};
  std::size_t nodes = 0;    ///< at most, of the values in it
  std::size_t escapes = 0;  ///< in strings
  std::size_t lines = 0;    ///< that end outside of values
  std::size_t values = 0;   ///< the arrays and objects that no other one holds
};

/// Cuts an input at the ends of lines that are outside of values: each line of JSON Lines alone, and any other text not
/// at all.
class JsonBlocks {
 public:
  /// `max_memory`: of a block with its nodes, in bytes.
  JsonBlocks(Source<std::string> bytes, std::uint64_t max_memory) : bytes_(std::move(bytes)), most_(max_memory) {}

  /// The next block: of the first lines, or the rest if there are fewer; later, of all lines that were read. Nothing at
  /// the end. Throws: Error (data) for a block that needs more memory than is allowed.
  std::optional<JsonBlock> next();
  /// The whole input as one block. Requires: nothing was taken.
  std::optional<JsonBlock> whole();
  /// Whether nothing but blanks is left.
  bool is_at_end();

 private:
  bool read_more();
  void scan(std::size_t most_lines);
  void fill(std::size_t lines, std::size_t most_lines);
  std::optional<JsonBlock> rest();
  JsonBlock cut();
  [[noreturn]] void refuse_size();

  TextBytes bytes_;
  std::uint64_t most_;
  JsonBlock left_;                               ///< what was read and not yet cut off
  bool is_read_ = false;                         ///< the input is read to its end
  bool is_first_ = true;                         ///< no block was taken
  std::size_t at_ = 0;                           ///< scanned up to here
  std::size_t depth_ = 0;                        ///< of brackets there
  bool in_string_ = false, has_value_ = false;   ///< there, and the line has a value
  std::size_t end_ = 0;                          ///< behind the last line that ends outside of values
  std::size_t end_nodes_ = 0, end_escapes_ = 0;  ///< up to there
};

/// A number as the program prints it, whole below 2^64; its decimal is valid.
std::string json_number_text(std::string_view decimal);

// Faults that are found in several places.
Error too_large(std::string_view decimal);
Error twice_in(std::string_view holder);

}  // namespace tcb
