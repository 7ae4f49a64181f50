// Axis: a range of numbers or times relative to a round base, with round ones as its ticks.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"

namespace tcb {

/// The smallest and the largest of some numbers, or of some times.
struct Interval {
  Time low{1.0}, high{-1.0};
  bool empty() const { return high < low; }
  double length() const { return (high - low).hi; }
  void include(const Time& value) {
    const bool first = empty();
    if (first || value < low) low = value;
    if (first || value > high) high = value;
  }
};

/// How the times of an axis are written.
struct TimeScale {
  TimeNotation notation = TimeNotation::seconds;
  Rational frames_per_second = 1;                 ///< of timecode
  DateFormat dates = {};                          ///< of dates
  std::optional<Rational> units_per_second = {};  ///< of times that are shown in seconds
};

/// The size of the larger end of an interval.
double size_of(const Interval& interval);

/// A number on an axis with its text.
struct Tick {
  double value;  ///< relative to the base, in units of the axis
  std::string text;
};

/// Numbers that share many leading digits are shown without them, relative to a round base.
class Axis {
 public:
  Axis() = default;
  /// Covers the interval, and `margin` of its length on either side, in units that suit numbers of the size `besides`
  /// too. Requires: a finite length.
  Axis(const Interval& interval, double margin, double besides = 0);
  /// Covers an interval of times. Requires: as above.
  Axis(const Interval& times, TimeScale scale);

  /// A number relative to the base, in units of the axis.
  double from_base(const Time& value) const { return in_units((value - base_).hi); }
  /// A difference of numbers in units of the axis.
  double in_units(double difference) const { return difference / units_; }
  double low() const { return low_; }
  double length() const { return high_ - low_; }
  /// Changes the length around the middle.
  void set_length(double length);

  /// What the ticks show: the name, less the base if that is not 0, as in "time − 1731931200".
  std::string title(std::string_view name) const;
  /// At most `most` ticks, at multiples of 1, 2 or 5 times a power of ten. Requires: most >= 2.
  std::vector<Tick> ticks(double most) const;

 private:
  std::vector<Tick> ticks_in_words(double most) const;
  std::vector<Tick> ticks_at_months(const Rational& low, const Rational& high, double most) const;
  std::string words(const Rational& time, const Rational& step) const;
  Tick tick_in_words(double at, const Rational& step) const;

  Time base_{0.0};
  std::string base_text_;
  int exponent_ = 0;  ///< a unit of the axis is a unit of its texts times this power of ten
  double units_ = 1;  ///< of numbers, in one of the axis
  std::optional<TimeScale> scale_;
  std::string day_;  ///< of all times, where these are dates of one day
  double low_ = 0, high_ = 1;
};

/// whole · 10^exponent in decimal digits, with as many decimals as the exponent requires, or if it is short, without
/// zeros at its end.
std::string decimal_text(const std::string& whole, int exponent, bool is_short = false);

}  // namespace tcb
