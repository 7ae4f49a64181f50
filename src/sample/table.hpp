// Tables: the quantities that a row can show by name, the cells of rows, and their columns.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schema/curve_channels.hpp"
#include "tcb/spline/double_double.hpp"

namespace tcb {

struct SampleBlock;
struct Schema;

/// What the cells of a column are, which decides how they are written.
enum class CellKind { time, duration, real, whole };

/// The name and kind of a column of the output.
struct OutputColumn {
  std::string name;
  CellKind kind = CellKind::real;
};

/// A number of a row. A time beyond 2^53 needs both parts.
using Cell = spline::DoubleDouble;

/// The cell of a number that is not defined.
inline constexpr Cell empty_cell{0, std::numeric_limits<double>::quiet_NaN()};
inline bool is_empty(const Cell& cell) { return cell.lo != cell.lo; }

/// A cell of a row's position: that of a channel, or of a number of a rotation.
struct PositionCell {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::size_t channel = none;   ///< whose number it is, unless the rotation is shown in another form
  std::size_t rotation = none;  ///< whose number it is
  std::size_t number = 0;       ///< among those of the rotation
};

std::vector<PositionCell> position_cells(std::size_t channels, std::span<const RotationColumns> rotations);

/// A quantity that a row can show; fields.hpp has the table of them.
struct Field {
  std::string_view name;
  std::string_view suffix = {};  ///< of a column's name, for a field with columns for each channel
  CellKind kind = CellKind::real;
  bool per_channel = false;          ///< columns for each channel, named after it; otherwise one
  bool of_motion = false;            ///< only for channels that are not numbers of a rotation
  bool per_rotation = false;         ///< columns for each rotation
  bool shows_rotations = false;      ///< rotations have the columns of the form in which rows show them
  std::size_t columns = 1;           ///< for each channel or rotation; several are numbered from 0
  std::string_view odd_suffix = {};  ///< of every second one of several columns, where the suffixes alternate
  bool of_piece = false;             ///< it is of a row that is a piece, not of a sample
  bool needs_lengths = false;        ///< the segments before it have to be measured
  bool over_metric = false;          ///< it is a length or a speed over the metric channels
  bool of_pace = false;              ///< it is that of the motion of rows at a pace
  bool has_side = false;             ///< at a key it may differ from one side to the other
  bool is_exact = true;              ///< it has an exact value, which is rounded once
  bool is_rational = true;           ///< for rational keys at a rational time it is rational, or the root of a rational
};

std::span<const Field> fields();

/// The fields that can be chosen by name: those of samples, and the length of a piece.
std::span<const Field> named_fields();

/// The index of a field. Requires: its name.
std::size_t field_of(std::string_view name);

/// The channels of a row, and the rotations that four of them each make.
struct RowShape {
  std::size_t channels = 0;
  std::span<const RotationColumns> rotations = {};
};

/// The number of cells of these fields in a row.
std::size_t cells_in_row(std::span<const std::size_t> chosen, const RowShape& shape);

/// What a cell of a row shows: the position of a channel, another quantity of it, or of several channels or none.
struct CellOfChannel {
  std::size_t channel = PositionCell::none;
  bool is_position = false;
};
std::vector<CellOfChannel> cells_of_channels(std::span<const std::size_t> chosen, const RowShape& shape);

std::vector<OutputColumn> output_columns(std::span<const std::size_t> chosen, const Schema& schema);

/// The cells of some rows, row after row.
struct Table {
  std::vector<Cell> cells;
  std::vector<std::string> texts =
      {};  ///< of the cells, where they have more digits than these; else none, or empty ones
};

/// The rows of a block with the chosen fields.
using Evaluate = std::function<Table(const SampleBlock& block, std::span<const std::size_t> chosen)>;

}  // namespace tcb
