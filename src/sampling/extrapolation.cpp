// Extrapolation: which place on the curve stands for a time before its first key or after its last.
#include "sampling/extrapolation.hpp"

#include <cmath>

namespace tcb {
namespace {

/// A time as so many whole periods and a rest in [0, period).
struct Divided {
  double periods;
  bool odd;
  Time rest;
};

Divided divide_exactly(const Rational& t, const Rational& period) {
  const Rational periods = floor(t / period);
  return {nearest_double(periods), floor(periods / 2) * 2 != periods, nearest_time(t - periods * period)};
}

Divided divide(const Time& t, const Time& first, const Time& period) {
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

}  // namespace

Outside map_to_curve(Extrapolation kind, const Time& first, const Time& last, const Time& t) {
  if (t >= first && t <= last) return {t};
  const bool before = t < first;
  const Time& end = before ? first : last;
  if (kind == Extrapolation::hold || first == last) return {end, 0, 0.0, true};
  if (kind == Extrapolation::linear) return {end, 0, t - end};
  const Time period = last - first;
  const auto [periods, backward, rest] = divide(t, first, period);
  if (kind == Extrapolation::repeat) return {first + rest};
  if (kind == Extrapolation::offset) return {first + rest, periods};
  return {backward ? last - rest : first + rest, 0, 0.0, false, backward};
}

}  // namespace tcb
