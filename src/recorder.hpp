// The recorder: what an output's provenance says of the inputs that go by, and where it stands in the output.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "format/format.hpp"
#include "format/meta.hpp"
#include "rows.hpp"
#include "sha256.hpp"
#include "stream.hpp"

namespace tcb {

/// The provenance that is asked for.
struct MetaRequest {
  format::Meta meta;     ///< program and options
  format::Meta earlier;  ///< that of the output that is made again, if one is
  std::string from;      ///< that output
};

/// Lets an input's bytes, keys and rows go by, and reads each to its end, so that every count is whole.
/// Without a request it does nothing. It outlives the sources that it gives.
class Recorder {
 public:
  explicit Recorder(const std::optional<MetaRequest>& request);

  /// Throws: Error, before any byte is let by, for an input that is not the expected one, or one too many.
  Source<std::string> bytes(const std::string& name, Source<std::string> bytes);
  Source<format::KeyBlock> keys(Source<format::KeyBlock> keys);
  Source<Batch> rows(Source<Batch> rows);

  /// The curve at hand, or the input, has no more rows.
  void end_curve();
  void end_input();

  /// What stands before the first row, and what behind the last one, with the frame's own text in its place.
  std::string head(const format::Format& format, format::Facts rules, const std::string& frame, bool nested);
  std::string tail(const std::string& frame) const;

 private:
  struct Tally;
  const std::optional<MetaRequest>& request_;
  std::shared_ptr<Tally> tally_;
  const format::Format* format_ = nullptr;
  bool nested_ = false;
};

}  // namespace tcb
