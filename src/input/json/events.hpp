// JSON text as events about key objects: a thin layer over nlohmann-json's events that knows where it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "error.hpp"
#include "input/input.hpp"
#include "input/json/cursor.hpp"
#include "input/json/splitter.hpp"
#include "text/text_position.hpp"

namespace tcb {

/// Hears about key objects, or any other objects on the same level. Returning false ends the parsing.
/// A value is a member's own, or an element of the array that the member is; what lies deeper is passed over.
class JsonEvents {
 public:
  explicit JsonEvents(const Chunk& chunk)
      : chunk_(chunk),
        reading_{chunk.text.data(), {}},
        counted_(chunk.text.data()),
        counted_place_{chunk.line, chunk.column} {}
  /// What stands beside keys.
  explicit JsonEvents(const JsonPart& part) : JsonEvents(part.chunk) { part_ = &part; }
  JsonEvents(const JsonEvents&) = delete;
  JsonEvents& operator=(const JsonEvents&) = delete;
  virtual ~JsonEvents() = default;

  /// Parses the chunk: an array of objects, or an object a line.
  /// Throws: Error (data) with its place, where the text is not JSON or holds something else than objects.
  void parse();

  /// Parses the chunk as one object, over as many lines as it has.
  void parse_object();

 protected:
  virtual bool on_key_start() { return true; }
  virtual bool on_key_end() { return true; }
  virtual bool on_member(const std::string& name) = 0;
  /// A number, as its nearest time, from which its nearest double follows.
  virtual bool on_number(const spline::Time<double>& value) = 0;
  /// A value that is no number, as it is shown in messages; strings without quotes.
  virtual bool on_other(std::string_view text) = 0;
  virtual bool on_array_end() { return true; }
  /// null in the place of a key. Returning false refuses it.
  virtual bool on_break() { return false; }
  /// A line of JSON Lines is no key. Returning false says it to the caller, returning true goes on in the next line.
  virtual bool on_bad_line(const Error&) { return false; }

  /// The number at hand as it is written, unless it is a whole number. Requires: it is being heard of.
  std::string_view decimal() const { return decimal_; }
  /// The value at hand that is no number is a string.
  bool is_quoted() const { return is_quoted_; }
  bool in_array() const { return depth_ == key_depth_ + 2 && is_array_; }
  /// Number of the array element at hand from 0; at the array's end, their count.
  std::size_t element() const { return element_; }
  /// Where the key at hand begins. Requires: calls come in the order of the text.
  LinePosition place_of_key();
  /// The place of the value that is being parsed.
  TextPosition here() const;
  /// An error at the value that is being parsed.
  Error error(const std::string& message) const;
  /// An error at the beginning of the key that is being parsed.
  Error key_error(const std::string& message) const;
  /// Throws: Error (data) at the value that is being parsed.
  [[noreturn]] void fail(const std::string& message) const;
  /// The number of the key at hand in its list.
  std::uint64_t key_number() const { return chunk_.first + keys_; }
  /// The key at hand, as in "curves[2].keys[17]".
  std::string key_path() const;
  /// The member at hand, as in "keys[17].position[1]".
  std::string path() const;

 private:
  struct Adapter;
  bool parse_line(const char* begin, const char* end);
  bool parse_range(const char* begin, const char* end);
  bool value(const spline::Time<double>* number, std::string_view text);
  bool open(bool object);
  bool close(bool object);
  TextPosition place_of(const char* where) const;
  [[noreturn]] void fail_at(const char* where, const std::string& message) const;

  const Chunk& chunk_;
  const JsonPart* part_ = nullptr;  ///< that the chunk is, where it is what stands beside keys
  std::string_view range_;          ///< what is being parsed of it,
  JsonReading reading_;             ///< and how far
  const char* key_ = nullptr;       ///< where the key at hand begins
  const char* counted_;             ///< here is
  LinePosition counted_place_;      ///< this place
  std::size_t key_depth_ = 0;       ///< how many brackets are around a key object
  std::size_t depth_ = 0;
  std::size_t keys_ = 0;
  bool has_breaks_ = false;
  std::size_t element_ = 0;
  bool is_quoted_ = false;
  bool is_array_ = false;  ///< the member at hand is an array, not an object
  std::string member_;
  std::string_view decimal_;
};

}  // namespace tcb
