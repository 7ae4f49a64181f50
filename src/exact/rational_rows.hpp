// Rational rows: the numbers of rows that are rational, or roots of rationals, exactly.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "exact/rounding.hpp"
#include "exact/row_point.hpp"

namespace tcb {

class RationalRows {
 public:
  /// Requires: the curve is rational, and outlives them.
  explicit RationalRows(const RowsOfCurve& rows);
  ~RationalRows();

  /// The numbers of some fields. Requires: where rows are placed by length, the row is at a key.
  std::vector<Value> values(const FastRow& row, std::span<const std::size_t> chosen);

 private:
  struct Points;
  const std::unique_ptr<Points> points_;
};

}  // namespace tcb
