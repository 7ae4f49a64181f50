// Poses: options by which lines of poses are read as delimited text.
#pragma once

#include "read/input_options.hpp"
#include "schema/formats.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The options with the columns of a format of poses, its rotation and its unit of times, unless others are requested.
/// `bytes`: the text, of which the beginning is read for the number of its columns. Requires: a format of that family.
InputOptions options_of_poses(FormatId format, Source<std::string>& bytes, InputOptions options);

}  // namespace tcb
