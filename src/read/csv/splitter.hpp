// Splitter of delimited text: its delimiter, found in the first record by a fixed rule or named by the first line, and
// chunks cut between records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "read/csv/tokenizer.hpp"
#include "read/input_options.hpp"
#include "read/text_bytes.hpp"
#include "stream/source.hpp"

namespace tcb {

inline constexpr std::size_t longest_record = 64UL * 1024 * 1024;

/// The delimiter of a record: the first of tab, ";", ",", "|" and blank that occurs in it outside quotes, or "," where
/// none does; with a decimal comma "," comes last. Bars with a blank on one side only are parts of names, as in |v|.
/// Nothing if the text does not hold the whole record, with its line end.
std::optional<char> delimiter_of(std::string_view record, char decimal);

/// The beginning of delimited text.
struct Beginning {
  char delimiter = ',';
  std::string text;        ///< read so far, from the first record, or from a comment directly above it
  std::uint64_t line = 1;  ///< of the first character
};

/// Reads until the first record is whole. `known`: the delimiter, if it is not to be found. Throws: Error (data) for a
/// record over 64 MiB.
Beginning find_delimiter(const Source<std::string>& bytes, std::optional<char> known, const DelimitedOptions& options);

/// The delimiter that a first line such as "sep=;" names, as spreadsheets write it; that line is dropped.
std::optional<char> take_named_delimiter(Source<std::string>& bytes);

/// Cuts bytes into chunks of whole records. `line` is that of the first byte.
/// Requires: the bytes have no byte order mark. Throws: Error (data) for a NUL, and for a record over 64 MiB, which
/// usually comes from a missing quote.
Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line = 1);

}  // namespace tcb
