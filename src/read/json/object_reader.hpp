// Object reader: JSON text as events about key objects, with the text position and the path of each value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/json/json_input.hpp"
#include "read/json/scanner.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// Receives events about key objects, or any other objects on the same level. Returning false ends the parsing.
/// A value is a member's own, or an element of the array that the member is; deeper values are ignored. The members of
/// an object "tcb" or "rotation" are members of the key, as "tcb.x".
class JsonObjectReader {
 public:
  explicit JsonObjectReader(const Chunk& chunk)
      : chunk_(chunk),
        reading_{chunk.text.data(), {}},
        counted_(chunk.text.data()),
        counted_position_{chunk.line, chunk.column} {}
  /// The object around keys.
  explicit JsonObjectReader(const JsonPart& part) : JsonObjectReader(part.chunk) { part_ = &part; }
  JsonObjectReader(const JsonObjectReader&) = delete;
  JsonObjectReader& operator=(const JsonObjectReader&) = delete;
  virtual ~JsonObjectReader() = default;

  /// Parses the chunk: an array of objects, or an object per line.
  /// Throws: Error (data) with its position, if the text is not JSON or holds something else than objects.
  void parse();

  /// Parses the chunk as one object, over as many lines as it has.
  void parse_object();

 protected:
  virtual bool on_key_start() { return true; }
  virtual bool on_key_end() { return true; }
  virtual bool on_member(const std::string& name) = 0;
  /// A number, as the time nearest to it, whose high part is the nearest double.
  virtual bool on_number(const spline::Time<double>& value) = 0;
  /// A string without its quotes, or true or false.
  virtual bool on_text(std::string_view text) = 0;
  virtual bool on_null() = 0;
  /// An array or object as a value.
  virtual bool on_nested() = 0;
  /// The current member is an object whose members follow as members of the key.
  virtual void on_members() {}
  virtual bool on_array_end() { return true; }
  /// A number or a text deep in a value.
  virtual void on_deep_value(bool /*is_number*/) {}
  /// null in the place of a key; false: an error.
  virtual bool on_break() { return false; }
  /// A line of JSON Lines is not a key. True: the next line follows; false: the error is thrown.
  virtual bool on_bad_line(const Error&) { return false; }

  /// The current number as written, unless it is a whole number. Requires: in on_number().
  std::string_view decimal() const { return decimal_; }
  /// The current text is a string. Requires: in on_text().
  bool is_quoted() const { return is_quoted_; }
  bool in_array() const { return depth_ == member_depth() + 1 && is_array_; }
  /// The index of the current array element; at the array's end, their number.
  std::size_t element() const { return element_; }
  /// Where the current key begins. Requires: calls come in the order of the text.
  LinePosition key_position();
  /// The position of the current value.
  TextPosition value_position() const;
  /// An error at the current value; its first value is path().
  Error value_error(ErrorCode code, std::vector<ErrorValue> values = {}) const;
  /// An error at the beginning of the current key.
  Error key_error(ErrorCode code, std::vector<ErrorValue> values = {}) const;
  /// The number of the current key in its list.
  std::uint64_t key_number() const { return chunk_.first + keys_; }
  /// The current key, as in "curves[2].keys[17]".
  std::string key_path() const;
  /// The current member, as in "keys[17].position[1]".
  std::string path() const;

 private:
  struct Adapter;
  bool parse_line(const char* begin, const char* end);
  bool parse_range(const char* begin, const char* end);
  template <class F>
  bool value(F event);
  std::size_t member_depth() const { return key_depth_ + outer_depth_; }
  bool is_deep() const { return depth_ != member_depth() && !in_array(); }  ///< the current value is in another one
  bool for_key() const { return depth_ <= key_depth_; }  ///< the current value is in the place of a key
  [[noreturn]] void refuse_value(ErrorCode code, std::vector<ErrorValue> values = {}) const;
  bool open(bool object);
  bool close(bool object);
  [[noreturn]] void refuse_syntax() const;
  [[noreturn]] void refuse_large_number() const;
  std::string_view read_text() const;
  TextPosition position_of(const char* where) const;
  [[noreturn]] void fail_at(const char* where, ErrorCode code, std::vector<ErrorValue> values = {}) const;

  const Chunk& chunk_;
  const JsonPart* part_ = nullptr;  ///< that the chunk is, where it is the object around keys
  std::string_view range_;          ///< the text that is being parsed,
  JsonReading reading_;             ///< and how far it was read
  const char* key_ = nullptr;       ///< where the current key begins
  const char* counted_;             ///< a place in the text,
  LinePosition counted_position_;   ///< and its position
  std::size_t key_depth_ = 0;       ///< the number of brackets around a key object
  std::size_t depth_ = 0;
  std::size_t keys_ = 0;
  bool has_breaks_ = false;
  std::size_t element_ = 0;
  bool is_quoted_ = false;
  bool is_array_ = false;  ///< the current member is an array, not an object
  std::string member_;
  std::string outer_;            ///< the member whose members are being read, with a point; empty: they are the key's
  std::size_t outer_depth_ = 1;  ///< 2 in an outer member
  std::string_view decimal_;
};

}  // namespace tcb
