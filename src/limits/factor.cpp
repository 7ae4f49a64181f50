// Factor: how much slower a curve has to be, so that all limits hold.
#include "limits/factor.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "limits/polynomial.hpp"

namespace tcb::limits {
namespace {

/// The smallest number of 14 digits whose power is at least x. Requires: x > 0.
Rational root_above(const Rational& x, int power) {
  Rational unit = 1, root = 0;
  while (power_of(unit, power) <= x) unit *= 10;
  while (power_of(unit / 10, power) > x) unit /= 10;
  for (int digit = 0; digit < 14; ++digit) {
    unit /= 10;
    while (power_of(root + unit, power) < x) root += unit;
  }
  return root + unit;
}

}  // namespace

Rational factor_within(const LimitsReport& report, bool fits) {
  if (report.passed() && !fits) return 1;
  struct Pace {
    Rational ratio;  ///< of the maximum to its limit
    int power;       ///< of the factor, by which the maximum becomes smaller
    std::string name;
  };
  std::vector<Pace> least, most;  // what the factor has to reach, and what it cannot exceed
  const auto refuse = [](const std::string& name, std::string_view reason) {
    return data_error("no factor of the times meets the limit of {}: {}; give another limit", name, reason)
        .about("--limits");
  };
  for (const LimitResult& result : report.results) {
    if (!result.limit || !result.extreme) continue;
    const Measure& measure = result.measure;
    if (result.is_broken) throw refuse(measure.name, "the velocity jumps");
    if (measure.derivative == 0 && !result.passed) throw refuse(measure.name, "it does not depend on time");
    if (measure.derivative == 0) continue;
    const Rational limit = measure.as_measured(*result.limit), &high = result.extreme->high;
    const int power = measure.derivative * (measure.is_size() ? 2 : 1);
    if (limit < 0) {  // slower is farther from it
      if (!result.passed) throw refuse(measure.name, "the curve is too slow");
      most.push_back({high / limit, power, measure.name});
    } else if (high > 0) {
      if (limit == 0) throw refuse(measure.name, "only rest would meet it");
      least.push_back({high / limit, power, measure.name});
    }
  }
  if (least.empty()) {
    throw data_error("no limit depends on the pace; expected one of a speed, acceleration or jerk; add one")
        .about("--limits");
  }
  Rational factor = fits ? 0 : 1;
  for (const Pace& pace : least) {
    const double ratio = nearest_double(pace.ratio);
    if (!std::isfinite(ratio) || ratio < 1e-300) throw refuse(pace.name, "it is too far from the maximum");
    const Rational margin = power_of(Rational(1 + 0x1p-44), pace.power);
    factor = std::max(factor, root_above(pace.ratio * margin, pace.power));
  }
  for (const Pace& pace : most) {
    if (power_of(factor, pace.power) > pace.ratio) throw refuse(pace.name, "slower times break it");
  }
  if (factor != 1 && report.has_ends_by_seconds) {
    throw usage_error(
        "the end rule lightwave depends on 1/3600 of a second, so that other times make another curve; name another "
        "end rule with --ends")
        .about("--retime");
  }
  return factor;
}

}  // namespace tcb::limits
