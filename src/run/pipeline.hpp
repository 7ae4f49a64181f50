// The runs of the program: resampling files, one batch of them, and explanations.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "error.hpp"
#include "io/input_list.hpp"
#include "run/curve_pipeline.hpp"
#include "run/job.hpp"
#include "run/progress.hpp"

namespace tcb {

/// Reads the keys of every file and writes the samples of their curves. Returns the exit code of the program, which is
/// not Exit::done where a file of a batch failed and was reported.
/// Throws: Error, with the file. An incomplete output does not get its name.
Exit resample(const Job& job);

/// Writes the output of one file with a number of threads, and returns the number of its rows.
/// Throws: Error, in which case there is no new output. Threads: any number at once.
using Convert = std::function<std::uint64_t(const InputFile& file, unsigned threads)>;

/// Converts all files but those whose outputs are current. A file that fails is reported, and the others continue;
/// `fail_fast`: no other one is begun. Errors are in the order of the files.
Summary convert_all(const Inputs& inputs, bool fail_fast, unsigned threads, Report& report, const Convert& convert);

/// What was detected in a file and will be done with it, one fact per line: reads the keys and places the samples, but
/// evaluates none. Throws: Error as resample() does.
std::string explanation(const std::string& path, const Job& job);

/// The rules of a curve in words: names and values.
Facts rules_in_words(const RuleFacts& facts);

/// The requested samples in words, as in "every 0.5 of time".
std::string samples_in_words(const SamplingRequest& request);

/// The samples that the job requests of a curve. Throws: Error (data) for a group without places.
SamplingRequest sampling_of(const CurveKeys& curve, const Schema& schema, const Job& job);

}  // namespace tcb
