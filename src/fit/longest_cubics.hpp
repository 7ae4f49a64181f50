// Longest cubics: the least number of cubics, connected or not, that stay within the tolerances of a recording.
//
// The longest are taken one after another. No cubic stays within the tolerance of some samples if a weighted
// least squares fit to some of them, whatever the weights, has a weighted mean square error above the square of the
// tolerance; that proves where a cubic ends. So no curve of cubics, with a sample in each, has fewer.
// Source: C. L. Lawson, "Contributions to the theory of linear least maximum approximation", 1961, for the weights; for
//   longest cubics, D. E. McClure, "Nonlinear segmented function approximation and analysis of line patterns", 1975.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/recording.hpp"

namespace tcb {

/// The samples at which the longest cubics begin. Promises: no curve of fewer cubics is within the tolerances of all
/// samples.
std::vector<std::size_t> longest_cubics(const Recording& recording, unsigned threads = 1);

/// The samples near which a recording may change from one cubic to another: in the middle between the last one that a
/// longest cubic reaches, and the first one from which the next cubic does. `cubics`: their number. Smaller tolerances
/// find these samples better; they are used if they need about as few cubics.
std::vector<std::size_t> knots_of(const Recording& recording, std::size_t cubics, unsigned threads = 1);

}  // namespace tcb
