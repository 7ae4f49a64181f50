// Delimited text: from records to keys, by the header or by position.
#pragma once

#include "format/input.hpp"
#include "format/records.hpp"

namespace tcb::format {

/// What the beginning of a delimited input tells.
struct DelimitedHead {
  Dialect dialect;
  Columns columns;
};

/// Dialect and columns, from the header if there is one and the first two records after it; a chunk is
/// left in `rest` that begins with the first record of numbers. Throws: Error (data).
DelimitedHead read_head(Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options, Chunk& rest);

/// The keys of a chunk. A pure function. Throws: Error (data), placed at the cell.
KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head, const spline::Tcb<double>& tcb);

/// Opens delimited text whose delimiter is given, or else found in the first record.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Input open_delimited(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb::format
