// Ball rows: the numbers of rows that numbers with bounds on their errors can round.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "exact/rounding.hpp"
#include "exact/row_point.hpp"

namespace tcb {

/// A cell of a row that is being computed.
struct RowCell {
  std::optional<Printed> printed = {};  ///< nothing until it is decided
  bool may_be_zero = false;             ///< a ball of it holds 0
};

/// What a cell is at the inner places of a segment; `open`: 0 or empty, as far as is known.
enum class AlongSegment { open, zero, empty, other };

class BallRows {
 public:
  /// In double-doubles; null for a curve that these cannot hold. `chosen`: the fields of all rows.
  static std::unique_ptr<BallRows> in_double_doubles(const RowsOfCurve& rows, const std::vector<std::size_t>& chosen);
  /// In floats of the digits in use (Real::bits), which are to be in use for all rows. Throws: Undecided for a curve
  /// that needs more.
  static std::unique_ptr<BallRows> in_reals(const RowsOfCurve& rows, const std::vector<std::size_t>& chosen);
  virtual ~BallRows() = default;

  /// Sets those cells of a row that are not decided yet and that their balls decide. False if the place of the row is
  /// not decided.
  virtual bool set(const FastRow& row, const Notation& notation, std::vector<RowCell>& cells) = 0;

  /// Decides cells that are open: `other` where a ball shows it at one place, and at the last precision all of them.
  virtual void look_along(const FastRow& row, std::vector<AlongSegment>& cells) = 0;

  /// Whether the curve is as fast as it is reversed. Requires: the last precision.
  virtual bool is_symmetric() = 0;

  /// Whether the last row that had a place was at the key at its segment's end, or at its start; nothing if it was at
  /// none.
  virtual std::optional<bool> key_at_end() const = 0;
};

}  // namespace tcb
