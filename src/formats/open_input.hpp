// Opening of inputs: their bytes as text, and their format.
#pragma once

#include <string>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Opens an input: the format is the given one, else by the file's ending, else by the first byte that is not blank.
/// Throws: Error (data), without a file name.
Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& given);

}  // namespace tcb
