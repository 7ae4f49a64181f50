// The recorder: what an output's provenance says of the inputs that go by, and where it stands in the output.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curve/rows.hpp"
#include "input/input.hpp"
#include "io/formats.hpp"
#include "io/sha256.hpp"
#include "output/provenance.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// The provenance that is asked for.
struct ProvenanceRequest {
  Provenance meta;     ///< program and options
  Provenance earlier;  ///< that of the output that is made again, if one is
  std::string from;    ///< that output
};

/// Lets an input's bytes, keys and rows go by, and reads each to its end, so that every count is whole.
/// Without a request it does nothing. It outlives the sources that it gives.
class ProvenanceRecorder {
 public:
  explicit ProvenanceRecorder(const std::optional<ProvenanceRequest>& request);

  /// Throws: Error, before any byte is let by, for an input that is not the expected one, or one too many.
  Source<std::string> bytes(const std::string& name, Source<std::string> bytes);
  Source<KeyBlock> keys(Source<KeyBlock> keys);
  Source<SampleBlock> rows(Source<SampleBlock> rows);

  /// The curve at hand, or the input, has no more rows.
  void end_curve();
  void end_input();

  /// What stands before the first row, and what behind the last one, with the frame's own text in its place.
  std::string head(const Format& format, Facts rules, const std::string& frame, bool nested);
  std::string tail(const std::string& frame) const;

 private:
  struct Tally;
  const std::optional<ProvenanceRequest>& request_;
  std::shared_ptr<Tally> tally_;
  const Format* format_ = nullptr;
  bool nested_ = false;
};

}  // namespace tcb
