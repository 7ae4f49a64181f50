// Ball rows: the numbers of rows that numbers with bounds on their errors can round.
#include "exact/ball_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "exact/ball.hpp"
#include "exact/ball_length.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"

namespace tcb {

namespace {

/// Times that are whole numbers from here on have all their digits.
constexpr double whole_times_from = 0x1p53;

/// 10^exponent. Requires: at most 10^80, so that products stay within the range of balls.
Ball ball_of_ten_to(int exponent) {
  constexpr double largest_exact = 1e22;
  Ball power(1.0);
  for (; exponent >= 22; exponent -= 22) power = power * Ball(largest_exact);
  double rest = 1;
  for (; exponent > 0; --exponent) rest *= 10;
  return power * Ball(rest);
}

Ball scaled_by_ten_to(const Ball& value, int exponent) {
  return exponent < 0 ? value / ball_of_ten_to(-exponent) : value * ball_of_ten_to(exponent);
}

/// The nearest whole number to those in a ball, if it is the same one. Requires: 0 <= value < 2^62.
std::optional<std::int64_t> whole_nearest_to(const Ball& value) {
  const auto whole = static_cast<std::int64_t>(value.middle().hi);
  const double rest = (value.middle().hi - static_cast<double>(whole)) + value.middle().lo,
               nearest = std::nearbyint(rest);
  constexpr double slack = 0x1p-40;  // for the rounding of `rest`
  if (std::abs(rest - nearest) + value.radius() > 0.5 - slack) return std::nullopt;
  return whole + static_cast<std::int64_t>(nearest);
}

/// The text of a number in a notation of digits or decimals, if it is the same for all numbers in its ball, and if it
/// has at most 17 digits.
std::optional<std::string> decimal_text(const Ball& number, const Notation& notation) {
  const double size = std::abs(number.middle().hi);
  const bool is_clear = size > 1e-70 && size < 1e70 && size > 2 * number.radius();
  if (!is_clear || notation.count > digits_of_double) return std::nullopt;
  const bool negative = number.middle().hi < 0;
  if (notation.kind == Notation::Kind::fixed) {
    const Ball units = scaled_by_ten_to(abs(number), notation.count);
    if (units.middle().hi > 1e17) return std::nullopt;
    const auto whole = whole_nearest_to(units);
    return whole ? std::optional(fixed_text(std::to_string(*whole), notation.count, negative)) : std::nullopt;
  }
  int binary = 0;
  (void)std::frexp(size * (1 - 0x1p-50), &binary);                      // the number may be less than its high part
  int exponent = static_cast<int>(std::floor((binary - 1) * 0.30103));  // of ten: that of the number, or one less
  Ball digits = scaled_by_ten_to(abs(number), notation.count - 1 - exponent);
  std::int64_t end = 1;
  for (int i = 0; i < notation.count; ++i) end *= 10;
  const Ball excess = digits - Ball(static_cast<double>(end));
  if (excess.may_be_zero() && !excess.is_zero()) return std::nullopt;  // the exponent is not decided
  if (excess.middle().hi >= 0) digits = scaled_by_ten_to(abs(number), notation.count - 1 - ++exponent);
  auto whole = whole_nearest_to(digits);
  if (!whole || *whole < end / 10) return std::nullopt;
  if (*whole == end) {
    *whole /= 10;
    ++exponent;
  }
  return digits_text(std::to_string(*whole), exponent, notation.count, negative);
}

Printed time_cell(const FastRow& row, const RowsOfCurve& curve, const Notation& notation) {
  const Time& shown = row.sample.t;
  const bool is_decimal = curve.exact.decimal || curve.exact.channels.frames;
  const bool is_shown = !row.exact.time && shown.lo == 0 && row.segment.decimals == 0 && !is_decimal;
  if (is_shown && !notation.is_rounded()) return {shown};
  if (is_shown && std::abs(shown.hi) < whole_times_from) {
    if (auto text = decimal_text(Ball(shown.hi), notation)) return {shown, *std::move(text)};
  }
  const Rounding rounding(notation, CellKind::time, row.segment.decimals);
  if (row.exact.time) return rounding.exactly({*row.exact.time});
  return rounding.exactly(
      {shown.lo == 0 ? exact_number(shown, curve.exact.decimal, curve.exact.channels.frames) : exact_time(shown)});
}

std::optional<Printed> number_cell(const Ball& number, const Notation& notation, CellKind kind, int decimals) {
  const bool is_plain = kind == CellKind::real || kind == CellKind::whole;
  if (kind == CellKind::whole || (is_plain && !notation.is_rounded())) {
    if (!rounds_to_one_double(number)) return std::nullopt;
    return Printed{.cell = Cell(number.middle().hi), .is_zero = number.is_zero()};
  }
  if (is_plain && rounds_to_one_double(number)) {
    if (auto text = decimal_text(number, notation)) return Printed{Cell(number.middle().hi), *std::move(text)};
  }
  const Rational middle = Rational(number.middle().hi) + Rational(number.middle().lo), radius(number.radius());
  return Rounding(notation, kind, decimals).within(middle, radius);
}
std::optional<Printed> number_cell(const RealBall& number, const Notation& notation, CellKind kind, int decimals) {
  if (number.may_be_zero() && !number.is_zero_at_last()) return {};
  const Rational middle = number.middle().rational(), radius = Middle<Real>::number(number.radius()).rational();
  const Rounding rounding(notation, kind, decimals);
  return Real::is_last() ? rounding.at_last(middle, radius) : rounding.within(middle, radius);
}

}  // namespace

/// Throws: Undecided unless all numbers in the ball are printed as one double.
template <>
double printed_length<Ball>(const Ball& length) {
  if (!rounds_to_one_double(length)) throw Undecided();
  return length.middle().hi;
}

template <>
double printed_length<RealBall>(const RealBall& length) {
  const Rational middle = length.middle().rational(), radius = Middle<Real>::number(length.radius()).rational();
  const double low = nearest_double(middle - radius), high = nearest_double(middle + radius);
  if (low != high && !(length - RealBall(length.middle())).is_zero_at_last()) throw Undecided();
  return low == high ? low : nearest_double(middle);
}

/// Passes on the numbers of a point in balls.
template <class M>
class CellWriter<BallOf<M>> {
 public:
  using Next = std::function<void(const Quantity<BallOf<M>>&)>;

  CellWriter(const Next& next, const ChannelFacts& facts) : next_(next), facts_(facts) {}

  void add(const BallOf<M>& value) { next_({value}); }
  void add(const Quantity<BallOf<M>>& value) { next_(value); }
  void add_of_channel(const BallOf<M>& value, std::size_t channel, bool moves) {
    const std::vector<bool>& is_zero = moves ? facts_.constant : facts_.zero;
    add(value.may_be_zero() && is_zero[channel] ? BallOf<M>() : value);
  }

 private:
  const Next& next_;
  const ChannelFacts& facts_;
};

namespace {

template <class M>
class Rows final : public BallRows {
 public:
  using B = BallOf<M>;

  Rows(const RowsOfCurve& rows, const std::vector<std::size_t>& chosen)
      : rows_(rows), measured_(needs_lengths(chosen)), point_(rows) {
    for (const std::size_t index : chosen) {
      const RowShape shape{rows.exact.keys.channels, rows.exact.channels.rotations};
      const Field& field = fields()[index];
      const bool is_row_time = field.kind == CellKind::time && field_writers<B>[index] == write_sample_time<B>;
      fields_.push_back({is_row_time ? nullptr : field_writers<B>[index], field.kind, cells_in_row({&index, 1}, shape),
                         field.needs_lengths || field.of_piece || field.name == "key",
                         field.name == "acceleration" || field.name == "jerk"});
    }
  }

  bool set(const FastRow& row, const Notation& notation, std::vector<RowCell>& cells) override {
    try {
      Point<B>& point = point_.place(row, measured_);
      at_end_ = point_.key_at_end();
      std::size_t first = 0;
      for (const auto& field : fields_) {
        const auto of_field = std::span(cells).subspan(first, field.size);
        if (std::ranges::any_of(of_field, [](const RowCell& cell) { return !cell.printed; })) {
          set(of_field, row, notation, field, point);
        }
        first += field.size;
      }
      return true;
    } catch (const Undecided&) {
      return false;
    }
  }

  void look_along(const FastRow& row, std::vector<AlongSegment>& cells) override {
    const auto is_decided = [](AlongSegment cell) { return cell == AlongSegment::other; };
    for (const double u : inner_places) {
      Point<B>* const point = point_.place_inside(row, u);
      std::size_t first = 0;
      for (const auto& field : fields_) {
        const auto of_field = std::span(cells).subspan(first, field.size);
        first += field.size;
        if (std::ranges::all_of(of_field, is_decided)) continue;
        const bool has_numbers = point != nullptr && field.write != nullptr && !field.is_of_more_than_place &&
                                 !(field.jumps_in_ease && point->segment().warp.has_ease());
        look_at(of_field, field, has_numbers ? point : nullptr, u == inner_places.front());
      }
    }
  }

  bool is_symmetric() override { return point_.is_symmetric(); }

  std::optional<bool> key_at_end() const override { return at_end_; }

 private:
  struct FieldCells {
    decltype(FieldOf<B>::write) write;  ///< null: the time of the row
    CellKind kind;
    std::size_t size;
    bool is_of_more_than_place;  ///< of lengths from the start of the curve, or of a piece, or of keys alone
    bool jumps_in_ease;          ///< between the parts of an ease, so that it may be 0 in some of them
  };

  /// Sets the cells of a field that are not decided yet.
  void set(std::span<RowCell> cells, const FastRow& row, const Notation& notation, const FieldCells& field,
           Point<B>& point) {
    if (field.write == nullptr && !rows_.arc) {
      cells.front().printed = time_cell(row, rows_, notation);
      return;
    }
    std::size_t next = 0;
    write(field, point, [&](const Quantity<B>& value) {
      RowCell& cell = cells[next++];
      if (cell.printed) return;
      cell.printed = value.defined ? number_cell(value.value, notation, field.kind, row.segment.decimals)
                                   : std::optional(Printed{empty_cell});
      cell.may_be_zero = cell.may_be_zero || (value.defined && value.value.may_be_zero());
    });
  }

  /// Decides cells by the numbers of a field at an inner place, or null if it has none there. Numbers that no ball
  /// shows are `other` at the last precision alone.
  void look_at(std::span<AlongSegment> cells, const FieldCells& field, Point<B>* point, bool is_first) {
    using enum AlongSegment;
    std::vector<AlongSegment> here(cells.size(), B::Ops::is_last() || point == nullptr ? other : open);
    std::size_t next = 0;
    if (point != nullptr) {
      write(field, *point, [&](const Quantity<B>& value) {
        AlongSegment& cell = here[next++];
        if (!value.defined) {
          cell = empty;
        } else if (value.value.is_zero_at_last()) {
          cell = zero;
        } else if (!value.value.may_be_zero()) {
          cell = other;
        }
      });
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (B::Ops::is_last()) {
        cells[i] = (is_first && cells[i] == open) || cells[i] == here[i] ? here[i] : other;
      } else if (here[i] == other) {
        cells[i] = other;
      }
    }
  }

  /// Passes the numbers of a field to a function, up to one that balls do not decide.
  void write(const FieldCells& field, Point<B>& point, const typename CellWriter<B>::Next& next) {
    try {
      (field.write == nullptr ? write_sample_time<B> : field.write)(point, CellWriter<B>(next, rows_.facts));
    } catch (const Undecided&) {  // the cells from here on stay as they are
    }
  }

  const RowsOfCurve& rows_;
  const bool measured_;
  std::vector<FieldCells> fields_;
  RowPoint<B> point_;
  std::optional<bool> at_end_;
};

}  // namespace

std::unique_ptr<BallRows> BallRows::in_double_doubles(const RowsOfCurve& rows, const std::vector<std::size_t>& chosen) {
  try {
    return std::make_unique<Rows<spline::DoubleDouble>>(rows, chosen);
  } catch (const Undecided&) {
    return nullptr;
  }
}

std::unique_ptr<BallRows> BallRows::in_reals(const RowsOfCurve& rows, const std::vector<std::size_t>& chosen) {
  return std::make_unique<Rows<Real>>(rows, chosen);
}

}  // namespace tcb
