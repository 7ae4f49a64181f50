// Curves: which keys of an input make a curve, one curve after another.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/input.hpp"
#include "keys/group.hpp"
#include "keys/order.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// How the keys of an input make curves.
struct CurveOptions {
  Duplicates duplicates = Duplicates::error;
  bool sort = false;
};

/// The keys of one curve.
struct CurveKeys {
  std::vector<std::string> group;  ///< what tells it apart, a text for each of the input's groups
  std::shared_ptr<const CurveInfo> curve_info;
  Source<KeyBlock> keys;
};

/// The curves of an input, in order of first appearance.
class Curves {
 public:
  /// `live`: of faults, only those in the bytes at hand are said.
  Curves(const Input& input, const CurveOptions& options, bool live);

  /// The next curve; the one before is at an end by then. Throws: Error (data) with all that is wrong with the keys.
  std::optional<CurveKeys> next();

  /// How many keys were left out.
  std::uint64_t skipped() const;

 private:
  class Cutter;
  std::shared_ptr<Cutter> cutter_;
};

}  // namespace tcb
