// Where the samples are: the options that say it, and which of them have a meaning together.
#pragma once

#include "cli/options.hpp"

namespace tcb::cli {

/// Throws: Error (usage) unless exactly one option says where the samples are, and all others fit it.
sampler::Request make_sampling(const Typed& typed);

}  // namespace tcb::cli
