// Key blocks: successive keys with their texts, text positions, gaps and faults.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "schema/texts.hpp"
#include "tcb/spline/keys.hpp"
#include "tcb/spline/rotation_form.hpp"

namespace tcb {

struct CurveInfo;

using Keys = spline::Keys<double>;

/// The index of a number among the decimals of its key; from `position` on, channel by channel: first all positions,
/// then all numbers of the next kind, where a column has them. An empty text means the shortest decimal of the double,
/// or a whole number.
struct NumberOfKey {
  enum : std::size_t { time, tension, continuity, bias, ease_in, ease_out, position };
  /// The kinds of numbers of a channel.
  enum Kind : std::size_t { position_of, tension_of, continuity_of, bias_of, velocity_in_of, velocity_out_of, kinds };
  static std::size_t of_channel(Kind kind, std::size_t channel, std::size_t channels) {
    return position + kind * channels + channel;
  }
};

/// The largest number of faults of an input that are reported.
inline constexpr std::size_t most_faults = 1000;

/// Where keys are written. One entry per key, or none at all.
struct KeyTextPositions {
  std::vector<std::uint64_t> lines = {};    ///< always one per key
  std::vector<std::uint32_t> columns = {};  ///< in those lines
  std::string path = {};                    ///< of the list that holds the keys, in JSON
  std::vector<std::uint64_t> numbers = {};  ///< in that list
};

/// Rotations in another form than a quaternion: for each key and each of these rotations its numbers, and each number
/// as written.
struct WrittenRotations {
  std::vector<spline::RotationNumbers<double>> numbers = {};
  Texts decimals = {};
};

/// Where curves break. Indices of keys are increasing.
struct KeyBreaks {
  std::vector<std::size_t> gaps = {};    ///< entries that are not keys, but breaks in place of one
  std::vector<std::size_t> before = {};  ///< keys with a break before them
  bool at_end = false;                   ///< there is a break before the next block's first key
};

/// The keys that are not in the block.
struct KeyFaults {
  std::vector<Error> errors = {};  ///< of invalid keys
  bool unreadable = false;         ///< nothing after the last error can be read
  std::uint64_t skipped = 0;       ///< number of keys that were skipped
};

/// Successive keys. If the input has no times, the keys have none either. A position that is NaN is missing; in a
/// gap the time may be NaN too.
struct KeyBlock {
  Keys keys;
  KeyTextPositions text_positions = {};
  Texts texts = {};     ///< of each key: those of its groups, then its labels
  Texts decimals = {};  ///< of each key in the order of NumberOfKey: its numbers as written
  WrittenRotations rotations = {};
  KeyBreaks breaks = {};
  std::shared_ptr<const CurveInfo> curve_info = {};  ///< of the curve that begins here, if each has its own
  KeyFaults faults = {};

  std::size_t size() const { return text_positions.lines.size(); }
  bool empty() const { return text_positions.lines.empty(); }
  std::size_t texts_per_key() const { return empty() ? 0 : texts.size() / size(); }
  std::string_view text(std::size_t key, std::size_t i) const { return texts[key * texts_per_key() + i]; }

  bool has_gap_at(std::size_t key) const;
  bool has_break_before(std::size_t key) const;
  /// Whether a curve begins with the key: after a break, or because this block has information about a new curve.
  bool begins_curve(std::size_t key) const;

  /// Whether its keys have the same kinds of numbers, so that they can be appended to those of the other.
  bool has_shape_of(const KeyBlock& other) const {
    return empty() || other.empty() ||
           (keys.tcbs_per_key() == other.keys.tcbs_per_key() && keys.eases.empty() == other.keys.eases.empty() &&
            keys.given == other.keys.given);
  }

  /// Appends keys [first, last) of another block, without its gaps, breaks and members of the block.
  void append(const KeyBlock& from, std::size_t first, std::size_t last);
  /// Keys [first, last), or those with increasing indices; only the keys, as append() takes them.
  KeyBlock range(std::size_t first, std::size_t last) const;
  KeyBlock selected(std::span<const std::size_t> indices) const;
  /// Removes the keys from `first` on and returns them, with a break that is before it, and with curve_info if no key
  /// is left. Requires: no break after `first`.
  KeyBlock cut(std::size_t first);
  /// Moves the members of the block `from` into this one; this block's own curve_info has priority.
  void take_block_data(KeyBlock& from);

  /// Replaces numbers of keys as written, if they are kept: each by f(its key, its place among those of a key, it).
  void rewrite_decimals(const std::function<std::string(std::size_t, std::size_t, std::string_view)>& f);

  std::uint64_t line(std::size_t key) const { return text_positions.lines[key]; }
  /// The text position of the key's time, or in JSON of the key itself.
  TextPosition text_position(std::size_t key) const;
  /// The key in its list, as in "keys[17]"; empty if the input is no list.
  std::string list_position(std::size_t key) const;
};

}  // namespace tcb
