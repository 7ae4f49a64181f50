// Ball rows: the numbers of rows that double-doubles with bounds on their errors can round, which are nearly all.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "exact/level.hpp"
#include "exact/rounding.hpp"

namespace tcb {

class BallRows {
 public:
  /// Nothing for curves with rotations, angles, equal speeds, or times made from distances, for rows by length, and for
  /// other fields than the time, the position and its derivatives, and the place on the curve.
  static std::unique_ptr<BallRows> of(const RowsOfCurve& rows, std::span<const std::size_t> chosen);
  virtual ~BallRows() = default;

  /// Sets the cells of a row; nothing for a cell that its ball does not decide. False if the place of the row is not
  /// decided, or not on its segment.
  virtual bool set(const FastRow& row, const Notation& notation, std::vector<std::optional<Printed>>& cells) = 0;
};

}  // namespace tcb
