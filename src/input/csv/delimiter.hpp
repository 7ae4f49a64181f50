// Which delimiter delimited text has: found in its first record, by a fixed rule.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "input/input.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// The delimiter of a record: the first of tab, ";", "," and blank that occurs in it outside quotes, or "," where none
/// does; with a decimal comma "," comes last. Nothing if the text does not hold the whole record, with its line end.
std::optional<char> delimiter_of(std::string_view record, char decimal);

/// What a look at the beginning of delimited text tells.
struct Beginning {
  char delimiter = ',';
  std::string text;        ///< that was read, from the first record on, or from a comment directly above it
  std::uint64_t line = 1;  ///< of the first character
};

/// Reads on until the first record is whole. Throws: Error (data) for a record over 64 MiB.
Beginning find_delimiter(const Source<std::string>& bytes, const InputOptions& options);

}  // namespace tcb
