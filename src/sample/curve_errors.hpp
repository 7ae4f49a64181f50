// Errors of curves: faults of the library in the words of the program, with its channels and lines.
#pragma once

#include <string>
#include <vector>

#include "error.hpp"
#include "keys/key_store.hpp"
#include "tcb/spline/build_error.hpp"

namespace tcb {

/// Why these keys make no curve. `channels`: their names.
Error curve_error(const spline::BuildError& error, const KeyStore& keys, const std::vector<std::string>& channels);

Error tangents_beyond_doubles(const Time& start, const Time& end);
Error length_beyond_doubles(const Time& end);

}  // namespace tcb
