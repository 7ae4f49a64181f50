// Output formats: how rows, texts and breaks of each format are written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.hpp"
#include "output/layout.hpp"

namespace tcb {

struct OutputFormat {
  Layout (*layout)(const std::vector<OutputColumn>& columns, bool header);
  std::string (*text)(std::string_view text);  ///< a text as in texts.hpp, as a cell; nothing: it holds numbers only
  std::string_view divider;                    ///< the line between two curves that no text tells apart
  /// The head with the number of rows, which takes the place of the layout's; nothing where that has it all.
  std::string (*head)(std::size_t columns, std::uint64_t rows) = nullptr;
};

/// Requires: the format can be written.
const OutputFormat& output_format(FormatId format);

}  // namespace tcb
