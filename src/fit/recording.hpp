// Recordings: the samples that keys are to be found for, and how far the curve may be from them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tcb {

/// Channels whose distance from the samples, the root of the sum of squares, is limited.
struct FitGroup {
  std::vector<std::size_t> channels;
  double tolerance = 0;
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

/// Successive samples [first, last).
struct SampleRange {
  std::size_t first = 0, last = 0;
  std::size_t size() const { return last - first; }
};

}  // namespace tcb
