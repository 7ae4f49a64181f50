// Provenance: how an output was made, in comment lines or in a JSON object; its recorder.
//
// Comment lines have what is known before the first row above the rows, and the checksums and counts below them.
// JSON has all of it after the rows; JSON Lines has it in the last line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/digest.hpp"
#include "schema/format.hpp"
#include "stream/source.hpp"

namespace tcb {

struct KeyBlock;
struct SampleBlock;

/// Names and values in words.
using Facts = std::vector<std::pair<std::string, std::string>>;

struct Provenance {
  std::string program;                                      ///< with its version
  Facts rules;                                              ///< of the curve, in words
  std::string command;                                      ///< that prints the output, for a shell
  std::vector<std::pair<std::string, std::string>> inputs;  ///< names, and SHA-256 in hexadecimal digits
  std::uint64_t curves = 0, keys = 0, rows = 0;
  std::vector<Facts> results = {};  ///< of each input, in words; or none
};

/// The provenance as text before and after the rows. In nested formats, the text after them is a member of the outer
/// object.
std::string text_before_rows(const Provenance& provenance, const Format& format);
std::string text_after_rows(const Provenance& provenance, const Format& format);

struct ProvenanceRequest {
  std::string program;                            ///< with its version
  std::vector<std::string> command;               ///< its words without the files
  std::optional<std::vector<std::string>> files;  ///< of the command; nothing: the input, the only one of its output
};

/// Observes an input's bytes, keys and rows, and reads each to its end, so that the counts and checksums are complete.
/// Without a request it does nothing. It outlives the sources that it returns.
class ProvenanceRecorder {
 public:
  explicit ProvenanceRecorder(const std::optional<ProvenanceRequest>& request);

  /// The bytes of the next input.
  Source<std::string> observe_bytes(const std::string& path, Source<std::string> bytes);
  /// The keys of the next curve.
  Source<KeyBlock> observe_keys(Source<KeyBlock> keys);
  Source<SampleBlock> observe_rows(Source<SampleBlock> rows);
  /// Rows that no block has.
  void count_rows(std::uint64_t rows) { provenance_.rows += rows; }
  void set_rules(Facts rules) { provenance_.rules = std::move(rules); }
  /// Sets the results of the current input, in words.
  void set_results(Facts results);

  void end_curve();
  void end_input();

  /// The two texts, or empty ones without a request.
  std::string before_rows(const Format& format) const;
  std::string after_rows(const Format& format) const;

 private:
  const std::optional<ProvenanceRequest>& request_;
  Provenance provenance_;      ///< so far
  Sha256 sha256_;              ///< of the current input, with
  Source<std::string> bytes_;  ///< its bytes
  Source<KeyBlock> keys_;      ///< of the current curve
};

}  // namespace tcb
