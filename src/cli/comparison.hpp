// Comparisons: the options that ask for one, and which of them have a meaning together.
#pragma once

#include "cli/options.hpp"

namespace tcb {

/// The comparison that is asked for, if any. Throws: Error (usage) that names the option, what was expected, and the
/// remedy.
std::optional<Comparison> make_comparison(const TypedOptions& typed);

}  // namespace tcb
