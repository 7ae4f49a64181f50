// What the typed options mean: text to values, and the checks that no option stands in another's way.
#pragma once

#include "cli/options.hpp"

namespace tcb {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Job make_plan(const TypedOptions& typed);

}  // namespace tcb
