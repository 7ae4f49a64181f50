// JSON splitter: a JSON text is cut into whole records, by its strings and brackets alone.
//
// The text may be an array of keys, an object with an array "keys" among its members, an object with an array
// "curves" of such objects, or one key after another (JSON Lines), each an object or a row of numbers. "rows", which
// the program writes, is read as "keys". A text of another shape is one part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "read/memory_use.hpp"
#include "read/text_bytes.hpp"
#include "stream/source.hpp"

namespace tcb {

enum class JsonShape : std::uint8_t;  // in read/input.hpp

inline bool is_json_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// At most, of the first part of a list, by which the meaning of their members is found.
inline constexpr std::uint64_t most_first_records = 100;

struct JsonPart {
  enum class Kind {
    list,    ///< an array of whole records of an array, of which there may be more
    values,  ///< records one after the other
    object,  ///< around an array that was cut out, whose place is `seam`
    whole,   ///< the whole text, of any shape
  };
  Kind kind = Kind::list;
  Chunk chunk;
  std::size_t seam = std::string::npos;  ///< what follows this place of the text comes from
  LinePosition after = {};               ///< this position
};

/// Cuts a text in the memory of a few records. Every byte is in a part or is checked here, so parsing the parts finds
/// every fault.
class JsonSplitter {
 public:
  /// `max_memory`: of a text that is kept as a whole, in bytes.
  explicit JsonSplitter(Source<std::string> bytes, std::uint64_t max_memory = default_max_memory)
      : bytes_(std::move(bytes)), max_memory_(max_memory) {}

  /// The next part: keys, or the object around the keys before. Nothing at the end.
  /// Throws: Error (data) for text after an array, for an array that is not closed, for a record that is too long, and
  /// for more memory than is allowed.
  std::optional<JsonPart> next();

  /// The whole text, of which one part was taken. Requires: that was the first one, a list.
  JsonPart whole(JsonPart first);

  /// Requires: next() was called.
  JsonShape shape() const;

  /// The current object up to its keys; empty outside of one.
  const Chunk& before_keys() const { return before_; }

 private:
  /// What the text continues with.
  enum class Stage { start, object, curves, list, values, after_list, unclosed, rest, end };

  bool read_more();
  char skip_blanks(std::size_t& at);
  bool skip_string();
  Chunk take(std::size_t end);

  void start();
  bool is_row_followed_by_row();
  void begin_list(JsonShape shape);
  bool begins_keys();
  std::optional<JsonPart> scan_object();
  std::optional<JsonPart> end_object();
  JsonPart cut_object(std::size_t end);
  void scan_to_curve();
  void scan_records();
  std::optional<JsonPart> next_records();
  std::optional<JsonPart> take_rest();
  /// The last string among the members of the current object.
  std::string_view name() const { return std::string_view(text_).substr(name_begin_, name_end_ - name_begin_); }
  std::string path(std::string_view list) const;
  Error here(const Error& error) const { return error.at({"", line_, column_}); }

  TextBytes bytes_;
  std::uint64_t max_memory_;
  std::string text_;                     ///< read and not yet cut off
  std::size_t at_ = 0;                   ///< scanned up to here
  std::uint64_t line_ = 1, column_ = 1;  ///< of the first character
  bool is_input_read_ = false;           ///< to its end

  Stage stage_ = Stage::start;
  std::optional<JsonShape> shape_;               ///< nothing: not known yet
  std::optional<std::size_t> boundary_;          ///< the end of the last whole record that was scanned
  std::uint64_t records_ = 0, records_cut_ = 0;  ///< whole records of the list that were scanned, and cut off
  bool is_first_cut_ = true;                     ///< of the list, or of the values
  bool is_list_closed_ = false;
  std::size_t depth_ = 0;                      ///< of open brackets in the current object
  bool has_list_ = false;                      ///< the list of the current object was found
  std::size_t name_begin_ = 0, name_end_ = 0;  ///< of the last string among its members
  std::uint64_t curve_ = 0;                    ///< number of the current curve
  Chunk before_;                               ///< the current object up to its list
  Chunk before_curves_;                        ///< the object around the curves, up to them
};

}  // namespace tcb
