// Row estimate: about how many rows a curve will have, by the part of it that is known.
#pragma once

#include <cstdint>
#include <optional>

#include "sample/grid.hpp"
#include "sample/request.hpp"

namespace tcb {

struct KeyBlock;
struct SegmentBlock;

class RowEstimate {
 public:
  /// Requires: the request outlives it; it has rows segment after segment.
  RowEstimate(const SamplingRequest& request, const Extent& extent);

  /// Adds keys that were read, and segments that were made.
  void add(const KeyBlock& block);
  void add(const SegmentBlock& block);
  /// Adds all segments of a curve whose extent is known.
  void add_all(const Extent& extent, std::uint64_t segments);

  double rows() const;

 private:
  const SamplingRequest& request_;
  std::optional<Spacing> spacing_;  ///< nothing: each segment has its own rows
  Time first_, end_;                ///< of the keys
  Time made_;                       ///< end of the segments
  double length_ = 0;               ///< of these
  std::uint64_t segments_ = 0;
};

}  // namespace tcb
