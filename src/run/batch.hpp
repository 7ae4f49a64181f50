// Batches: the files of a job into one output or each into its own, files that fail, and threads for large files.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>

#include "error.hpp"
#include "io/input_list.hpp"
#include "run/job.hpp"
#include "run/progress.hpp"

namespace tcb {

/// What a person is told of an exception; the texts of libraries are not for people.
Error failure_of(const std::exception& failure);

/// An output of a product: rows, keys or a picture.
class BatchOutput {
 public:
  BatchOutput() = default;
  BatchOutput(const BatchOutput&) = delete;
  BatchOutput& operator=(const BatchOutput&) = delete;
  virtual ~BatchOutput() = default;

  /// Adds what is made of a file, with a number of threads, and returns the number of rows.
  virtual std::uint64_t add(const InputFile& file, unsigned threads) = 0;
  virtual void commit() = 0;
};

/// Opens the output with this path. Threads: any number at once.
using OpenOutput = std::function<std::unique_ptr<BatchOutput>(const std::string& path)>;

/// Converts the files of a job into one output, or each into its own. Returns the exit code of the program, which is
/// not Exit::done if a file of several failed and was reported. Throws: Error, with the file. An incomplete output does
/// not get its name.
Exit convert_files(const FilesJob& job, Report& report, const OpenOutput& open);

/// Writes the output of one file with a number of threads, and returns the number of its rows.
/// Throws: Error, in which case there is no new output. Threads: any number at once.
using Convert = std::function<std::uint64_t(const InputFile& file, unsigned threads)>;

/// Converts all files but those whose outputs are current. A file that fails is reported, in the order of the files,
/// and the others continue.
Summary convert_all(const Inputs& inputs, unsigned threads, Report& report, const Convert& convert);

}  // namespace tcb
