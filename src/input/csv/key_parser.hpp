// Delimited text: from records to keys, by the header or by position.
#pragma once

#include "input/csv/header.hpp"
#include "input/input.hpp"

namespace tcb {

/// The keys of a chunk. A pure function. What is wrong stands in its faults, placed at the cell; ten at most.
KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head);

/// Opens delimited text whose delimiter is given, or else found in the first record.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Input open_delimited(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
