// Fit: few keys whose curve stays within tolerances of a recording, checked on the numbers as they are printed; and its
// steps, each in the source of its name.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "numbers/rational.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

/// Channels whose distance from the samples, the root of the sum of squares, is limited. For a rotation, the four
/// channels x, y, z, w; the tolerance on them is chosen so that the angle stays within the one that is requested.
struct FitGroup {
  std::vector<std::size_t> channels;
  double tolerance = 0;
  std::optional<double> angle = {};  ///< of rotations: from the samples, in radians

  /// Requires: four channels.
  spline::RotationChannels rotation() const { return {channels[0], channels[1], channels[2], channels[3]}; }
};

/// Samples at increasing times. Shapes: positions holds `channels` numbers per sample, sample after sample.
struct Recording {
  std::size_t channels = 0;
  std::vector<double> times;  ///< from the first one on
  std::vector<double> positions;
  std::vector<FitGroup> groups;                           ///< every channel is in one
  bool starts_at_corner = false, ends_at_corner = false;  ///< where the curve goes on from the sample's position

  std::size_t size() const { return times.size(); }
  double position(std::size_t sample, std::size_t channel) const { return positions[sample * channels + channel]; }
};

/// Is called with a number of samples, while they are fitted.
using SamplesDone = std::function<void(std::size_t)>;

/// Successive samples [first, last).
struct SampleRange {
  std::size_t first = 0, last = 0;
  std::size_t size() const { return last - first; }
};

// longest_cubics.cpp

/// The samples at which the longest cubics begin. Promises: no curve of fewer cubics is within the tolerances of all
/// samples.
std::vector<std::size_t> longest_cubics(const Recording& recording, unsigned threads = 1);

/// The samples near which a recording may change from one cubic to another: in the middle between the last one that a
/// longest cubic reaches, and the first one from which the next cubic does. `cubics`: their number. Smaller tolerances
/// find these samples better; they are used if they need about as few cubics.
std::vector<std::size_t> knots_of(const Recording& recording, std::size_t cubics, unsigned threads = 1);

// smooth_fit.cpp

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

// key_times.cpp

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

/// How often each sample is counted as done, pass by pass, unless a fit is tried again.
inline constexpr std::size_t fit_passes = 6;

/// What the keys carry.
enum class FitKeys { tcb, hermite };

/// How a recording is fitted.
struct FitRules {
  FitKeys keys = FitKeys::tcb;
  std::vector<std::size_t> fixed = {};  ///< samples that become keys, as do the first and the last one
  std::optional<double> corner = {};    ///< in degrees: where the samples turn by more, the curve may have a corner
  SamplesDone done = {};                ///< counts each sample about `fit_passes` times
  unsigned threads = 1;                 ///< at most
};

// key_numbers.cpp

/// A key with the slopes of the segments before and after it.
struct CornerKey {
  std::size_t sample = 0;
  std::vector<double> position, incoming, outgoing;
};

/// The keys with numbers rounded to decimals that move the curve by thousandths of the tolerances. A slope that no
/// tension, continuity and bias give is replaced by 0. Rotations have the tension, continuity and bias, the same in
/// their four channels, whose tangents are nearest to the slopes.
spline::Keys<double> numbered_keys(const std::vector<CornerKey>& keys, const Recording& recording,
                                   const std::vector<Time>& times, const FitRules& rules);

// fit.cpp

/// The keys of a recording.
struct FitResult {
  spline::Keys<double> keys;   ///< tension, continuity and bias of each channel, or velocities
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
