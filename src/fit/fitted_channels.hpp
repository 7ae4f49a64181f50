// Fitted channels: what is fitted of an input, and within which limits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/fit_options.hpp"
#include "fit/recording.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// What is fitted of an input, and within which limits.
struct FittedChannels {
  std::vector<std::size_t> numbers;  ///< of the channels, in the input
  std::vector<std::string> names;
  std::vector<FitGroup> groups;  ///< of these channels: those of rotations come last
};

/// `rules` have the metric. Throws: Error (data) for rotations that are no quaternions, for limits of channels or
/// rotations that are not there, and for a channel without a limit; Error (usage) for a metric that does not exist.
FittedChannels fitted_channels(const Schema& schema, const CurveSettings& rules, const FitOptions& options);

}  // namespace tcb
