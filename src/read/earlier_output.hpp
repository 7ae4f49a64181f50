// Earlier outputs: how an output was made, read from the provenance that it holds.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stream/source.hpp"

namespace tcb {

/// The provenance of an output, as far as it is needed to make the output again. write/provenance.hpp writes it.
struct EarlierOutput {
  std::string program;                                      ///< with its version
  std::vector<std::string> options;                         ///< as given, each as one word
  std::vector<std::pair<std::string, std::string>> inputs;  ///< names, and SHA-256 in hexadecimal digits
};

/// Reads the comment lines of delimited text, or the member "meta" of JSON. Throws: Error (data) if there is no
/// provenance.
EarlierOutput read_earlier_output(const Source<std::string>& bytes);

}  // namespace tcb
