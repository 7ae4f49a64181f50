// Many files: the options that say which, and what is said while they are done.
#pragma once

#include "cli/options.hpp"

namespace tcb {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
BatchOptions make_batch(const TypedOptions& typed);

/// Throws: Error (usage).
Verbosity make_talk(const TypedOptions& typed);

}  // namespace tcb
