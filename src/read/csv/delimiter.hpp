// Delimiter of delimited text: found in the first record by a fixed rule, or named by the first line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The delimiter of a record: the first of tab, ";", "," and blank that occurs in it outside quotes, or "," where none
/// does; with a decimal comma "," comes last. Nothing if the text does not hold the whole record, with its line end.
std::optional<char> delimiter_of(std::string_view record, char decimal);

/// The beginning of delimited text.
struct Beginning {
  char delimiter = ',';
  std::string text;        ///< read so far, from the first record, or from a comment directly above it
  std::uint64_t line = 1;  ///< of the first character
};

/// Reads until the first record is whole. Throws: Error (data) for a record over 64 MiB.
Beginning find_delimiter(const Source<std::string>& bytes, const DelimitedOptions& options);

/// The delimiter that a first line such as "sep=;" names, as spreadsheets write it; that line is dropped.
std::optional<char> take_named_delimiter(Source<std::string>& bytes);

}  // namespace tcb
