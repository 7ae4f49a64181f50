// Format: what is known about a format of inputs, outputs, or both. formats/formats.hpp has the list of all.
#pragma once

#include <string_view>

namespace tcb {

struct InputFormat;   // read/input.hpp
struct OutputFormat;  // write/output_format.hpp
struct PoseFormat;    // schema/pose_formats.hpp

struct Format {
  std::string_view name;
  std::string_view ending;               ///< of file names, with the point; it names the first format that has it
  const InputFormat* input = nullptr;    ///< how it is read; null: it is not
  const OutputFormat* output = nullptr;  ///< how its rows are written; null: it has none
  char delimiter = 0;                    ///< between the cells of lines; ' ' is any run of blanks and tabs
  const PoseFormat* poses = nullptr;     ///< the columns of its rows, which are poses; null: any columns

  bool has_marks = false;          ///< the delimiter and the header of its lines may be chosen
  bool has_any_delimiter = false;  ///< that of an input is found
  bool is_json = false;            ///< its rows are objects, and a report in it is JSON
  bool nests = false;              ///< an output with groups is an object for each curve, with a list of rows
  bool has_provenance = false;     ///< an output may hold its provenance
  bool is_binary = false;          ///< doubles, not their texts
  bool has_nodes = false;          ///< an animation of nodes
  bool has_reports = false;        ///< a report may be in it
  bool is_picture = false;         ///< curves and samples, without rows

  bool can_read() const { return input != nullptr; }
  bool can_write() const { return output != nullptr || is_picture; }
};

}  // namespace tcb
