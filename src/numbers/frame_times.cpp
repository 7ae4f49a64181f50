// Frame times: the exact times that the texts of times name, with the digits that doubles omit.
#include "numbers/frame_times.hpp"

#include "numbers/decimal_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tcb {
namespace {

constexpr std::int64_t parts_of_frame = 1000;
constexpr std::int64_t most_ticks = std::int64_t{1}
                                    << 40;  ///< so that a quotient of double-doubles has the nearest double

/// The decimal of a time: that of a double is its shortest one.
LongDecimal named(const Time& time) {
  const auto decimal = exact_decimal_of(time);
  return decimal ? *decimal : decimal_of(time);
}

/// The whole number nearest to a number. Requires: |number| < 2^51.
double rounded_to_whole(double number) {
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  return (number + round_to_whole) - round_to_whole;
}

constexpr int micro = 6;

/// A time in microseconds, where that is the whole number that its shortest decimal names, as those of most dates are:
/// below 2^51 the times of two such numbers are two doubles.
std::optional<std::int64_t> microseconds(const Time& time) {
  constexpr double in_second = 1e6;
  if (time.lo != 0 || !(std::abs(time.hi) < 0x1p51 / in_second)) return std::nullopt;
  const double number = rounded_to_whole(time.hi * in_second);
  return number / in_second == time.hi ? std::optional(static_cast<std::int64_t>(number)) : std::nullopt;
}

/// units / 10^decimals as the double-double that depends on this quotient alone.
template <class Whole>
Time quotient(Whole units, int decimals) {
  double power = 1;
  for (int i = 0; i < decimals; ++i) {
    if (units % 10 == 0) {
      units /= 10;
    } else {
      power *= 10;
    }
  }
  const auto high = static_cast<double>(units);
  const auto low = static_cast<double>(units - static_cast<Whole>(high));
  return spline::DoubleDouble::normalized(high, low) / Time(power);
}

/// The difference of two decimals as the double-double that depends on it alone.
Time difference(const LongDecimal& a, const LongDecimal& b) {
  __extension__ using Whole = __int128;
  constexpr int most_digits = 37, largest_power = 22;  // of whole numbers, and of powers of ten that are doubles
  const int exponent = a.digits == 0 ? b.exponent : b.digits == 0 ? a.exponent : std::min(a.exponent, b.exponent);
  const auto fits = [&](const LongDecimal& decimal) {
    return decimal.digits == 0 || decimal.size() + decimal.exponent - exponent <= most_digits;
  };
  if (!(fits(a) && fits(b) && exponent <= 0 && exponent >= -largest_power)) {
    const Rational exact = a.value() - b.value();
    const double high = nearest_double(exact);
    return spline::DoubleDouble::normalized(high, nearest_double(exact - Rational(high)));
  }
  const auto whole = [&](const LongDecimal& decimal) {
    auto digits = static_cast<Whole>(decimal.digits);
    for (int i = exponent; digits != 0 && i < decimal.exponent; ++i) digits *= 10;
    return decimal.negative ? -digits : digits;
  };
  const Whole units = whole(a) - whole(b);
  const auto few = static_cast<std::int64_t>(units);
  return few == units ? quotient(few, -exponent) : quotient(units, -exponent);
}

}  // namespace

FrameTimes FrameTimes::decimals() {
  FrameTimes times;
  times.are_decimals_ = true;
  return times;
}

FrameTimes::FrameTimes(const Rational& rate, const Rational& start) {
  set_start(start);
  const Rational parts = rate * parts_of_frame;
  if (numerator(parts) > most_ticks || denominator(parts) > most_ticks) return;
  ticks_ = nearest_double(numerator(parts));
  seconds_ = nearest_double(denominator(parts));
}

FrameTimes FrameTimes::less(const Rational& zero) const {
  FrameTimes times = *this;
  if (ticks_ == 0) return times;
  const Rational part = Rational(seconds_) / Rational(ticks_), start = start_ - zero;
  times.set_start(start - floor(start / part) * part);  // near 0, so that nothing cancels
  return times;
}

void FrameTimes::set_start(const Rational& start) {
  start_ = start;
  near_start_.hi = nearest_double(start);
  near_start_.lo = nearest_double(start - Rational(near_start_.hi));
}

/// The time of a part of a frame since the start.
Time FrameTimes::since_start(double number) const {
  if (number == 0) return {};
  const auto product = spline::two_product(number, seconds_);
  return Time(product.value, product.error) / Time(ticks_);
}

/// The number of the part of a frame to which a double is nearest.
std::optional<double> FrameTimes::number(const Time& time) const {
  if (time.lo != 0 || ticks_ == 0) return std::nullopt;
  const double near = (time - near_start_).hi * ticks_ / seconds_;
  if (!(std::abs(near) < 0x1p51)) return std::nullopt;
  const double number = rounded_to_whole(near);
  return (near_start_ + since_start(number)).hi == time.hi ? std::optional(number) : std::nullopt;
}

std::optional<Rational> FrameTimes::exact(const Time& time) const {
  const auto found = number(time);
  if (!found) return are_decimals_ ? std::optional(exact_time(time)) : std::nullopt;
  return start_ + Rational(*found) * Rational(seconds_) / Rational(ticks_);
}

FrameTimes FrameTimes::from(const Time& origin) const {
  FrameTimes frames = *this;
  frames.origin_ = number(origin).value_or(0);
  frames.decimal_origin_ = origin;
  frames.named_origin_ = named(origin);
  return frames;
}

Time FrameTimes::elapsed(const Time& time) const {
  const auto is_whole = [](const Time& t) { return t.lo == 0 && std::abs(t.hi) <= 0x1p52 && t.hi == std::trunc(t.hi); };
  if (are_decimals_) {
    if (is_whole(time) && is_whole(decimal_origin_)) return Time(time.hi - decimal_origin_.hi);
    const auto micros = microseconds(time), origin = microseconds(decimal_origin_);
    if (micros && origin) return quotient(*micros - *origin, micro);
    return difference(named(time), named_origin_);
  }
  const auto found = number(time);
  return found ? since_start(*found - origin_) : time - near_start_ - since_start(origin_);
}

Time FrameTimes::time(const Time& elapsed) const {
  return are_decimals_ ? elapsed + with_all_digits(decimal_origin_)
                       : as_double(elapsed + since_start(origin_) + near_start_);
}

Time FrameTimes::key_time(const Time& elapsed) const {
  const Time near = time(elapsed);
  if (!are_decimals_ || this->elapsed(near.hi) == elapsed) return as_double(near);
  const Time decimal = tcb::time_of(decimal_of(near));
  if (this->elapsed(decimal) == elapsed) return decimal;
  return rounded_to(Rational(elapsed.hi) + Rational(elapsed.lo) + exact_time(decimal_origin_), digits_of_time);
}

}  // namespace tcb
