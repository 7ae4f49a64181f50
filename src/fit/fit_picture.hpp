// Pictures of fits: the recording over the curve of its keys, and their differences over time.
#pragma once

#include "error.hpp"
#include "fit/fit_job.hpp"

namespace tcb {

/// Fits the recordings of the one input of a job, and writes the picture.
/// Throws: Error, naming the file.
Exit draw_fit(const FitJob& job);

}  // namespace tcb
