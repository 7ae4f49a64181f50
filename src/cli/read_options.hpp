// Reading of options: from the words of a command line to typed options.
#pragma once

#include <string>
#include <vector>

#include "cli/typed_options.hpp"

namespace tcb {

/// Throws: Error (usage) for unknown options, and for values that are wrong in themselves.
TypedOptions read_options(const std::vector<std::string>& given);

/// When messages are colored, by words that may be wrong otherwise.
ColorWhen color_of(int argc, const char* const* argv);

}  // namespace tcb
