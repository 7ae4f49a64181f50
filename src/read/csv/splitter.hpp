// Splitter of delimited text: chunks cut between records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "read/chunk.hpp"
#include "read/csv/tokenizer.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Cuts bytes into chunks of whole records. `line` is that of the first byte.
/// Requires: the bytes have no byte order mark. Throws: Error (data) for a NUL, and for a record over 64 MiB, which
/// usually comes from a missing quote.
Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line = 1);

inline constexpr std::size_t longest_record = 64UL * 1024 * 1024;
[[noreturn]] void refuse_long_record(std::uint64_t line);

}  // namespace tcb
