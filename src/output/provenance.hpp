// Provenance: what an output says of how it was made, as comment lines or as a JSON object.
//
// What is known before the first row stands before all rows, what is known after the last one behind them: the
// SHA-256 and the counts. In JSON, and in JSON Lines as a line, all of it stands behind the rows.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "stream/stream.hpp"

namespace tcb {

/// Names with what is said of them.
using Facts = std::vector<std::pair<std::string, std::string>>;

struct Provenance {
  std::string program;                                      ///< with its version
  Facts rules;                                              ///< of the curve, in words
  std::vector<std::string> options;                         ///< as typed, each as one word
  std::vector<std::pair<std::string, std::string>> inputs;  ///< names, and SHA-256 in hexadecimal digits
  std::uint64_t curves = 0, keys = 0, rows = 0;
};

/// Comment lines before all rows, and behind them.
std::string meta_head(const Provenance& meta);
std::string meta_tail(const Provenance& meta);

/// A JSON object.
std::string meta_object(const Provenance& meta);

/// What an output says of its program, its options and its inputs. Throws: Error (data) where it says nothing.
Provenance read_meta(const Source<std::string>& bytes);

}  // namespace tcb
