// Extrapolation: from a time before the first key or after the last to a time on the curve, at any scalar.
#pragma once

#include <cmath>

#include "numbers/rational.hpp"
#include "schema/curve_settings.hpp"
#include "tcb/spline/double_double.hpp"

namespace tcb {

/// The relation of a time outside the curve to one inside.
template <class S>
struct OutsideOf {
  spline::Time<S> t;                            ///< the time on the curve
  S cycles = S(0);                              ///< for offset: how often last key - first key is added
  spline::Time<S> beyond = spline::Time<S>(0);  ///< for linear: time after the last key, negative before the first
  bool holds = false;                           ///< all derivatives are 0
  bool backward = false;                        ///< time on the curve decreases
  bool odd = false;                             ///< for repeat: the number of periods to t
};
using Outside = OutsideOf<double>;

/// A time after the first key as whole periods and a rest in [0, period).
template <class S>
struct WholePeriods {
  S periods;
  bool odd;
  spline::Time<S> rest;
};

template <class S>
WholePeriods<S> divide_by_period(const spline::Time<S>& t, const spline::Time<S>& first,
                                 const spline::Time<S>& period) {
  const S passed = t - first;
  const S periods = floor(S(passed / period));
  return {periods, floor(S(periods / S(2))) * S(2) != periods, passed - periods * period};
}

inline WholePeriods<double> divide_exactly(const Rational& t, const Rational& period) {
  const Rational periods = floor(t / period);
  return {nearest_double(periods), floor(periods / 2) * 2 != periods, nearest_time(t - periods * period)};
}

/// For doubles: by double-double arithmetic where it is certain, else by exact rationals.
template <>
inline WholePeriods<double> divide_by_period<double>(const Time& t, const Time& first, const Time& period) {
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

/// Requires: first < last; the extrapolation of t's side is not error, or t lies on the curve.
template <class S>
OutsideOf<S> map_to_curve(const Extrapolations& rules, const spline::Time<S>& first, const spline::Time<S>& last,
                          const spline::Time<S>& t) {
  using T = spline::Time<S>;
  if (t >= first && t <= last) return {t};
  const T& end = t < first ? first : last;
  const Extrapolation kind = t < first ? rules.before : rules.after;
  if (kind == Extrapolation::hold || first == last) return {end, S(0), T(0), true};
  if (kind == Extrapolation::linear) return {end, S(0), t - end};
  const auto [periods, odd, rest] = divide_by_period<S>(t, first, last - first);
  if (kind == Extrapolation::repeat) return {first + rest, S(0), T(0), false, false, odd};
  if (kind == Extrapolation::offset) return {first + rest, periods};
  return {odd ? T(last - rest) : T(first + rest), S(0), T(0), false, odd};
}

}  // namespace tcb
