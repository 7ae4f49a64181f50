// Cells of delimited text that hold the numbers of a vector, such as "(0.0, 1.5)", (X=1,Y=2), POINT (1 2) and
// "1.5 2.5": each number becomes a cell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "read/csv/tokenizer.hpp"
#include "read/input_options.hpp"
#include "read/text_bytes.hpp"
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

/// The options with the columns of the numbers in the place of requested vectors. Throws: Error (data) for a column
/// that is requested by its number from the first vector on, as that counts either cells or numbers.
InputOptions with_vectors(InputOptions options, const std::vector<VectorColumn>& columns);

}  // namespace tcb
