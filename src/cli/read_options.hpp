// Reading of options: from the words of a command line to typed options.
#pragma once

#include <string>
#include <vector>

#include "cli/typed_options.hpp"

namespace tcb {

/// Throws: Error (usage) for unknown options, and for values that are wrong in themselves. `color`: where errors are
/// shown, which is set before the first that is about a value.
TypedOptions read_options(const std::vector<std::string>& given, ColorWhen* color = nullptr);

}  // namespace tcb
