// Input lists: files that are named, listed, or found in folders, and the path of the output of each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

/// The paths of outputs: one for all inputs, or one for each.
struct OutputPaths {
  std::string file = "-";             ///< one output for all inputs, or
  std::optional<std::string> folder;  ///< one for each, in this folder
  std::string suffix;                 ///< of their names, before the ending
  std::string_view ending;            ///< that of the format, with the point; none where the suffix has it
};

struct InputListOptions {
  std::vector<std::string> files;              ///< "-" is standard input
  std::string list;                            ///< a file that names more files; "-": standard input; empty: none
  bool nul = false;                            ///< the names in the list end in NUL, not in a line end
  bool recursive = false;                      ///< a folder means the files in it; then outputs have a folder
  std::vector<std::string_view> endings;       ///< of the files in folders that are inputs; none: all are
  bool update = false;                         ///< compare the times of inputs and their outputs
  std::vector<std::string> other_inputs = {};  ///< files that the run reads besides; no output replaces them
  OutputPaths outputs;
};

/// A file of keys.
struct InputFile {
  std::string path;          ///< "-" is standard input
  std::uint32_t inside = 0;  ///< start of the part of the path that the output keeps; 0: only its name
  bool is_current = false;   ///< its output exists and is not older; set only with `update`
  std::uintmax_t size = 0;   ///< in bytes; 0 if that is unknown
};

struct Inputs {
  std::vector<InputFile> files;  ///< as named; those of a list in its order, those of a folder sorted by name
  std::uint64_t others = 0;      ///< files in folders with other endings, pipes, devices
};

/// Finds the files before any of them is read. Errors within one of them are left to its reader.
/// Throws: Error (usage) if there are none, a folder cannot be read, or an output would replace an input or another
/// output.
Inputs find_inputs(const InputListOptions& options);

/// The path of the output of a file: its name below the output folder, with the suffix and the ending.
/// Requires: outputs.folder. Throws: Error (usage) for standard input.
std::string output_path(const InputFile& file, const OutputPaths& outputs);

/// Throws: Error (usage), naming the input, if the output would replace one of these inputs.
void require_no_input_replaced(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace tcb
