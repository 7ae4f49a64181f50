// Pipeline: resampling, from the bytes of keys to the bytes of rows, and its explanation.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "error.hpp"
#include "run/job.hpp"
#include "schema/format.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// Rows at the requested places of the curves.
struct ResampleJob : FilesJob {
  SampleOptions samples;
  std::optional<GoldenOptions> golden;  ///< rows are exact, and rounded once
  WriterOptions rows;
};

/// Reads the keys of every file and writes the samples of their curves. Returns the exit code of the program, as
/// convert_files(). Throws: Error, with the file. An incomplete output does not get its name.
Exit resample(const ResampleJob& job);

/// Rows or a picture that are explained instead of made; or only the keys and their curves.
struct ExplainJob {
  InputListOptions files;
  KeyOptions keys;
  SampleOptions samples;
  bool has_samples = true;  ///< the samples are requested, so the explanation has them
  std::optional<GoldenOptions> golden;
  std::vector<std::size_t> fields;  ///< of the rows, as indices into fields()
  const Format* format = nullptr;   ///< of the output; the explanation is JSON if that is
  std::optional<bool> header;       ///< of the output; nothing: as the input has one
};

/// Prints the explanation of each file: reads the keys and places the samples, but evaluates none. Throws: Error as
/// resample() does; what was detected at the beginning of the file is printed all the same.
Exit explain(const ExplainJob& job);

/// Throws: the error that explain() does, but prints nothing.
void require_explained(const ExplainJob& job);

}  // namespace tcb
