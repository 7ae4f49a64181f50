// Cells: the numbers of a row, and which of them show the position.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "sample/point.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

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

/// The cells of a position in order.
std::vector<PositionCell> position_cells(std::size_t channels, std::span<const RotationColumns> rotations);

/// Receives the numbers of a point, one cell after another. For exact scalars see exact/precision_levels.
template <class S>
class CellWriter;

template <>
class CellWriter<double> {
 public:
  explicit CellWriter(Cell* next) : next_(next) {}
  void add(const Cell& value) { *next_++ = value; }
  void add(const Quantity<double>& value) { add(value.defined ? Cell(value.value) : empty_cell); }
  /// One of a channel's numbers: a position, or with `moves` a derivative.
  void add_of_channel(double value, std::size_t, bool) { add(value); }

 private:
  Cell* next_;
};

}  // namespace tcb
