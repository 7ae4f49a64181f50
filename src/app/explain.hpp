// What was found in a file and would be done with it, a line each.
#pragma once

#include <string>

#include "app/curve_pipeline.hpp"
#include "app/job.hpp"

namespace tcb {

/// Reads the keys of a file and places the samples of its curves, but works none of them out.
/// Throws: Error as resample() does.
std::string explanation(const std::string& path, const Job& plan);

/// How far the end lies behind the last row, and what to do about it; empty where it does not.
std::string left_out(const Placed& placed);

}  // namespace tcb
