// Plot: pictures of curves and their samples, from the bytes of keys to the bytes of SVG.
#pragma once

#include "error.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"

namespace tcb {

struct PlotJob : FilesJob {
  SampleOptions samples;  ///< those that are shown on the curves
  PictureOptions picture;
};

/// Reads the keys of every file and draws their curves. Returns the exit code of the program, as convert_files().
/// Throws: Error, with the file. An incomplete picture does not get its name.
Exit plot(const PlotJob& job);

}  // namespace tcb
