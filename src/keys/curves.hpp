// Curves: the keys of an input, arranged and split into curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "keys/curve_options.hpp"
#include "schema/input_keys.hpp"
#include "schema/key_block.hpp"
#include "schema/rotation_options.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Passes keys on until one has a fault; then reads on to collect up to ten faults, unless the input is live, and
/// throws an Error (data) with all of them.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live);

/// A part of a curve that gaps divide, which has a curve of its own.
struct CurvePart {
  std::size_t number = 0;  ///< of the part, from 0
  Time origin;             ///< the time of the first key of the first part
  /// The time of the first key of the next part, once all keys of this one are read; nothing: it is the last one.
  std::function<std::optional<Time>()> next;
};

/// The keys of one curve.
struct InputCurve {
  std::vector<std::string> group;  ///< the texts that identify the curve, one for each of the input's groups
  std::shared_ptr<const CurveInfo> curve_info;
  Source<KeyBlock> keys;
  std::optional<CurvePart> part = {};  ///< where gaps divide curves
};

/// The curves of an input, in order of first appearance.
class Curves {
 public:
  /// `live`: an error has only the faults in the bytes that were read, as more may take long to arrive.
  Curves(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live);

  /// The next curve. It ends the previous one, whose remaining keys are skipped.
  /// Throws: Error (data) with all faults of the keys.
  std::optional<InputCurve> next();

  /// Number of keys that were skipped so far.
  std::uint64_t skipped() const;
  /// Plain channels that seem to be angles.
  std::vector<NamedAngle> likely_angles() const;
  /// How often times of day passed midnight so far.
  std::uint64_t midnights() const;
  /// How many gaps divided curves so far, and the largest one.
  std::uint64_t gaps() const;
  double largest_gap() const;

 private:
  class Splitter;
  std::shared_ptr<Splitter> splitter_;
};

}  // namespace tcb
