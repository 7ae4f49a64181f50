// Curves: the keys of an input split into curves, one after another.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/input.hpp"
#include "keys/order.hpp"
#include "stream/source.hpp"

namespace tcb {

/// How the keys of an input make curves.
struct CurveOptions {
  Duplicates duplicates = Duplicates::error;
  bool sort = false;
};

/// The keys of one curve.
struct CurveKeys {
  std::vector<std::string> group;  ///< the texts that identify the curve, one for each of the input's groups
  std::shared_ptr<const CurveInfo> curve_info;
  Source<KeyBlock> keys;
};

/// The curves of an input, in order of first appearance.
class Curves {
 public:
  /// `live`: an error has only the faults in the bytes that were read, for the next ones may be far.
  Curves(const Input& input, const CurveOptions& options, bool live);

  /// The next curve. It ends the one before: keys of that which were not read are passed over.
  /// Throws: Error (data) with all faults of the keys.
  std::optional<CurveKeys> next();

  /// Number of keys that were left out, so far.
  std::uint64_t skipped() const;

 private:
  class Splitter;
  std::shared_ptr<Splitter> splitter_;
};

}  // namespace tcb
