// Limits job: certified maxima of the curves of a file, against limits, from the bytes of keys to the report.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "error.hpp"
#include "limits/limit_options.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "run/key_options.hpp"
#include "sample/request.hpp"
#include "schema/curve_settings.hpp"
#include "schema/format.hpp"

namespace tcb {

struct LimitsJob {
  std::string keys_file;  ///< "-" is standard input
  KeyOptions keys;
  LimitOptions options;
  SamplingRequest part;  ///< its range of times is measured
  std::string output = "-";
  const Format* format = nullptr;  ///< JSON, or a picture; others: the report is text
  PictureOptions picture;
  ThreadOptions threads;
  Verbosity verbosity;
  std::vector<std::string> other_inputs = {};  ///< files that were read before; the output replaces none
};

/// Measures and writes the report. Returns Exit::data if a limit is exceeded. Throws: Error, naming the file.
Exit measure_limits(const LimitsJob& job);

/// How times are scaled, and the keys if they came from standard input.
struct RetimedKeys {
  Retiming retiming;
  std::shared_ptr<const std::string> standard_input;
};

/// The smallest factor of the times, unless it is to fit not below 1, by which all limits hold, and the time of the
/// first key, which stays; notes the factor. Throws: Error, naming the file, for limits that no factor meets.
RetimedKeys retimed_within(LimitsJob job);

}  // namespace tcb
