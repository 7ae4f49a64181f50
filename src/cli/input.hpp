// What the input is like: the options that say it, and which of them have a meaning together.
#pragma once

#include "cli/options.hpp"

namespace tcb {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
InputOptions make_input(const TypedOptions& typed);

/// How keys make curves. Throws: Error (usage).
CurveOptions make_curves(const TypedOptions& typed);

}  // namespace tcb
