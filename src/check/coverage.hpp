// Coverage: how much of a curve the given rows cover, and which of the expected rows are missing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/comparison.hpp"
#include "check/inputs.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

/// The places that the rows of a curve should have, in increasing order: arc lengths if the given rows are at these,
/// otherwise times. Throws: Error if the request does not fit the curve.
std::vector<Time> expected_places(const ExpectedSamples& expected, const Comparison& comparison,
                                  const ComparisonInputs& inputs, const KeptCurve& curve);

/// Compares the rows of a curve with those that are expected. A row counts as the expected one from which it
/// is less than an eighth of the way to the next one, within `limits`, or different only as printed in `notation`.
/// Nothing: they are the same; otherwise the problem.
std::optional<std::string> rows_differ(std::span<const Time> expected, const Places& found, const SampleRows& rows,
                                       const Notation& notation, const Limits& limits);

/// The part of a curve that its rows cover.
Coverage coverage_of(const KeptCurve& curve, const ComparisonInputs& inputs, const WholeCurve& whole,
                     const Places& found);

}  // namespace tcb
