// Format: what is known about a format of inputs, outputs, or both. formats/formats.hpp has the list of all.
#pragma once

#include <cstdint>
#include <string_view>

namespace tcb {

/// What rows of a format have that an option may ask for.
namespace offer {
enum Offer : std::uint16_t {
  nothing = 0,
  any_columns = 1,
  column_names = 2,
  pieces = 4,
  decimals = 8,  ///< numbers as text, with any digits
  times = 16,
  words_of_time = 32,   ///< times in other notations than numbers
  marks = 64,           ///< a delimiter, a decimal mark and a line of names, as delimited text
  any_delimiter = 128,  ///< the delimiter may be chosen, and that of an input is found
  provenance = 256,
  keys = 512,      ///< rows that are keys
  drawing = 1024,  ///< axes, a title and a size
};
}  // namespace offer

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

  std::string_view fields = {};            ///< of its rows at samples; empty: any
  std::uint16_t offered = offer::nothing;  ///< to options

  bool is_json = false;      ///< its rows are objects, and a report in it is JSON
  bool nests = false;        ///< an output with groups is an object for each curve, with a list of rows
  bool is_binary = false;    ///< doubles, not their texts
  bool has_nodes = false;    ///< an animation of nodes
  bool has_reports = false;  ///< a report may be in it
  bool is_picture = false;   ///< curves and samples, without rows

  bool offers(offer::Offer what) const { return (offered & what) == what; }
  bool can_read() const { return input != nullptr; }
  bool can_write() const { return output != nullptr || is_picture; }
};

}  // namespace tcb
