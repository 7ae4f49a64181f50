// Provenance options: the options that the provenance of an output records, and those of an earlier output.
#pragma once

#include <string>
#include <vector>

#include "cli/typed_options.hpp"
#include "write/provenance.hpp"

namespace tcb {

/// The provenance of an output that is made with these options: its program, and all options that change a byte.
/// Throws: Error (usage) for a value that no line can hold.
Provenance new_provenance(const TypedOptions& typed);

/// Throws: Error unless all options of an earlier output are such that provenance records, --meta among them, and none
/// names a file to be read, as the output may be a stranger's.
void require_recorded(const std::vector<std::string>& words);

/// The provenance of the output to reproduce. Throws: Error (usage) if options are given that it has,
/// or another number of files than it was made from; Error where it cannot be read.
ProvenanceRequest earlier_provenance(const TypedOptions& typed);

}  // namespace tcb
