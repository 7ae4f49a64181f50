// The curve of exact keys at any scalar.
#pragma once

#include <memory>

#include "exact/bounded.hpp"
#include "exact/exact_keys.hpp"
#include "exact/rounding.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/curve_keys.hpp"

namespace tcb {

/// The curve at a scalar. Requires: exact.is_rational(), or a scalar with roots.
template <class S>
std::unique_ptr<const spline::CurveKeys<S>> curve_at(const ExactCurve& exact);

extern template class spline::CurveKeys<Rational>;
extern template class spline::CurveKeys<Bounded>;
extern template class spline::CurveKeys<spline::DoubleDouble>;

}  // namespace tcb
