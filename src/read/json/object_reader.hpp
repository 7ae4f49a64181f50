// Object reader: JSON text as events about key objects, with the text position and the path of each value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "error.hpp"
#include "read/json/errors.hpp"
#include "read/json/json_text.hpp"
#include "read/json/splitter.hpp"
#include "tcb/spline/key.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// Receives events about key objects, or any other objects on the same level. Returning false ends the parsing.
/// A value is a member's own, or an element of the array that the member is; deeper values are ignored. The members of
/// an object "tcb" or "rotation" are members of the key, as "tcb.x". nlohmann-json parses the text through its events,
/// so no document is kept in memory.
class JsonObjectReader {
 public:
  /// Requires: `part` outlives it.
  explicit JsonObjectReader(const JsonPart& part)
      : part_(part), counted_(part.chunk.text.data()), counted_position_{part.chunk.line, part.chunk.column} {}
  JsonObjectReader(const JsonObjectReader&) = delete;
  JsonObjectReader& operator=(const JsonObjectReader&) = delete;
  virtual ~JsonObjectReader() = default;

  /// Parses the part: the elements of an array, or an object per line, or one object.
  /// Throws: Error (data) with its position, if the text is not JSON or holds something else than objects.
  void parse();

 protected:
  virtual bool on_key_start() { return true; }
  virtual bool on_key_end() { return true; }
  virtual bool on_member(const std::string& name) = 0;
  /// The name that on_member() received last. A virtual function, so that most names need not be copied.
  virtual std::string_view member() const = 0;
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
  /// A number, a text, null, an array or an object deep in a value.
  virtual void on_deep_value(bool /*is_number*/) {}
  /// null in the place of a key; false: an error.
  virtual bool on_break() { return false; }
  /// A line of JSON Lines is not a key. True: the next line follows; false: the error is thrown.
  virtual bool on_bad_line(const Error&) { return false; }

  /// The current number as written, unless it is a whole number below 2^64. Requires: in on_number().
  std::string_view decimal() const { return decimal_; }
  /// The current text is a string. Requires: in on_text().
  bool is_quoted() const { return is_quoted_; }
  bool in_array() const { return depth_ == member_depth() + 1 && is_array_; }
  /// The index of the current array element; at the array's end, their number.
  std::size_t element() const { return element_; }
  /// Where the current key begins, and the name of the current member; each counts from the place of the call before.
  /// Requires: calls come in the order of the text.
  LinePosition key_position() { return count_to(key_); }
  LinePosition member_position() { return count_to(value_begin()); }
  /// The position of the current value, or of the name of the current member; at the end of an array, of its bracket.
  TextPosition value_position() const { return position_of(value_begin()); }
  /// An error about the current value.
  Error at_value(const Error& error) const { return error.about(path()).at(value_position()); }
  /// An error at the beginning of the current key.
  Error at_key(const Error& error) const { return error.at(position_of(key_)); }
  /// The number of the current key in its list.
  std::uint64_t key_number() const { return part_.chunk.first + keys_; }
  /// The current member, as in "curves[2].keys[17].position[1]".
  std::string path() const;

 private:
  struct Adapter;
  /// What the parser has passed on last.
  enum class Last { nothing, opening, name, value };

  bool parse_line(std::string_view line);
  bool parse_text(const JsonText::Pieces& pieces);
  template <class F>
  bool value(F event);
  std::size_t member_depth() const { return key_depth_ + outer_depth_; }
  bool is_deep() const { return depth_ != member_depth() && !in_array(); }  ///< the current value is in another one
  bool is_for_key() const { return depth_ <= key_depth_; }  ///< the current value is in the place of a key
  bool open(bool object);
  bool close(bool object);
  [[noreturn]] void refuse_syntax(std::size_t bytes) const;
  json::Expected expected(bool is_separated) const;
  [[noreturn]] void refuse_for_key(std::string_view what) const;
  const char* value_begin() const;
  LinePosition count_to(const char* where);
  TextPosition position_of(const char* where) const;

  const JsonPart& part_;
  JsonText text_;                  ///< that is being parsed
  const char* passed_ = nullptr;   ///< the end of what the parser has passed on,
  Last last_ = Last::nothing;      ///< and what that was
  const char* key_ = nullptr;      ///< where the current key begins
  const char* array_ = nullptr;    ///< where the current member begins, if it is an array
  bool is_array_end_ = false;      ///< in on_array_end()
  const char* counted_;            ///< a place in the text,
  LinePosition counted_position_;  ///< and its position
  std::size_t key_depth_ = 0;      ///< the number of brackets around a key object
  std::size_t depth_ = 0;
  std::size_t keys_ = 0;  ///< whole keys, and nulls in their place in a list
  std::size_t element_ = 0;
  bool is_quoted_ = false;
  bool is_array_ = false;        ///< the current member is an array, not an object
  std::string outer_;            ///< the member whose members are being read, with a point
  std::size_t outer_depth_ = 1;  ///< 2 in an outer member
  std::string_view decimal_;
};

}  // namespace tcb
