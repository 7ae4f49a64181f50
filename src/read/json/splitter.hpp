// JSON splitter: a JSON text is cut into whole records, by its strings and brackets alone.
//
// The text may be an array of keys, an object with an array "keys" among its members, an object with an array
// "curves" of such objects, or one key object after another (JSON Lines). "rows", which the program writes, is read
// as "keys".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "read/chunk.hpp"
#include "read/input.hpp"
#include "read/json/scanner.hpp"
#include "stream/source.hpp"

namespace tcb {

/// A part of a JSON text, which is a JSON text itself, or would be one in brackets.
struct JsonPart {
  enum class Kind {
    elements,  ///< of an array, with the commas between them and without its brackets
    lines,     ///< each of which is blank or a JSON text
    object,    ///< around an array that was cut out, without the elements and with the brackets
  };
  Kind kind = Kind::elements;
  Chunk chunk;       ///< the text; of an object, up to the opening bracket of the array
  Chunk after = {};  ///< the text of an object from the closing bracket of the array on; empty if it has no array
};

/// Cuts a text in the memory of a few records. Every byte is in a part or is checked here, so parsing the parts finds
/// every fault.
class JsonSplitter {
 public:
  /// `list`: the name of the array of keys; empty: "keys" or "rows", also in an array "curves".
  explicit JsonSplitter(Source<std::string> bytes, std::string_view list = {})
      : scanner_(std::move(bytes)), list_(list) {}

  /// The next part: keys, or the object around the keys before. Nothing at the end.
  /// Throws: Error (data) for text after an array, for an array that is not closed, and for a key or the rest of an
  /// object over 64 MiB.
  std::optional<JsonPart> next();

  /// Requires: next() was called.
  JsonShape shape() const { return shape_.value_or(JsonShape::lines); }

  /// The current object up to its keys; empty outside of one.
  const Chunk& before_keys() const { return before_; }

 private:
  /// What the current text is.
  enum class Stage { start, object, list, between_curves, lines, after_list, unclosed_list, end };

  bool scan();
  bool scan_start();
  bool scan_object();
  bool scan_records();
  bool scan_between_curves();
  void require_end();
  bool begin_list();
  void begin_list_of(JsonShape shape);
  void end_list();
  void end_curves();
  std::optional<JsonPart> cut();
  std::optional<JsonPart> cut_elements(std::size_t end);
  JsonPart cut_lines(std::size_t end);
  JsonPart cut_object(std::size_t end);
  std::optional<JsonPart> cut_rest();
  bool read_more();
  std::string path(std::string_view list) const;
  Error at_scanner(const Error& error) const { return error.at({"", scanner_.line, scanner_.column}); }

  JsonScanner scanner_;
  std::string_view list_;
  Stage stage_ = Stage::start;
  std::optional<JsonShape> shape_;               ///< nothing: not known yet
  std::optional<std::size_t> boundary_;          ///< the end of the last whole record
  std::uint64_t records_ = 0, records_cut_ = 0;  ///< whole records of the list that were scanned, and cut off
  std::size_t depth_ = 0;                        ///< of open brackets in the current object, list or line
  bool is_first_cut_ = true;                     ///< of the list
  bool is_list_closed_ = false;
  bool has_list_ = false;    ///< the list of the current object was found
  bool has_comma_ = true;    ///< a curve may follow
  std::string name_;         ///< the beginning of the last string of the current object
  std::uint64_t curve_ = 0;  ///< number of the current curve
  Chunk before_;             ///< the current object up to its list
  Chunk before_curves_;      ///< the object around the curves, up to them
};

}  // namespace tcb
