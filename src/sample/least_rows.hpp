// A lower bound on the rows that a tolerance needs, from the curvature: so that too many are refused at once.
#pragma once

#include "sample/shown_curve.hpp"

namespace tcb {

/// A lower bound on the number of rows whose polyline stays within the tolerance of the curve; infinite beyond doubles.
double least_rows(const ShownCurve& curve, double tolerance);

}  // namespace tcb
