// The whole path, from the bytes of keys to the bytes of samples.
#pragma once

#include "task.hpp"

namespace tcb {

/// Reads the keys of every file and writes the samples of their curves.
/// Throws: Error, naming the file. An output that is not complete does not stand under its name.
void resample(const Plan& plan);

}  // namespace tcb
