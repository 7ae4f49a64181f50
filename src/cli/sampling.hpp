// Where the samples are: the options that say it, and which of them have a meaning together.
#pragma once

#include "cli/options.hpp"

namespace tcb {

/// Puts the numbers in a file in the place of @FILE, apart by commas, once and for all.
/// Throws: Error (usage) for a file that cannot be read or has none.
void take_lists(TypedOptions& typed);

/// Throws: Error (usage) unless exactly one option says where the samples are, and all others fit it.
SamplingRequest make_sampling(const TypedOptions& typed);

}  // namespace tcb
