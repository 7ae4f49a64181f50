// Splitter of JSON text: it is cut between key objects, without parsing them.
//
// The text may be an array of keys, an object with an array "keys" among its members, an object with an array
// "curves" of such objects, or one key object after another (JSON Lines). Where the program writes "rows" for "keys",
// it reads that too.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "input/input.hpp"
#include "input/json/scanner.hpp"

namespace tcb {

/// A piece of JSON text: key objects, or the object around them with an empty array in their place.
struct JsonPart {
  Chunk chunk;
  bool is_object = false;               ///< it is the object, and its keys came before
  std::size_t gap = std::string::npos;  ///< where the keys were taken out of its text
  std::uint64_t line = 1, column = 1;   ///< the position of the text after the keys
};

class JsonSplitter {
 public:
  explicit JsonSplitter(Source<std::string> bytes) : scanner_(std::move(bytes)) {}

  /// The next part: "[key,key,…]" cut from an array, key objects from JSON Lines, or the object around keys.
  /// Every byte is in a part or was checked here, so parsing the parts finds every fault.
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
  bool listed_ = false;      ///< the current object had its keys
  bool comma_ = true;        ///< a curve may follow
  std::size_t depth_ = 0;    ///< of open brackets in the current object or list
  std::string member_;       ///< last string of the current object
  std::uint64_t curve_ = 0;  ///< number of the current curve
  JsonPart object_;          ///< the current object up to its keys
  JsonPart outer_;           ///< the object around the curves
};

}  // namespace tcb
