// Reading of options: from the words of a command line to typed options.
#pragma once

#include <string>
#include <vector>

#include "cli/typed_options.hpp"

namespace tcb {

/// Throws: Error (usage) for unknown options, and for values that are wrong in themselves.
TypedOptions read_options(const std::vector<std::string>& given);

/// The value of --color, found without reading the rest, so that errors in the command line are colored too.
ColorWhen color_of(int argc, const char* const* argv);

}  // namespace tcb
