// Ball rows: the numbers of rows that numbers with bounds on their errors can round.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "exact/rounding.hpp"
#include "exact/row_point.hpp"

namespace tcb {

class BallRows {
 public:
  /// Whether a cell of the row is 0 all along its segment.
  using IsZero = std::function<bool(std::size_t cell)>;

  /// In double-doubles; null for a curve that these cannot hold. `chosen`: the fields of all rows.
  static std::unique_ptr<BallRows> in_double_doubles(const RowsOfCurve& rows, std::vector<std::size_t> chosen);
  /// In floats of the digits in use (Real::bits), which are to be in use for all rows; rotations are measured in
  /// double-doubles, or in these floats. Throws: Undecided for a curve that needs more.
  static std::unique_ptr<BallRows> in_reals(const RowsOfCurve& rows, std::vector<std::size_t> chosen,
                                            bool measures_in_double_doubles);
  virtual ~BallRows() = default;

  /// Sets those cells of a row that are not set yet and that their balls decide, or `is_zero` where their balls hold 0.
  /// False if the place of the row is not decided.
  virtual bool set(const FastRow& row, const Notation& notation, const IsZero& is_zero,
                   std::vector<std::optional<Printed>>& cells) = 0;

  /// The cells that are 0 all along the segment of a row, or empty, as they are at several places of it; nothing for
  /// the others. Requires: the last precision.
  virtual std::vector<std::optional<Cell>> zeros(const FastRow& row) = 0;

  /// Whether the curve is as fast as it is reversed. Requires: the last precision.
  virtual bool is_symmetric() = 0;

  /// Whether the last row that had a place was at the key at its segment's end, or at its start; nothing if it was at
  /// none.
  virtual std::optional<bool> key_at_end() const = 0;
};

}  // namespace tcb
