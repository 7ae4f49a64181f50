// Errors of curves: faults of the library as errors of the program, with its channels and lines.
#pragma once

#include <string>
#include <vector>

#include "error.hpp"
#include "keys/key_store.hpp"
#include "tcb/spline/build_error.hpp"

namespace tcb {

/// Why these keys make no curve. `channels`: their names.
Error curve_error(const spline::BuildError& error, const KeyStore& keys, const std::vector<std::string>& channels);

}  // namespace tcb
