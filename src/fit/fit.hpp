// Fit: few keys whose curve stays within tolerances of a recording, checked on the numbers as they are printed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fit/fit_options.hpp"
#include "fit/recording.hpp"
#include "schema/key_block.hpp"

namespace tcb {

/// How often each sample is counted as done, pass by pass, unless a fit is tried again.
inline constexpr std::size_t fit_passes = 6;

/// How a recording is fitted.
struct FitRules {
  FitKeys keys = FitKeys::tcb;
  std::vector<std::size_t> fixed = {};  ///< samples that become keys, as do the first and the last one
  std::optional<double> corner = {};    ///< in degrees: where the samples turn by more, the curve may have a corner
  SamplesDone done = {};                ///< counts each sample about `fit_passes` times
  unsigned threads = 1;                 ///< at most
};

/// The keys of a recording.
struct FitResult {
  Keys keys;                   ///< tension, continuity and bias of each channel, or velocities
  double largest = 0;          ///< the largest distance or angle from a sample, in tolerances
  std::size_t sample = 0;      ///< at which
  std::size_t least_keys = 0;  ///< no curve with fewer is within the tolerances of distances
};

/// The samples between which the curve may have corners.
std::vector<std::size_t> corners_of(const Recording& recording, double degrees);

/// Fits a recording, whose samples have these times. Promises: the curve of the keys with the default rules is within
/// the tolerances at every sample. Nothing where keys with tension, continuity and bias cannot have such a curve.
/// Requires: two samples.
std::optional<FitResult> fit(const Recording& recording, const std::vector<Time>& times, const FitRules& rules);

}  // namespace tcb
