// How numbers are printed: the options that say it, and which of them have a meaning together.
#pragma once

#include "text/notation.hpp"
#include "cli/options.hpp"

namespace tcb {

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Notation make_notation(const TypedOptions& typed, FormatId output_format);

/// Whether and how rows are worked out exactly. Requires: the plan has its fields and its notation.
/// Throws: Error (usage).
void set_golden(Job& plan, const TypedOptions& typed);

}  // namespace tcb
