// Axis: a range of numbers relative to a round base, with round numbers as its ticks.
#include "plot/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace tcb {
namespace {

/// 10^exponent, to a few units in the last place.
double power_of_ten(int exponent) {
  double power = 1;
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
  return exponent < 0 ? 1 / power : power;
}

/// The exponent of the smallest power of ten that is not less than a number, up to rounding.
int exponent_above(double size) {
  int exponent = 0;
  for (double rest = size; rest > 1; rest /= 10) ++exponent;
  for (double rest = size * 10; rest <= 1 && exponent > -307; rest *= 10) --exponent;
  return exponent;
}

/// A whole multiple of a power of ten in the exponent notation, as in 2.5e9.
std::string exponent_text(std::int64_t multiple, int exponent) {
  if (multiple == 0) return "0";
  std::string digits = std::to_string(std::abs(multiple));
  exponent += static_cast<int>(digits.size()) - 1;
  digits.resize(digits.find_last_not_of('0') + 1);
  if (digits.size() > 1) digits.insert(1, ".");
  return fmt::format("{}{}e{}", multiple < 0 ? "-" : "", digits, exponent);
}

}  // namespace

std::string decimal_text(const std::string& whole, int exponent) {
  const bool negative = whole.front() == '-';
  std::string digits = negative ? whole.substr(1) : whole;
  if (digits == "0") return digits;
  if (exponent >= 0) return whole + std::string(static_cast<std::size_t>(exponent), '0');
  const auto decimals = static_cast<std::size_t>(-exponent);
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  digits.insert(digits.size() - decimals, ".");
  return (negative ? "-" : "") + digits;
}

Axis::Axis(const Interval& interval, double margin) {
  const double size = interval.length();
  const double largest = std::max(std::abs(interval.low.hi), std::abs(interval.high.hi));
  constexpr double many_digits = 1e4;  // the ratio of number to length from which digits that do not change are omitted
  if (size > 0 && largest >= many_digits * size) {
    const int exponent = exponent_above(size);
    const Rational unit = *parse_rational(fmt::format("1e{}", exponent));
    const Rational whole = floor(exact_time(interval.low) / unit);
    base_ = nearest_time(whole * unit);
    base_text_ = decimal_text(whole_text(whole), exponent);
  }
  low_ = from_base(interval.low);
  high_ = from_base(interval.high);
  // A single number is in the middle of an axis.
  const double half = size > 0 ? margin * size : largest > 0 ? largest / 2 : 1;
  low_ -= half;
  high_ += half;
}

void Axis::set_length(double length) {
  const double middle = low_ + (high_ - low_) / 2;
  low_ = middle - length / 2;
  high_ = middle + length / 2;
}

std::string Axis::title(std::string_view name) const {
  if (base_text_.empty() || base_text_ == "0") return std::string(name);
  const bool negative = base_text_.front() == '-';
  return fmt::format("{} {} {}", name, negative ? "+" : "−", base_text_.substr(negative ? 1 : 0));
}

std::vector<Tick> Axis::ticks(double most) const {
  int exponent = exponent_above(length() / most) - 1;
  int factor = 1;
  const auto step = [&] { return factor * power_of_ten(exponent); };
  constexpr double slack = 1e-9;  // an end of the axis may be a tick
  const auto first = [&] { return static_cast<std::int64_t>(std::ceil(low_ / step() - slack)); };
  const auto last = [&] { return static_cast<std::int64_t>(std::floor(high_ / step() + slack)); };
  while (static_cast<double>(last() - first() + 1) > most) {
    factor = factor == 1 ? 2 : factor == 2 ? 5 : 1;
    if (factor == 1) ++exponent;
  }
  while (static_cast<double>(last() - first()) * step() < length() / 2) {  // two ticks far apart show the scale
    factor = factor == 5 ? 2 : factor == 2 ? 1 : 5;
    if (factor == 5) --exponent;
  }
  const std::int64_t stride = static_cast<double>(last() - first()) < most ? 1 : last() - first();
  const double largest = static_cast<double>(std::max(std::abs(first()), std::abs(last()))) * step();
  const bool plain = largest < 1e6 && largest > 1e-4 && exponent >= -8;
  std::vector<Tick> ticks;
  for (std::int64_t i = first(); i <= last(); i += stride) {
    const std::int64_t multiple = i * factor;
    const double value = exponent < 0 ? static_cast<double>(multiple) / power_of_ten(-exponent)
                                      : static_cast<double>(multiple) * power_of_ten(exponent);
    ticks.push_back(
        {value, plain ? decimal_text(std::to_string(multiple), exponent) : exponent_text(multiple, exponent)});
  }
  return ticks;
}

}  // namespace tcb
