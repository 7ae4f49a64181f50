// SampleBlock: many files, each to an output of its own, on all threads, and none in another's way.
#pragma once

#include <functional>

#include "app/progress.hpp"
#include "io/input_list.hpp"

namespace tcb {

/// Writes the output of one file, with so many threads inside; answers how many rows it has.
/// Throws: Error, in which case there is no new output. Threads: any number at once.
using Convert = std::function<std::uint64_t(const InputFile& file, unsigned threads)>;

/// Converts all files but those whose outputs are current. A file that fails is reported, and the others go on, or
/// with --fail-fast no other is begun. Errors come in the order of the files.
Summary convert_all(const Inputs& inputs, const Job& plan, unsigned threads, Report& report, const Convert& convert);

}  // namespace tcb
