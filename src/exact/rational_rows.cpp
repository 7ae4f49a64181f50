// Rational rows: the numbers of rows that are rational, or roots of rationals, exactly.
#include "exact/rational_rows.hpp"

namespace tcb {

/// Collects the numbers of a point.
template <>
class CellWriter<Rational> {
 public:
  explicit CellWriter(std::vector<Value>& row) : row_(row) {}

  void add(const Rational& value) { row_.push_back({value}); }
  void add(const Quantity<Rational>& value) { row_.push_back({value.value, value.root, !value.defined}); }
  void add_of_channel(const Rational& value, std::size_t, bool) { add(value); }

 private:
  std::vector<Value>& row_;
};

struct RationalRows::Points {
  RowPoint<Rational> point;
};

RationalRows::RationalRows(const RowsOfCurve& rows) : points_(new Points{RowPoint<Rational>(rows)}) {}
RationalRows::~RationalRows() = default;

std::vector<Value> RationalRows::values(const FastRow& row, std::span<const std::size_t> chosen) {
  Point<Rational>& point = points_->point.place(row, needs_lengths(chosen));
  std::vector<Value> result;
  for (const std::size_t field : chosen) field_writers<Rational>[field](point, CellWriter<Rational>(result));
  return result;
}

}  // namespace tcb
