// What the input is like: the options that say it, and which of them have a meaning together.
#pragma once

#include "cli/options.hpp"

namespace tcb::cli {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
format::InputOptions make_input(const Typed& typed);

/// How keys make curves. Throws: Error (usage).
CurveOptions make_curves(const Typed& typed);

}  // namespace tcb::cli
