// Kept curves through given keys, for tests of rows on them.
#pragma once

#include "sample/build.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb {

inline KeptCurve kept_curve_of(const spline::Curve<double>& curve) {
  return {curve, {}, {curve.times().front(), curve.times().back(), {}, curve.is_closed(), 0}};
}

}  // namespace tcb
