// Where the keys are in JSON text: it is cut between key objects, without looking into them.
//
// The text may be an array of keys, an object with an array "keys" among its members, or one key object
// after another (JSON Lines). What is not keys is the envelope.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "format/input.hpp"

namespace tcb::format {

class JsonSplitter {
 public:
  explicit JsonSplitter(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  /// The next chunk: "[key,key,…]" cut from an array, or key objects from JSON Lines.
  /// Every byte ends up in a chunk or in the envelope, so parsing those finds every fault.
  std::optional<Chunk> next();

  /// The keys stand in an object, whose other members are in the envelope.
  bool wrapped() const { return shape_ == Shape::wrapped; }

  /// The array of keys has come to its end.
  bool list_closed() const { return list_closed_; }

  /// The object around the keys, with an empty array in their place. Requires: next() said the end.
  const Chunk& envelope() const { return envelope_; }

 private:
  enum class Shape { unknown, list, wrapped, lines };

  void scan();
  void scan_string();
  void open(char bracket);
  void close();
  void start_list(Shape shape);
  std::optional<Chunk> cut(bool at_end);
  Chunk take(std::size_t end);
  bool read_more();
  void advance_place(std::string_view text);

  Source<std::string> bytes_;
  std::string text_;                             ///< read and not yet cut off
  std::size_t at_ = 0;                           ///< scanned up to here
  std::size_t boundary_ = 0;                     ///< end of the last whole record, 0 for none
  std::uint64_t records_ = 0, records_cut_ = 0;  ///< whole records scanned, and cut off
  bool in_string_ = false;
  bool list_closed_ = false;
  bool first_cut_ = true;
  std::size_t depth_ = 0;
  std::size_t string_start_ = 0;
  std::string member_;  ///< last string seen in the outermost object
  Shape shape_ = Shape::unknown;
  std::uint64_t line_ = 1, column_ = 1;  ///< place of text_[0]
  Chunk envelope_;
};

}  // namespace tcb::format
