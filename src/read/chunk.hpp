// Chunk: whole records of an input, as text.
#pragma once

#include <cstdint>
#include <string>

namespace tcb {

/// Whole records of an input, as text.
struct Chunk {
  std::string text;
  std::uint64_t line = 1;    ///< of the first character, from 1
  std::uint64_t column = 1;  ///< of the first character, from 1
  std::uint64_t first = 0;   ///< number of the first record, in formats that count them
  std::string path = {};     ///< of the list that holds the records, in formats that have one
};

}  // namespace tcb
