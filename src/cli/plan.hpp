// What the typed options mean: text to values, and the checks that no option stands in another's way.
#pragma once

#include "cli/options.hpp"

namespace tcb::cli {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Plan make_plan(const Typed& typed);

}  // namespace tcb::cli
