// NumPy arrays: the rows of .npy files as lines of delimited text.
//
// An array of two dimensions has columns by number, and a structured one of one dimension columns by name. Numbers are
// floats of 32 and 64 bits, integers and booleans, in either order of bytes. Each becomes the shortest decimal of its
// double, or a whole number.
// Source: NumPy, "numpy.lib.format", versions 1.0 to 3.0 of the format.
#pragma once

#include <string>

#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The text of an array, and in `options` how it is delimited. An array in Fortran order is kept while it is read.
/// Throws: Error (data).
Source<std::string> text_of_npy(Source<std::string> bytes, InputOptions& options);

}  // namespace tcb
