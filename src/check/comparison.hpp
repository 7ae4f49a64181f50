// Comparison: which samples are compared with which curves, and how close they have to be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "run/job.hpp"
#include "schema/columns.hpp"

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
};

}  // namespace tcb
