// Output format: the half of a format that writes its rows. Each is defined in one file of this room, and a row of
// formats/formats.cpp names it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "schema/format.hpp"
#include "schema/schema.hpp"
#include "write/layout.hpp"

namespace tcb {

struct OutputFormat {
  Layout (*layout)(const std::vector<OutputColumn>& columns, const TextMarks& marks, bool header);
  /// A cell from a text as in schema/texts.hpp; null: cells are numbers only.
  std::string (*text)(std::string_view text, char delimiter) = nullptr;
  /// The head with the number of rows, written in place of the layout's head of the same size; null: not needed.
  std::string (*counted_head)(std::size_t columns, std::uint64_t rows) = nullptr;
  /// Throws: Error (data) for curves that the format does not hold; null: it holds any.
  void (*require)(const Schema& schema) = nullptr;
  bool has_groups = true, has_labels = true;  ///< rows may have these texts
  bool has_cameras = false;                   ///< the rows are a part of a camera path, which is around them
};

}  // namespace tcb
