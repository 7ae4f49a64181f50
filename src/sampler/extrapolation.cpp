// Extrapolation: which place on the curve stands for a time before its first key or after its last.
#include "sampler/extrapolation.hpp"

#include <cmath>

namespace tcb::sampler {
namespace {

/// A time as so many whole periods and a rest in [0, period).
struct Divided {
  double periods;
  Time rest;
};

Divided divide(const Time& t, const Time& period) {
  double periods = std::floor((t / period).hi);
  Time rest = t - Time(periods) * period;
  // The quotient was rounded; the rest says whether it was right.
  if (rest < Time(0.0)) {
    periods -= 1;
    rest = rest + period;
  } else if (rest >= period) {
    periods += 1;
    rest = rest - period;
  }
  return {periods, rest};
}

}  // namespace

Outside map_to_curve(Extrapolation kind, const Time& first, const Time& last, const Time& t) {
  if (t >= first && t <= last) return {t};
  const bool before = t < first;
  const Time& end = before ? first : last;
  if (kind == Extrapolation::hold) return {end, 0, 0.0, true};
  if (kind == Extrapolation::linear) return {end, 0, t - end};
  const Time period = last - first;
  const auto [periods, rest] = divide(t - first, period);
  if (kind == Extrapolation::repeat) return {first + rest};
  if (kind == Extrapolation::offset) return {first + rest, periods};
  const bool backward = std::floor(periods / 2) * 2 != periods;
  return {backward ? last - rest : first + rest, 0, 0.0, false, backward};
}

}  // namespace tcb::sampler
