// The whole path, from the bytes of keys to the bytes of samples.
#pragma once

#include "app/job.hpp"
#include "error.hpp"

namespace tcb {

/// Reads the keys of every file and writes the samples of their curves; answers the program's exit code, which is
/// not Exit::done where a file of a folder's worth failed, and was reported.
/// Throws: Error, naming the file. An output that is not complete does not stand under its name.
Exit resample(const Job& plan);

}  // namespace tcb
