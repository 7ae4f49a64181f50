// Float rows: the numbers of rows in floats of many bits, which nothing but double-doubles and errors decides before.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "exact/row_point.hpp"

namespace tcb {

class FloatRows {
 public:
  /// In floats of 192 bits, and of 448.
  static std::unique_ptr<FloatRows> in_short(const RowsOfCurve& rows);
  static std::unique_ptr<FloatRows> in_long(const RowsOfCurve& rows);
  virtual ~FloatRows() = default;

  /// Places a row. Throws: Undecided.
  virtual void place(const FastRow& row) = 0;
  virtual PlaceByLength place_of_row() const = 0;
  virtual PlaceError<Rational> place_error() const = 0;
  /// The numbers of a field of the row that was placed last; nothing for one that is not defined.
  virtual std::vector<std::optional<Rational>> numbers(std::size_t field) = 0;
  /// As RowPoint has it.
  virtual Rational noise(std::size_t field) = 0;
  /// Whether the curve is as fast as it is reversed.
  virtual bool is_symmetric() = 0;
};

}  // namespace tcb
