// Provenance on the command line: which options an output says it was made with, and the way back.
#pragma once

#include "cli/options.hpp"

namespace tcb {

/// The provenance of an output that is made with the typed options: all of them but those that do not change a byte.
/// Throws: Error (usage).
Provenance new_meta(const CLI::App& app, const TypedOptions& typed);

/// The provenance of the output that is to be made again. Throws: Error (usage) where options are typed that it has to
/// bring, or another number of files than it was made from; Error where it cannot be read.
ProvenanceRequest earlier_meta(const CLI::App& app, const TypedOptions& typed);

}  // namespace tcb
