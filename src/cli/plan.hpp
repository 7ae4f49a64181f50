// Plan: from arguments to typed options, from these to the job, and the options that provenance records.
#pragma once

#include <optional>
#include <string>

#include "cli/typed_options.hpp"
#include "error.hpp"

namespace tcb {

/// What the command line requests: a text to print, or else a job.
struct Invocation {
  std::optional<std::string> text;
  Job job = {};
  Exit exit = Exit::done;  ///< after the text; where it is another one, the text is an error message
};

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Invocation parse(int argc, const char* const* argv);

/// The job of these options. Requires: no conflict.
/// Throws: Error (usage) if they do not fit each other.
Job make_job(const TypedOptions& typed);

/// The provenance of an output that is made with these options: its program, and all options that change a byte.
/// Throws: Error (usage) for a value that no line can hold.
Provenance new_provenance(const TypedOptions& typed);

/// The provenance of the output to reproduce. Throws: Error (usage) if options are given that it has,
/// or another number of files than it was made from; Error where it cannot be read.
ProvenanceRequest earlier_provenance(const TypedOptions& typed);

}  // namespace tcb
