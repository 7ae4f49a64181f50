// Cells of delimited text that hold the numbers of a vector, such as "(0.0, 1.5)" of Unity and Godot, and (X=1,Y=2) of
// Unreal: each number becomes a cell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "read/csv/tokenizer.hpp"
#include "read/text_bytes.hpp"
#include "schema/columns.hpp"
#include "stream/source.hpp"

namespace tcb {

/// A column of vectors, with the names of the columns that its numbers become.
struct VectorColumn {
  std::size_t cell;
  std::string name;
  std::vector<std::string> parts;
};

/// The columns of vectors beside others in the row below the first one, whose chunks then have a cell for each number,
/// at its place in the text. Empty, with the same chunks, where there are none.
std::vector<VectorColumn> take_vectors(Source<Chunk>& chunks, const Dialect& dialect);

/// The request with the columns of the numbers in the place of those of vectors.
ColumnOptions with_vectors(ColumnOptions requested, const std::vector<VectorColumn>& columns);

}  // namespace tcb
