// Axis: a range of numbers from a round base on, with round numbers as its ticks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/rational.hpp"

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

/// A number on an axis with its text.
struct Tick {
  double value;  ///< from the base on
  std::string text;
};

/// Numbers that have many equal digits are shown without these: from a round base on.
class Axis {
 public:
  Axis() = default;
  /// Covers the interval, and `margin` of its length more on either side. Requires: of finite length.
  Axis(const Interval& interval, double margin);

  /// A number from the base on.
  double from_base(const Time& value) const { return (value - base_).hi; }
  double low() const { return low_; }
  double length() const { return high_ - low_; }
  /// The same middle with another length.
  void set_length(double length);

  /// What the ticks show: the name, less the base where that is not 0, as in "time − 1731931200".
  std::string title(std::string_view name) const;
  /// At most so many ticks, at multiples of 1, 2 or 5 times a power of ten; `most` is 2 at least.
  std::vector<Tick> ticks(double most) const;

 private:
  Time base_{0.0};
  std::string base_text_;
  double low_ = 0, high_ = 1;
};

/// whole · 10^exponent in decimal digits, with as many decimals as the exponent asks for.
std::string decimal_text(const std::string& whole, int exponent);

}  // namespace tcb
