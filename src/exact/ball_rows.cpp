// Ball rows: the numbers of rows that double-doubles with bounds on their errors can round, which are nearly all.
#include "exact/ball_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "exact/ball.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/derivatives.hpp"

namespace tcb {
namespace {

/// The fields that balls compute.
enum class BallField { time, position, velocity, acceleration, jerk, segment, u, key };
struct BallFieldName {
  std::string_view name;
  BallField field;
};
constexpr std::array ball_fields{BallFieldName{"time", BallField::time},
                                 BallFieldName{"position", BallField::position},
                                 BallFieldName{"velocity", BallField::velocity},
                                 BallFieldName{"acceleration", BallField::acceleration},
                                 BallFieldName{"jerk", BallField::jerk},
                                 BallFieldName{"segment", BallField::segment},
                                 BallFieldName{"u", BallField::u},
                                 BallFieldName{"key", BallField::key}};

/// A ball around a rational: the nearest double and the double nearest to the rest are within 2^-105 of it. The product
/// with 1 refuses what is out of range.
Ball ball_of(const Rational& value) {
  const double high = nearest_double(value);
  if (high == 0) return value == 0 ? Ball() : throw Undecided();
  const Rational rest = value - Rational(high);
  if (rest == 0) return Ball(high);
  const double low = nearest_double(rest);
  const spline::DoubleDouble middle = spline::DoubleDouble::normalized(high, low);
  return Ball(middle, Rational(low) == rest ? 0 : 0x1p-104 * std::abs(high)) * Ball(1.0);
}

/// A ball around a time, which is a double or the sum of two.
Ball ball_of(const Time& time) { return Ball(spline::DoubleDouble(time.hi, time.lo)); }

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
  (void)std::frexp(size, &binary);
  int exponent = static_cast<int>(std::floor((binary - 1) * 0.30103));  // of ten: that of the number, or one less
  Ball digits = scaled_by_ten_to(abs(number), notation.count - 1 - exponent);
  std::int64_t end = 1;
  for (int i = 0; i < notation.count; ++i) end *= 10;
  for (; digits.middle().hi >= static_cast<double>(end); ++exponent) {
    digits = scaled_by_ten_to(abs(number), notation.count - 2 - exponent);
  }
  auto whole = whole_nearest_to(digits);
  if (!whole || *whole < end / 10) return std::nullopt;
  if (*whole == end) {
    *whole /= 10;
    ++exponent;
  }
  return digits_text(std::to_string(*whole), exponent, notation.count, negative);
}

/// The keys of a curve as balls.
spline::Keys<Ball> ball_keys(const ExactCurve& exact) {
  const auto ball = [](const Rational& value) { return ball_of(value); };
  spline::Keys<Ball> keys;
  keys.channels = exact.keys.channels;
  keys.given = exact.keys.given;
  keys.missing = exact.keys.missing;
  std::ranges::transform(exact.keys.times, std::back_inserter(keys.times), ball);
  std::ranges::transform(exact.keys.positions, std::back_inserter(keys.positions), ball);
  for (const auto& [tension, continuity, bias] : exact.keys.tcbs) {
    keys.tcbs.push_back({ball(tension), ball(continuity), ball(bias)});
  }
  for (const auto& [in, out] : exact.keys.eases) keys.eases.push_back({ball(in), ball(out)});
  for (const auto& [in, out] : exact.keys.velocities) keys.velocities.push_back({ball(in), ball(out)});
  return keys;
}

using Cells = std::vector<std::optional<Printed>>;

class Rows final : public BallRows {
 public:
  Rows(const RowsOfCurve& rows, std::vector<BallField> fields)
      : exact_(rows.exact),
        fields_(std::move(fields)),
        curve_(ball_keys(exact_), spline::converted<Ball>(exact_.rules, [](const Rational& x) { return ball_of(x); }),
               exact_.end ? std::optional(ball_of(*exact_.end)) : std::nullopt) {}

  bool set(const FastRow& row, const Notation& notation, Cells& cells) override {
    cells.clear();
    try {
      if (!place(row)) return false;
      for (const BallField field : fields_) append_field(field, row, notation, cells);
      return true;
    } catch (const Undecided&) {
      return false;
    }
  }

 private:
  /// Places a row on its segment; false for one beside it.
  bool place(const FastRow& row) {
    const Time& shown = row.sample.t;
    const bool is_on_segment = shown >= row.segment.start && shown <= row.segment.end;
    if (row.end != nullptr || !is_on_segment) return false;
    set_segment(row.segment.number);
    const Ball& start = segment_.times[0];
    const Ball& end = segment_.times[1];
    if (row.time) {
      time_ = ball_of(*row.time);
      if (time_ < start || time_ > end) return false;
    } else if (exact_.decimal || exact_.channels.frames) {
      time_ = ball_of(exact_number(shown, exact_.decimal, exact_.channels.frames));
    } else {
      time_ = ball_of(shown);
    }
    const bool is_key = !row.time && (shown == row.segment.start || shown == row.segment.end);
    if (is_key) {
      at_ = shown == row.segment.start ? spline::LocalParameter<Ball>{Ball(0.0), Ball(-1.0)}
                                       : spline::LocalParameter<Ball>{Ball(1.0), Ball(0.0)};
    } else {
      at_ = spline::TimeMap<Ball>(start, end, segment_.warp(0))(time_);
    }
    has_derivatives_ = false;
    return true;
  }

  void set_segment(std::size_t number) {
    if (number_ == number) return;
    number_.reset();
    segment_ = curve_.segments(number, number + 1);
    number_ = number;
  }

  void append_field(BallField field, const FastRow& row, const Notation& notation, Cells& cells) {
    const bool at_start = at_.u.is_zero(), at_end = at_.w.is_zero();
    switch (field) {
      case BallField::time: cells.push_back(time_cell(row, notation)); break;
      case BallField::segment: cells.push_back(Printed{Cell(static_cast<double>(row.segment.number))}); break;
      case BallField::key:
        cells.push_back(at_start ? Printed{Cell(static_cast<double>(row.segment.number))}
                        : at_end ? Printed{Cell(static_cast<double>(end_key(row)))}
                                 : Printed{empty_cell});
        break;
      case BallField::u: cells.push_back(number_cell(at_start || at_end ? at_.u : u(), notation)); break;
      case BallField::position:
        for (const spline::Cubic<Ball>& cubic : segment_[0]) {
          cells.push_back(number_cell(spline::position(cubic, at_), notation));
        }
        break;
      default:
        for (const Ball& number : derivatives(field)) cells.push_back(number_cell(number, notation));
    }
  }

  std::size_t end_key(const FastRow& row) const {
    const bool closes = row.segment.number + 1 == curve_.size() && curve_.is_closed();
    return closes ? 0 : row.segment.number + 1;
  }

  Ball u() const { return (time_ - segment_.times[0]) / (segment_.times[1] - segment_.times[0]); }

  const std::vector<Ball>& derivatives(BallField field) {
    if (!std::exchange(has_derivatives_, true)) {
      const bool at_key = at_.u.is_zero() || at_.w.is_zero();
      spline::set_derivatives<Ball>(derivatives_, segment_[0], at_, segment_.warp(0), at_key ? at_.u : u(),
                                    segment_.times[1] - segment_.times[0]);
    }
    return field == BallField::velocity       ? derivatives_.velocity
           : field == BallField::acceleration ? derivatives_.acceleration
                                              : derivatives_.jerk;
  }

  static bool has_text(const Notation& notation) {
    return notation.kind == Notation::Kind::digits || notation.kind == Notation::Kind::fixed;
  }

  Printed time_cell(const FastRow& row, const Notation& notation) const {
    const Time& shown = row.sample.t;
    const bool is_shown =
        !row.time && shown.lo == 0 && row.segment.decimals == 0 && !exact_.decimal && !exact_.channels.frames;
    if (is_shown && !has_text(notation)) return {shown};
    if (is_shown && std::abs(shown.hi) < whole_times_from) {
      if (auto text = decimal_text(Ball(shown.hi), notation)) return {shown, *std::move(text)};
    }
    const Rounding rounding(notation, CellKind::time, row.segment.decimals);
    if (row.time) return rounding.exactly({*row.time});
    return rounding.exactly(
        {shown.lo == 0 ? exact_number(shown, exact_.decimal, exact_.channels.frames) : exact_time(shown)});
  }

  static std::optional<Printed> number_cell(const Ball& number, const Notation& notation) {
    if (!has_text(notation)) {
      return rounds_to_one_double(number) ? std::optional(Printed{Cell(number.middle().hi)}) : std::nullopt;
    }
    if (rounds_to_one_double(number)) {
      if (auto text = decimal_text(number, notation)) return Printed{Cell(number.middle().hi), *std::move(text)};
    }
    const Rational middle = Rational(number.middle().hi) + Rational(number.middle().lo), radius(number.radius());
    return Rounding(notation, CellKind::real).within(middle - radius, middle + radius);
  }

  const ExactCurve& exact_;
  const std::vector<BallField> fields_;
  const spline::CurveKeys<Ball> curve_;
  std::optional<std::size_t> number_;  ///< of the current segment
  spline::Segments<Ball> segment_;
  Ball time_;
  spline::LocalParameter<Ball> at_;
  spline::Derivatives<Ball> derivatives_;
  bool has_derivatives_ = false;
};

}  // namespace

std::unique_ptr<BallRows> BallRows::of(const RowsOfCurve& rows, std::span<const std::size_t> chosen) {
  const ExactCurve& exact = rows.exact;
  const bool is_plain = exact.is_rational() && exact.rules.rotations.empty() && exact.rules.angles.empty();
  if (rows.arc || !is_plain) return nullptr;
  std::vector<BallField> ball;
  for (const std::size_t index : chosen) {
    const auto* const known = std::ranges::find(ball_fields, fields()[index].name, &BallFieldName::name);
    if (known == ball_fields.end()) return nullptr;
    ball.push_back(known->field);
  }
  try {
    return std::make_unique<Rows>(rows, std::move(ball));
  } catch (const Undecided&) {
    return nullptr;
  }
}

}  // namespace tcb
