// Float rows: the numbers of rows in floats of many bits.
#include "exact/float_rows.hpp"

#include "exact/float_scalar.hpp"

namespace tcb {

template <>
class CellWriter<ShortFloat> : public NumberWriter<ShortFloat> {
  using NumberWriter::NumberWriter;
};
template <>
class CellWriter<LongFloat> : public NumberWriter<LongFloat> {
  using NumberWriter::NumberWriter;
};

namespace {

template <unsigned bits>
class Rows final : public FloatRows {
 public:
  explicit Rows(const RowsOfCurve& rows) : point_(rows) {}

  void place(const FastRow& row) override { point_.place(row); }
  PlaceByLength place_of_row() const override { return point_.place_of_row(); }
  PlaceError<Rational> place_error() const override {
    const auto& [place, eased, part] = point_.place_error();
    return {rational_of<bits>(place), rational_of<bits>(eased), rational_of<bits>(part)};
  }
  std::vector<std::optional<Rational>> numbers(std::size_t field) override {
    std::vector<Written<Float<bits>>> row;
    point_.write(field, row);
    std::vector<std::optional<Rational>> numbers;
    for (const auto& [number, is_zero] : row) {
      if (number.defined && !isfinite(number.value)) throw Undecided();
      numbers.push_back(number.defined ? std::optional(rational_of<bits>(number.value)) : std::nullopt);
    }
    return numbers;
  }
  Rational noise(std::size_t field) override {
    const Float<bits> noise = point_.noise(field);
    return isfinite(noise) ? rational_of<bits>(noise) : Rational(0);
  }
  bool is_symmetric() override { return point_.is_symmetric(); }

 private:
  RowPoint<Float<bits>> point_;
};

}  // namespace

std::unique_ptr<FloatRows> FloatRows::in_short(const RowsOfCurve& rows) { return std::make_unique<Rows<192>>(rows); }
std::unique_ptr<FloatRows> FloatRows::in_long(const RowsOfCurve& rows) { return std::make_unique<Rows<448>>(rows); }

}  // namespace tcb
