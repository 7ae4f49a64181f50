// Many files: the options that say which, and what is said while they are done.
#pragma once

#include "cli/options.hpp"

namespace tcb::cli {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
BatchOptions make_batch(const Typed& typed);

/// Throws: Error (usage).
Talk make_talk(const Typed& typed);

}  // namespace tcb::cli
