// The ending of --output, which names the format of the output.
#pragma once

#include "cli/typed_options.hpp"

namespace tcb {

/// Sets the format that the ending names, unless an option gives the same. A report is JSON by its ending.
/// `earlier`: the format is that of an earlier output. Throws: Error (usage) for another format than the option's, and
/// for the ending of a format that is not written.
void set_output_format(TypedOptions& typed, bool earlier);

}  // namespace tcb
