// Delimited text in tests: its records and its chunks.
#pragma once

#include <string>
#include <vector>

#include "read/csv/splitter.hpp"
#include "read/csv/tokenizer.hpp"
#include "read/reading.hpp"

namespace tcb {

using RecordTexts = std::vector<std::vector<std::string>>;

inline RecordTexts table(const std::string& text, const Dialect& dialect = {}) {
  const Chunk chunk{text};
  Tokenizer tokenizer(chunk, dialect);
  RecordTexts rows;
  for (std::vector<std::string_view> cells; tokenizer.next(cells);) {
    rows.emplace_back(cells.begin(), cells.end());
  }
  return rows;
}

/// The chunks of a text that arrives in pieces of this size.
inline std::vector<Chunk> chunks(const std::string& text, std::size_t piece, const Dialect& dialect = {}) {
  const auto source = split_delimited(pieces(text, piece), dialect);
  std::vector<Chunk> all;
  while (auto chunk = source()) all.push_back(std::move(*chunk));
  return all;
}

}  // namespace tcb
