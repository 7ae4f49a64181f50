// Compare job: checks samples, or identifies the rules that made them, from both files to the report.
#pragma once

#include <string>
#include <vector>

#include "check/comparison.hpp"
#include "error.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "schema/format.hpp"

namespace tcb {

/// A report on samples.
struct CompareJob {
  Comparison comparison;
  bool identify = false;  ///< rank the conventions by their agreement with the samples; otherwise check these
  std::string output = "-";
  const Format* format = nullptr;  ///< JSON or a picture; others: the report is text
  PictureOptions picture;
  Verbosity verbosity;
  std::vector<std::string> other_inputs = {};  ///< files that were read before; the output replaces none
};

/// Compares and writes the report. Returns Exit::data if the samples do not agree with the curve.
/// Throws: Error, naming the file.
Exit compare(const CompareJob& job);

}  // namespace tcb
