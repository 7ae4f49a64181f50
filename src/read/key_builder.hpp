// Key builder: cells become keys, for delimited text and for JSON alike.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "numbers/parse_number.hpp"
#include "schema/columns.hpp"
#include "schema/key_block.hpp"
#include "schema/key_rules.hpp"
#include "schema/units.hpp"

namespace tcb {

/// The two parts of a time are not whole seconds and nanoseconds. `time`: the name of the column of seconds.
Error time_parts_not_whole(std::string_view time);

/// The column of a cell has no role because it begins without numbers, and has one.
Error number_in_empty_column(std::string_view number, const Columns& columns, std::size_t cell);

/// Builds a block of keys. A record is begin_key(), its cells in any order, and end_key(). Without its cell, a key has
/// no position, the common tension, no ease, no text.
class KeyBuilder {
 public:
  /// Requires: `columns` outlives it.
  KeyBuilder(const Columns& columns, const KeyRules& rules, const KeyUnits& units = {});

  /// Begins a key; a key that was not ended is dropped.
  void begin_key();

  /// The number of a cell in the key. Requires: its role is position, one from tension to ease_out, or one in a
  /// channel.
  double& number(const Columns::Column& column) { return numbers_[index_of(column)]; }
  /// Numbers are kept as written, or scaled.
  bool takes_decimals() const {
    return keeps_decimals() || rules_.tcb_scale == TcbScale::max3ds || !units_.factors.empty();
  }
  /// Keeps the number of a cell as written, and scales it, as far as that is requested; false for a result beyond the
  /// doubles. Requires: the number is set.
  bool take_decimal(const Columns::Column& column, std::string_view decimal);
  /// Takes a number as written, of the time or of another cell; false for a result beyond the doubles.
  bool take(const Columns::Column& column, double number, std::string_view decimal);
  void set_time(const Time& time) { time_ = time; }
  /// The times are numbers, of seconds or another unit.
  bool has_times_as_numbers() const { return units_.notation == TimeNotation::seconds; }
  /// Sets the time from a text in the notation of the input; false for another text, and for a time that does not
  /// exist.
  bool set_time_in_words(std::string_view text);
  /// A text as in schema/texts.hpp.
  void set_text(const Columns::Column& column, std::string text) { texts_[column.channel] = std::move(text); }

  /// The cell has no value. Returns whether that is allowed; if so, the row may be skipped or be a gap.
  bool miss(const Columns::Column& column);
  /// The key is skipped, or is a gap, as it has no value for some cell.
  bool is_missing() const { return is_missing_; }

  /// Adds a fault; the current key is not kept.
  void add_fault(Error fault) {
    if (!is_full()) block_.faults.errors.push_back(std::move(fault));
  }
  /// No more faults are needed.
  bool is_full() const { return block_.faults.errors.size() >= most_faults; }
  /// Nothing after the last fault can be read.
  void set_unreadable() { block_.faults.unreadable = true; }

  /// Adds the nanoseconds of the time, if it has any, to its seconds, which are its other part. False where they are
  /// not from 0 to below 10^9, or where either is not a whole number.
  bool complete_time() { return !has_nanoseconds_ || add_nanoseconds(); }

  /// Ends the key. Returns whether it is kept; if so, set_position() must follow.
  bool end_key();
  /// The text position of the key that was kept last.
  void set_position(std::uint64_t line, std::uint64_t column) {
    block_.text_positions.lines.push_back(line);
    block_.text_positions.columns.push_back(static_cast<std::uint32_t>(column));
  }
  /// The number of the key that was kept last, in its list.
  void set_number(std::uint64_t number) { block_.text_positions.numbers.push_back(number); }

  /// Adds a break before the next key that is kept.
  void break_curve() { breaks_ = true; }

  /// The block, with the path of the list that the keys are in.
  KeyBlock finish(std::string path = {});

 private:
  bool keeps_decimals() const { return !decimals_.empty(); }
  /// The index of a column's number in the order of NumberOfKey; the nanoseconds are in the place of the time.
  std::size_t index_of(const Columns::Column& column) const {
    const std::size_t first = first_of_role_[static_cast<std::size_t>(column.role)];
    return first < NumberOfKey::position ? first : first + column.channel;
  }
  std::size_t index_of(NumberOfKey::Kind kind, std::size_t channel) const {
    return NumberOfKey::of_channel(kind, channel, block_.keys.channels);
  }
  bool add_nanoseconds();
  void copy_number(std::size_t from, std::size_t to);
  void complete_channels();
  void add_key();

  const KeyRules rules_;
  const KeyUnits units_;
  const bool is_timed_, has_nanoseconds_, has_tcb_, has_ease_, has_channel_roles_, has_channel_tcbs_;
  const std::vector<std::size_t> both_sides_;               ///< channels with one velocity for both sides
  std::array<std::size_t, role_count> first_of_role_ = {};  ///< the index of its number in the first channel
  KeyBlock block_;
  bool breaks_ = false;  ///< there is a break before the next key
  // Of the current key:
  bool is_missing_ = false;  ///< a value is missing that a key needs
  std::size_t faults_ = 0;   ///< the number of faults before it
  Time time_;
  std::vector<double> numbers_;  ///< in the order of NumberOfKey; NaN where one is missing
  std::vector<std::string> texts_;
  std::vector<std::string> decimals_;  ///< in the order of NumberOfKey; empty if they are not kept
};

}  // namespace tcb
