// Pipeline: resampling, from the bytes of keys to the bytes of rows.
#pragma once

#include <optional>

#include "error.hpp"
#include "io/input_list.hpp"
#include "run/job.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// Rows at the requested places of the curves.
struct ResampleJob {
  InputListOptions files;
  bool fail_fast = false;  ///< stop at the first file that fails
  KeyOptions keys;
  SampleOptions samples;
  std::optional<GoldenOptions> golden;  ///< rows are exact, and rounded once
  WriterOptions rows;
  ThreadOptions threads;
  Verbosity verbosity;
};

/// Reads the keys of every file and writes the samples of their curves. Returns the exit code of the program, as
/// convert_files(). Throws: Error, with the file. An incomplete output does not get its name.
Exit resample(const ResampleJob& job);

}  // namespace tcb
