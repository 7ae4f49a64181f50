// Earlier outputs: how an output was made, read from the provenance that it holds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read/memory_use.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The provenance of an output, as far as it is needed to make the output again. write/provenance.hpp writes it.
struct EarlierOutput {
  std::string program;                                      ///< with its version
  std::vector<std::string> options;                         ///< as given, each as one word
  std::vector<std::pair<std::string, std::string>> inputs;  ///< names, and SHA-256 in hexadecimal digits
};

/// Finds the provenance in the text of an output: in the comment lines of delimited text, or the member "meta" of JSON.
class EarlierOutputReader {
 public:
  /// `max_memory`: in bytes, of JSON and of a line, which are kept.
  explicit EarlierOutputReader(std::uint64_t max_memory = default_max_memory) : max_memory_(max_memory) {}

  /// Reads the next bytes of the text. Throws: Error (data) for more than the limit.
  void add(std::string_view bytes);
  /// What the whole text holds, or nothing where it has no provenance.
  std::optional<EarlierOutput> end();

 private:
  std::uint64_t max_memory_;
  EarlierOutput output_;
  std::string text_;  ///< all of JSON; of lines the last one
  bool begun_ = false, json_ = false;
};

/// Throws: Error (data) if there is no provenance.
EarlierOutput read_earlier_output(const Source<std::string>& bytes, std::uint64_t max_memory = default_max_memory);

}  // namespace tcb
