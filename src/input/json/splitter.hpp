// Where the keys are in JSON text: it is cut between key objects, without looking into them.
//
// The text may be an array of keys, an object with an array "keys" among its members, an object with an array
// "curves" of such objects, or one key object after another (JSON Lines). What is not keys stands beside them.
// Where the program writes "rows" for "keys", it reads that too.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "input/input.hpp"
#include "input/json/text.hpp"

namespace tcb {

/// A piece of JSON text: key objects, or the object around them with an empty array in their place.
struct JsonPart {
  Chunk chunk;
  bool curve_info = false;              ///< it is the object, and its keys came before
  std::size_t gap = std::string::npos;  ///< where the keys were taken out of its text;
  std::uint64_t line = 1, column = 1;   ///< what stands behind them is from here
};

class JsonSplitter {
 public:
  explicit JsonSplitter(Source<std::string> bytes) : text_(std::move(bytes)) {}

  /// The next part: "[key,key,…]" cut from an array, key objects from JSON Lines, or what stands beside keys.
  /// Every byte ends up in a part or is found right, so parsing the parts finds every fault.
  /// Throws: Error (data) for text behind an array, for a key or what stands beside keys over 64 MiB.
  std::optional<JsonPart> next();

  enum class Shape { unknown, list, wrapped, curves, lines };
  Shape shape() const { return shape_; }

  /// The object at hand up to its keys. Requires: next() gave keys.
  const JsonPart& before_keys() const { return object_; }

 private:
  /// What the text at hand is.
  enum class Stage { start, object, list, between, lines, behind, end };

  bool scan();
  bool scan_start();
  bool scan_object();
  bool scan_keys();
  bool scan_between();
  bool begin_list();
  void start_list(Shape shape);
  void end_list();
  std::optional<JsonPart> cut(bool at_end);
  JsonPart take_object(std::size_t end);
  std::string path(const char* list) const;

  JsonText text_;
  std::size_t boundary_ = 0;                     ///< end of the last whole record, 0 for none
  std::uint64_t records_ = 0, records_cut_ = 0;  ///< whole records scanned, and cut off
  Stage stage_ = Stage::start;
  Shape shape_ = Shape::unknown;
  bool first_cut_ = true;  ///< of its list
  bool list_closed_ = false;
  bool listed_ = false;      ///< the object at hand had its keys
  bool comma_ = true;        ///< a curve may follow
  std::size_t depth_ = 0;    ///< brackets open in the object or the list at hand
  std::string member_;       ///< last string seen in the object at hand
  std::uint64_t curve_ = 0;  ///< number of the curve at hand
  JsonPart object_;          ///< the object at hand up to its keys
  JsonPart outer_;           ///< the object around the curves
};

}  // namespace tcb
