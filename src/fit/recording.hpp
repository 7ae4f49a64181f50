// Recordings: the samples that keys are to be found for, and how far the curve may be from them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tcb/spline/key.hpp"

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

}  // namespace tcb
