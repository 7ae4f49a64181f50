// The one table of formats: their names, their file endings, how they are read and written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "input/input.hpp"
#include "output/layout.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// A format. To add one: a row of the table in format.cpp.
struct Format {
  std::string_view name;
  std::string_view ending;  ///< of file names, with the point
  /// Opens an input whose first bytes were seen; nothing for formats that are only written.
  Input (*open)(Source<std::string> bytes, const InputOptions& options);
  Layout (*layout)(const std::vector<OutputColumn>& columns, bool header);
  bool has_header;                             ///< names stand once, above the rows
  std::string (*text)(std::string_view text);  ///< a text as in texts.hpp, as a cell; nothing: it holds numbers only
  std::string_view divider;                    ///< the line between two curves that no text tells apart
  bool nests;  ///< the rows of a curve are a list of their own, if a text tells it apart
  /// The head with the number of rows, which takes the place of the layout's; nothing where that has it all.
  std::string (*head)(std::size_t columns, std::uint64_t rows) = nullptr;
};

/// All formats; the first is the default for output.
const std::vector<Format>& formats();

/// The index of a format by name; throws: Error (usage) naming the option. `read`: of those that can be read.
std::size_t find_format(std::string_view option, std::string_view name, bool read = false);

/// Opens an input: the format is the given one, else by the file's ending, else by the first byte.
/// Throws: Error (data), without a file name.
Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
