// Smooth fits: positions and slopes of keys at given times, so that the largest distance from the samples is small.
//
// The curve between two keys is the cubic with their positions and slopes, so that the curve and its slope are
// continuous. Least squares give both, by a banded system; then samples that are far get more weight, and so on.
// Source: C. L. Lawson, "Contributions to the theory of linear least maximum approximation", 1961, for the weights.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fit/recording.hpp"

namespace tcb {

/// A key that is being fitted. Shapes: a position and a slope, per unit of time, for each channel.
struct FitKey {
  std::size_t sample = 0;  ///< at whose time it is
  std::vector<double> position, slope;
};

/// Which of the two outer keys of a fit stay as they are.
struct FixedEnds {
  bool first = false, last = false;
};

/// How hard a fit is tried.
struct FitEffort {
  int most_weightings = 14;  ///< how often samples are weighted again
  double stiffness = 1e-6;   ///< weight of the plain slope of a key, relative to the mean weight of a sample
  bool gives_up = true;      ///< where the tolerances seem to be out of reach for some segment
};

/// Sets positions and slopes of the keys, which have samples that increase. Returns the largest distance of the samples
/// of each segment, those at its two keys included, in tolerances; stops where it is at most 1.
/// Where a fit is given up, distances may be those of some samples only.
std::vector<double> fit_smoothly(const Recording& recording, std::span<FitKey> keys, FixedEnds fixed,
                                 const FitEffort& effort = {}, unsigned threads = 1);

}  // namespace tcb
