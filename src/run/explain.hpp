// Explanation: what was detected in a file and will be done with it, one fact per line.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "error.hpp"
#include "io/input_list.hpp"
#include "run/job.hpp"
#include "schema/format.hpp"

namespace tcb {

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

}  // namespace tcb
