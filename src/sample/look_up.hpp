// Look up: rows in any order on a kept curve, also outside it.
#pragma once

#include <memory>
#include <vector>

#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "sample/shown_curve.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The times with those of the curve's keys in the range; a time within a billionth of a step of a key is dropped.
std::vector<Time> with_keys(const std::vector<Time>& times, const spline::Curve<double>& curve, const Time& from,
                            const Time& to);

/// The rows of a locator in order, in blocks. `side`: of a key, the segment on which a row there is.
Source<SampleBlock> look_up(const std::shared_ptr<const ShownCurve>& curve,
                            const std::shared_ptr<const AnywhereInTime>& rows, spline::Side side);
Source<SampleBlock> look_up(const std::shared_ptr<const ShownCurve>& curve,
                            const std::shared_ptr<const AnywhereInLength>& rows, spline::Side side);

}  // namespace tcb
