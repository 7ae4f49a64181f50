// Where the samples are: the options that say it, and which of them have a meaning together.
#pragma once

#include "cli/options.hpp"

namespace tcb::cli {

/// A list of numbers as it is typed, or where it is @FILE, the numbers in that file, apart by commas.
/// Throws: Error (usage) for a file that cannot be read or has none.
std::string listed(std::string_view option, const std::string& text);

/// Throws: Error (usage) unless exactly one option says where the samples are, and all others fit it.
sampler::Request make_sampling(const Typed& typed);

}  // namespace tcb::cli
