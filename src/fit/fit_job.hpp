// Fit job: keys for recordings, from the bytes of samples to the bytes of keys or of a picture.
#pragma once

#include "error.hpp"
#include "fit/fit_options.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// Keys for the recordings in files, whose samples are read as keys are.
struct FitJob : FilesJob {
  FitOptions options;
  WriterOptions rows;
  PictureOptions picture;  ///< for a format that is a picture
};

/// Fits the recordings of every file, and writes their keys or a picture. Returns the exit code of the program, as
/// convert_files(). Throws: Error, with the file. An incomplete output does not get its name.
Exit fit(const FitJob& job);

}  // namespace tcb
