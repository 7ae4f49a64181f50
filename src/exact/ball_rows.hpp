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
  /// Nothing for a curve that balls cannot hold. `chosen`: the fields of all rows.
  static std::unique_ptr<BallRows> of(const RowsOfCurve& rows, std::vector<std::size_t> chosen);
  virtual ~BallRows() = default;

  /// Sets the cells of a row; nothing for a cell that its ball does not decide. False if the place of the row is not
  /// decided.
  virtual bool set(const FastRow& row, const Notation& notation, std::vector<std::optional<Printed>>& cells) = 0;

  /// Whether the last row was at the key at its segment's end, or at its start; nothing if it was at none.
  virtual std::optional<bool> key_at_end() const = 0;
};

}  // namespace tcb
