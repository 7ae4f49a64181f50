// Recordings for the tests of fits.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "fit/fit.hpp"
#include "schema/key_block.hpp"

namespace tcb {

/// A recording of one channel per function, every `step` of time from 0 on, with one tolerance for the distance.
inline Recording recording_of(const std::vector<std::function<double(double)>>& channels, std::size_t samples,
                              double step, double tolerance) {
  Recording recording;
  recording.channels = channels.size();
  FitGroup group{{}, tolerance};
  for (std::size_t i = 0; i < channels.size(); ++i) group.channels.push_back(i);
  recording.groups = {group};
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * step;
    recording.times.push_back(t);
    for (const auto& channel : channels) recording.positions.push_back(channel(t));
  }
  return recording;
}

inline std::vector<Time> times_of(const Recording& recording) {
  return {recording.times.begin(), recording.times.end()};
}

}  // namespace tcb
