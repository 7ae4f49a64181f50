// Everything that one run of the program is to do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curves.hpp"
#include "format/format.hpp"
#include "golden/options.hpp"
#include "sampler/request.hpp"
#include "settings.hpp"

namespace tcb {

/// Everything that one run of the program is to do.
struct Plan {
  std::vector<std::string> files;  ///< "-" is standard input
  format::InputOptions input;
  CurveOptions curves;
  CurveSettings curve;
  sampler::Request sampling;
  std::vector<std::size_t> fields;  ///< indices into fields(), in output order
  std::size_t output_format = 0;    ///< index into format::formats()
  std::optional<bool> output_header;
  std::optional<golden::Options> golden;     ///< rows are worked out exactly
  format::Notation notation;                 ///< of numbers that may have a fraction
  bool explain = false;                      ///< say what was found and would be done, and do not
  std::optional<unsigned> jobs;              ///< threads; nothing: all cores, one for a live pipe
  bool notes = false;                        ///< say on standard error what may surprise
  std::string output = "-";                  ///< one output for all files, or
  std::optional<std::string> output_folder;  ///< one for each, in this folder
};

}  // namespace tcb
