// Extrapolation of doubles: the division of a time by the period.
#include "sampling/extrapolation.hpp"

#include <cmath>

#include "text/rational.hpp"

namespace tcb {
namespace {

WholePeriods<double> divide_exactly(const Rational& t, const Rational& period) {
  const Rational periods = floor(t / period);
  return {nearest_double(periods), floor(periods / 2) * 2 != periods, nearest_time(t - periods * period)};
}

}  // namespace

template <>
WholePeriods<double> divide_by_period<double>(const Time& t, const Time& first, const Time& period) {
  const Time passed = t - first;
  const double quotient = (passed / period).hi;
  constexpr double certain = 0x1p40;  // below, the quotient is off by one at most
  if (std::abs(quotient) >= certain) return divide_exactly(exact_time(t) - exact_time(first), exact_time(period));
  double periods = std::floor(quotient);
  Time rest = passed - Time(periods) * period;
  if (rest < Time(0.0)) {
    periods -= 1;
    rest = rest + period;
  } else if (rest >= period) {
    periods += 1;
    rest = rest - period;
  }
  return {periods, std::floor(periods / 2) * 2 != periods, rest};
}

}  // namespace tcb
