// Wanted: what can be measured of a curve by name, and which of these measures are asked for.
#pragma once

#include <string>
#include <vector>

#include "limits/limit_options.hpp"
#include "limits/report.hpp"
#include "sample/curve_spec.hpp"

namespace tcb::limits {

/// What is asked for, with its limits; without any names all measures. Throws: Error (usage) for a limit of something
/// that the curve does not have.
std::vector<LimitResult> wanted_of(const LimitOptions& options, const CurveSpec& spec,
                                   const std::vector<std::string>& channels, const std::vector<std::string>& title);

}  // namespace tcb::limits
