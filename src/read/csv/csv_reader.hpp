// Reader of delimited text: from bytes to keys.
#pragma once

#include <cstdint>
#include <string>

#include "read/csv/header.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/text_bytes.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Up to this line, a number in a column of text is a fault; after it, it is taken as text.
inline constexpr std::uint64_t last_line_of_roles = 1000;

/// The keys of a chunk. A pure function. Errors are among its faults, at the position of the cell; at most ten.
KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head);

/// Opens delimited text whose delimiter is given, or else detected in the first record.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Records open_delimited(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
