// Comparing someone's samples with the curve, from the files to the report.
#pragma once

#include "app/job.hpp"
#include "error.hpp"

namespace tcb {

/// Writes the report. The exit code is that of rejected data where the samples are not as they should be.
/// Requires: plan.comparison. Throws: Error, naming the file.
Exit compare(const Job& plan);

}  // namespace tcb
