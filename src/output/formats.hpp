// Output formats: from the ids of io/formats to the layouts and texts of each format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.hpp"
#include "output/layout.hpp"

namespace tcb {

/// How a format is written.
struct OutputFormat {
  Layout (*layout)(const std::vector<OutputColumn>& columns, bool header);
  std::string (*text)(std::string_view text);  ///< a cell from a text as in texts.hpp; null: cells are numbers only
  std::string_view divider;                    ///< the line between two curves of the same group; empty: impossible
  /// The head with the number of rows, written in place of the layout's head of the same size; null: not needed.
  std::string (*counted_head)(std::size_t columns, std::uint64_t rows) = nullptr;
};

/// Requires: the format can be written.
const OutputFormat& output_format(FormatId format);

/// The head of a NumPy file of doubles, rows x columns in C order. Promises: the size is the same for all numbers.
/// Source: NumPy, "numpy.lib.format", version 1.0 of the format.
std::string npy_head(std::size_t columns, std::uint64_t rows);

/// Rows of doubles, the lowest byte first, after such a head with 0 rows.
Layout npy_layout(const std::vector<OutputColumn>& columns);

}  // namespace tcb
