// Inputs: the files that are named, listed, or found in folders, and where the rows of each go.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/job.hpp"

namespace tcb {

/// A file of keys.
struct InputFile {
  std::string path;          ///< "-" is standard input
  std::uint32_t inside = 0;  ///< from where on the path is kept below the output folder; 0: its name alone is
  bool is_current = false;   ///< with --update: its output is there, and not older
  std::uintmax_t size = 0;   ///< in bytes; 0 where nobody can tell
};

struct Inputs {
  std::vector<InputFile> files;  ///< as named; those of a list in its order, those of a folder sorted by name
  std::uint64_t left_alone = 0;  ///< files in folders whose ending is that of no format, pipes, devices
};

/// Finds the files before any of them is read. What is wrong with one of them is left to its reading.
/// Throws: Error (usage) where there are none, a folder cannot be read, or an output would take the place of an input
/// or of another output.
Inputs find_inputs(const Job& plan);

/// Where the rows of a file go: its name below the output folder, with the suffix and the format's ending.
/// Requires: plan.output_folder.
std::string output_path(const InputFile& file, const Job& plan);

}  // namespace tcb
