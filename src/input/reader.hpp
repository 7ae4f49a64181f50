// Reader: opens an input in the format that is given, or found by its ending or its first byte.
#pragma once

#include <string>

#include "input/input.hpp"
#include "io/formats.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// Opens an input: the format is the given one, else by the file's ending, else by the first byte that is not blank.
/// Throws: Error (data), without a file name.
Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
