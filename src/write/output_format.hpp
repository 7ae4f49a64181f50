// Output format: the half of a format that writes its rows. Each is defined in one file of this room, and a row of
// formats/formats.cpp names it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/rational.hpp"
#include "schema/curve_channels.hpp"
#include "schema/format.hpp"
#include "schema/schema.hpp"
#include "write/layout.hpp"

namespace tcb {

/// How rows are played as frames.
struct PlayedFrames {
  Rational rate;                         ///< in frames per second
  std::optional<Rational> seconds = {};  ///< of all; nothing: those of the rows
};

/// What a format keeps of the rows of an output, where it writes more than their texts.
class RowKeeper {
 public:
  RowKeeper() = default;
  RowKeeper(const RowKeeper&) = delete;
  RowKeeper& operator=(const RowKeeper&) = delete;
  virtual ~RowKeeper() = default;

  /// Begins the rows of curves with this meaning. Throws: Error (data) for channels that the format does not hold.
  virtual void begin(const Schema&) {}
  /// Sets texts around rows.
  virtual void complete(Layout&) const {}
  /// Begins the rows of a curve. `euler`: angles that its channels are, whose rotations are written.
  virtual void begin_curve(const std::vector<std::string>& /*group*/, const std::optional<EulerTrack>& /*euler*/) {}
  /// Takes note of rows before they are printed, in any order and from any thread.
  virtual void observe(const Table& /*rows*/, std::size_t /*cells_per_row*/) {}
  /// Takes the text of rows, where the format gathers it.
  virtual void add(std::string_view /*rows*/) {}
  virtual void end_curve() {}
  /// Sets the frames that were asked for.
  virtual void set_frames(const PlayedFrames&) {}
  /// Names of channels that are only in extras of the format.
  virtual std::vector<std::string> channels_in_extras() const { return {}; }
  /// The text after all rows. `unit`: that of times, in seconds.
  virtual std::string tail(const Rational& unit) = 0;
};

struct OutputFormat {
  Layout (*layout)(const std::vector<OutputColumn>& columns, const TextMarks& marks, bool header);
  /// A cell from a text as in schema/texts.hpp; null: cells are numbers only.
  std::string (*text)(std::string_view text, char delimiter) = nullptr;
  /// The head with the number of rows, written in place of the layout's head of the same size; null: not needed.
  std::string (*counted_head)(std::size_t columns, std::uint64_t rows) = nullptr;
  /// Makes what keeps the rows of an output with these fields; null: rows are only printed.
  std::unique_ptr<RowKeeper> (*keeper)(const Schema& schema, std::span<const std::size_t> fields) = nullptr;
  bool has_groups = true, has_labels = true;  ///< rows may have these texts
  bool gathers_rows = false;  ///< the keeper takes them with their groups, and writes them all at the end
};

/// For each column of a format of poses, the number of the cell in rows of a time, if the format has one, and a
/// position. Requires: rotations are shown in its form. Throws: Error (data) unless the rows have a position of three
/// channels, one rotation, and the other channels of the format.
std::vector<std::size_t> pose_cells(const Format& of, const Schema& schema);

}  // namespace tcb
