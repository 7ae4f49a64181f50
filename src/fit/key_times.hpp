// Key times: at which samples of a recording keys lie, so that few are enough.
//
// Keys begin a little denser than the longest cubics need them, and move to where the errors of all segments are alike.
// Segments that stay too far from their samples are divided; then each group of segments is tried with one less. Parts
// of long recordings are tried on several threads, and then the segments around the keys between parts. Short
// recordings are tried in several ways, and as long as that finds fewer keys.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/recording.hpp"
#include "fit/smooth_fit.hpp"

namespace tcb {

/// Where keys are tried first: samples, increasing.
struct FirstTimes {
  std::vector<std::size_t> cubics;  ///< from longest_cubics()
  std::vector<std::size_t> knots;   ///< from knots_of()
};

/// Keys of a curve that is within the tolerances at the samples: the fewer ones of two beginnings. `fixed`: samples
/// that have keys, increasing, among them the first and the last one. The keys are the same for any number of threads.
std::vector<FitKey> fitting_keys(const Recording& recording, const FirstTimes& times,
                                 const std::vector<std::size_t>& fixed, const SamplesDone& done = {},
                                 unsigned threads = 1);

}  // namespace tcb
