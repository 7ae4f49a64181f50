// Compare job: which samples are compared with which curves, how close they have to be, and the report.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "run/key_options.hpp"
#include "schema/columns.hpp"
#include "schema/curve_settings.hpp"
#include "schema/format.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// A request to compare the samples in a file with the curves of keys.
struct Comparison {
  std::string keys_file;  ///< "-" is standard input
  KeyOptions keys;
  std::string file;                      ///< of the samples; "-" is standard input
  std::vector<Renaming> maps;            ///< of its columns
  std::vector<Tolerance> abs, rel, ulp;  ///< a number has to be within one of the three
  std::vector<std::size_t> fields;  ///< that are compared, as indices into fields(); none: all that the samples have
  bool from_left = true;            ///< a sample at a key is on the segment before it, not on the one after
  ThreadOptions threads;
  std::optional<TimeZero> time_zero = {};      ///< from which the times of samples count
  std::optional<SampleOptions> expected = {};  ///< the samples that the file should have, no fewer and no more
};

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
