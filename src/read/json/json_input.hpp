// JSON input: members of keys, keys, settings of curves, provenance, and the shapes that an input may have.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members have the roles of
// columns of the same names, and "tcb":[t,c,b] is accepted. It is parsed by nlohmann-json through its events, so no
// document is kept in memory.
// Source: RFC 8259.
//
// The text may be an array of keys, an object with an array "keys" among its members, an object with an array
// "curves" of such objects, or one key object after another (JSON Lines). "rows", which the program writes, is read
// as "keys".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read/earlier_output.hpp"
#include "read/json/scanner.hpp"
#include "read/chunk.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// A piece of JSON text: key objects, or the object around them with an empty array in their place.
struct JsonPart {
  Chunk chunk;
  bool is_object = false;               ///< it is the object, whose keys were in earlier parts
  std::size_t gap = std::string::npos;  ///< where the keys were cut out of its text
  std::uint64_t line = 1, column = 1;   ///< the position of the text after the keys
};

class JsonSplitter {
 public:
  explicit JsonSplitter(Source<std::string> bytes) : scanner_(std::move(bytes)) {}

  /// The next part: "[key,key,…]" cut from an array, key objects from JSON Lines, or the object around keys.
  /// Every byte is in a part or is checked here, so parsing the parts finds every fault.
  /// Throws: Error (data) for text after an array, and for a key or the rest of an object over 64 MiB.
  std::optional<JsonPart> next();

  /// Requires: next() was called.
  JsonShape shape() const { return shape_.value_or(JsonShape::lines); }

  /// The current object up to its keys. Requires: next() gave keys.
  const JsonPart& before_keys() const { return object_; }

 private:
  /// What the current text is.
  enum class Stage { start, object, list, between, lines, after_list, end };

  bool scan();
  bool scan_start();
  bool scan_object();
  bool scan_keys();
  bool scan_between();
  bool begin_list();
  void start_list(JsonShape shape);
  void end_list();
  std::optional<JsonPart> cut(bool at_end);
  JsonPart take_object(std::size_t end);
  std::string path(const char* list) const;

  JsonScanner scanner_;
  std::size_t boundary_ = 0;                     ///< end of the last whole record, 0 for none
  std::uint64_t records_ = 0, records_cut_ = 0;  ///< whole records scanned, and cut off
  Stage stage_ = Stage::start;
  std::optional<JsonShape> shape_;  ///< nothing: not known yet
  bool first_cut_ = true;           ///< of its list
  bool list_closed_ = false;
  bool listed_ = false;      ///< the keys of the current object were found
  bool comma_ = true;        ///< a curve may follow
  std::size_t depth_ = 0;    ///< of open brackets in the current object or list
  std::string member_;       ///< last string of the current object
  std::uint64_t curve_ = 0;  ///< number of the current curve
  JsonPart object_;          ///< the current object up to its keys
  JsonPart outer_;           ///< the object around the curves
};

/// The meaning of the members of key objects, as in the first one. Each is a cell, or an array of cells.
struct JsonColumns {
  struct Member {
    std::string name;
    bool array = false;
    std::size_t cell = 0;   ///< its first cell in `columns`
    std::size_t cells = 0;  ///< the number of its cells; 0: it is ignored
    bool required = false;
  };
  Columns columns;
  std::vector<Member> members;
  std::size_t found = 0;  ///< the number of cells of the first key; others may come in any key
  KeyRules rules;
};

/// The meaning of the members of the first key of a chunk. `channels` are names for the numbers of "position", if any.
/// Throws: Error (data).
JsonColumns find_members(const Chunk& chunk, const InputOptions& options, const std::vector<std::string>& channels);

/// Gives the numbers of "position" these names. Throws: Error (data) if there are not as many.
void name_channels(JsonColumns& columns, const std::vector<std::string>& channels);

/// The keys of a chunk of whole key objects, an array of them or one per line. A pure function.
/// Errors are among its faults, at the position of the value; at most ten.
KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns);

/// The members of an object around keys.
struct JsonCurveInfo {
  CurveInfo curve_info;
  std::vector<std::string> channels;  ///< names of the numbers of "position"
  std::vector<std::string> unused;    ///< members with numbers that are no settings
  std::string path;                   ///< of the object, empty for the outermost one
  TextPosition position;              ///< where it begins
};

/// Throws: Error (data) at a member that is wrong, or whose name is a near miss.
JsonCurveInfo read_curve_info(const JsonPart& part);

/// The names of channels in an object whose text ends before its keys, if it has any.
std::vector<std::string> channels_before_keys(const JsonPart& part);

/// The member "meta" of JSON text, or of the last line of JSON Lines; empty if there is none.
EarlierOutput json_provenance(std::string_view text);

/// Opens JSON of any shape: an array of keys, an object with "keys", one with "curves", or JSON Lines. Keys of an
/// object are held until its settings are known. Requires: the bytes have no byte order mark. Throws: Error (data).
Records open_json(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
