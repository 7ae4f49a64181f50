// What the input is like: the options that say it, and which of them have a meaning together.
#pragma once

#include <string_view>

#include "cli/options.hpp"
#include "io/formats.hpp"

namespace tcb {

/// The format with this name and capability. Throws: Error (usage) that names the option.
FormatId named_format(std::string_view option, std::string_view name, bool Format::*capability);

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
InputOptions make_input(const TypedOptions& typed);

/// How keys make curves. Throws: Error (usage).
CurveOptions make_curves(const TypedOptions& typed);

}  // namespace tcb
