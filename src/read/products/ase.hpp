// ASE: the controllers of objects in the ASCII export of 3ds Max as keys.
//
// Each object has the tracks position, rotation and scale that its controllers give, by TCB keys, linear keys or
// samples; between linear keys and between samples the curve is straight. Times are converted from ticks to seconds.
// Rotations are as in .3ds files. The preset is 3dsmax. Bezier keys have no documented unit of their tangents, and are
// refused. Source: the exporter among the samples of the 3ds Max SDK.
#pragma once

#include <string>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Opens a file, which is kept while it is read. Throws: Error (data).
Records open_ase(const Source<std::string>& bytes, const InputOptions& options);

}  // namespace tcb
